#pragma once
// Chemical Langevin dynamics (Gillespie 2000, J. Chem. Phys. 113, 297): smooth amounts in which every reaction, jump,
// exit and entry of expected number a h in a step h happens a h + sqrt(a h) N(0, 1) times. Right where a voxel holds
// some hundred molecules of a species or more.
//
// A step is weak trapezoidal (Anderson & Mattingly 2011, Commun. Math. Sci. 9, 301, with theta = 1/2), so that means
// and variances have errors of second order in h:
//   n* = n + sum_r nu_r X(a_r(n) h/2),    n' = n* + sum_r nu_r X([2 a_r(n*) - a_r(n)]^+ h/2),   X(m) = m + sqrt(m) N(0,
//   1).
// In a step reactions change no amount by more than a given part of it, and a tenth of what is in a voxel jumps.
//
// Between two voxels one number passes, with one noise for both directions: what leaves one enters the other. At zero:
// where all that would take from an amount in a stage takes more than there is, each of these takes its share of what
// is there, and no more; what they would give shrinks with it. So no amount is negative, nothing is created, and the
// ledger holds to round-off.
#include <memory>

#include "base/random.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::rdme {

class LangevinSolver {
 public:
  // `tolerance`: that part, as numerics.leap_tolerance. The network must outlive the solver.
  explicit LangevinSolver(const Network& network, double tolerance = scene::Numerics{}.leap_tolerance);
  ~LangevinSolver();

  // References must outlive the solver. Throws base::RunError where a rate is negative or not finite.
  void bind(const Voxels& voxels, State& state);

  // From time t to t + dt [s]; what other methods treat is constant. `step` addresses the random numbers and differs
  // between calls. Throws base::RunError where a rate law is negative or gives no finite number.
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace shmoo::rdme
