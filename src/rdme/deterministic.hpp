#pragma once
// Deterministic reaction-diffusion of the amounts of deterministic species, by CVODE (SUNDIALS: Hindmarsh et al. 2005,
// ACM TOMS 31, 363): backward differentiation, Newton's method and GMRES with exact Jacobian products.
//
// Errors. Each step's error in an amount is at most `tolerance` times (the amount + 1 % of the species' largest amount
// in any voxel + 0.01 molecules). Amounts may fall below zero by that much and are left so: lifting them would create
// molecules. The sum of amounts and the ledger agree to round-off, whatever the tolerance.
#include <memory>
#include <vector>

#include "rdme/sampler.hpp"

namespace shmoo::rdme {

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
  void advance(double t, double dt, Process process);

  std::uint64_t evaluations() const;  // of the right-hand side, so far

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace shmoo::rdme
