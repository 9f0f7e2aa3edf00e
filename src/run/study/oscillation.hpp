#pragma once
// What of a course swings, and how fast. Times ascend.
#include <span>

namespace shmoo::run {

// Half of what lies between the extremes.
double half_range(std::span<const double> value);

// From the first crossing of the middle between the extremes to the next one in the same direction, straight lines
// between values; infinite where no period is whole.
double first_period(std::span<const double> time, std::span<const double> value);

struct Harmonic {
  double amplitude = 0;  // of the values' unit
  double period = 0;     // of the times' unit
};

// The strongest oscillation: least squares of m + a cos(w t) + b sin(w t), of all w the one that leaves least (Lomb
// 1976, "Least-squares frequency analysis of unequally spaced data", with a mean of its own as in Zechmeister &
// Kuerster 2009). Noise of variance s^2 in n records moves the amplitude by about s sqrt(2/n) only. Periods are sought
// from two mean distances of records up to the whole course; not a number for fewer than four values.
Harmonic strongest_harmonic(std::span<const double> time, std::span<const double> value);

}  // namespace shmoo::run
