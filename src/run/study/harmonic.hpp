#pragma once
// The strongest oscillation in a course: least squares of m + a cos(w t) + b sin(w t), of all w the one that leaves
// least (Lomb 1976, "Least-squares frequency analysis of unequally spaced data", with a mean of its own as in
// Zechmeister & Kuerster 2009). Noise of variance s^2 in n records moves the amplitude by about s sqrt(2/n) only.
#include <span>

namespace shmoo::run {

struct Harmonic {
  double amplitude = 0;  // of the values' unit
  double period = 0;     // of the times' unit
};

// Of at least four values at ascending times; periods from two mean distances of records up to the whole course.
Harmonic strongest_harmonic(std::span<const double> time, std::span<const double> value);

}  // namespace shmoo::run
