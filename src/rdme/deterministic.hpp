#pragma once
// Deterministic reaction-diffusion of the amounts of deterministic species, by CVODE (SUNDIALS: Hindmarsh et al. 2005,
// ACM TOMS 31, 363): backward differentiation and Newton's method with the exact Jacobian. Its linear systems are
// solved by sparse factors (KLU: Davis & Palamadai Natarajan 2010, ACM TOMS 37, 36) where reactions may be stiff and
// factors fill in little, else by GMRES with exact products.
//
// Errors. Each step's error in an amount is at most `tolerance` times (the amount + 1 % of the species' largest amount
// in any voxel + 0.01 molecules). What falls below zero by that much is given back what took too much of it, by the
// network's own reactions and jumps, so that no negative amount is seen and nothing is created. The sum of amounts and
// the ledger agree to round-off, whatever the tolerance.
#include <memory>
#include <vector>

#include "rdme/sampler.hpp"

namespace shmoo::rdme {

// Functions of time and state whose changes of sign end an advance.
class RootWatch {
 public:
  virtual ~RootWatch() = default;
  virtual int roots() const = 0;
  virtual void distances(double t, const State& state, double* values) = 0;
};

class DeterministicSolver {
 public:
  // `tolerance` relative, > 0. The network must outlive the solver.
  DeterministicSolver(const Network& network, double tolerance);
  ~DeterministicSolver();

  // New geometry. References must outlive the solver.
  void bind(const Voxels& voxels, State& state);

  // From time t to t + dt [s] at frozen geometry; stochastic counts are constant and may be read by integrated
  // reactions. Goes on with the steps found before where nobody changed anything in between. Throws base::RunError
  // where a rate law gives no finite number or is negative, or where the integration cannot go on.
  // Returns the time reached: where a watched function has changed its sign, or t + dt.
  double advance(double t, double dt, Process process);

  // Whose functions are looked at from now on; null: nobody's. To be called before bind().
  void watch(RootWatch* watch);

  // Parameters were changed by someone else.
  void parameters_changed();

  std::uint64_t evaluations() const;  // of the right-hand side, so far

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace shmoo::rdme
