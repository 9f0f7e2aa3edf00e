#pragma once
// The ordinary differential equations of the deterministic species at frozen geometry:
//   dn_i/dt = sum_j (rate_ji n_j - rate_ij n_i) + entry_i - exit_i n_i + sum_r (net change) V_i v_r,
// with the jump rates of voxels.hpp, so that for first-order networks this is the mean of every exact sampler.
//
// Four books per species are integrated along with it (created, destroyed, entered, left). The law that amounts equal
// what the books say is linear, and backward differences with Krylov corrections keep linear laws to round-off at any
// tolerance.
#include <cstdint>
#include <span>
#include <vector>

#include "rdme/laws.hpp"
#include "rdme/sampler.hpp"
#include "rdme/sparse_jacobian.hpp"

namespace shmoo::rdme {

class RateSystem {
 public:
  enum Book { created, destroyed, entered, left, books };

  explicit RateSystem(const Network& network);

  // References must outlive it. Throws base::RunError where a rate is negative or not finite.
  void bind(const Voxels& voxels, const State& state);
  void act_on(Process process);

  std::size_t size() const { return unknowns() + books * species_.size(); }
  std::size_t unknowns() const { return voxels_ ? voxels_->size() * species_.size() : 0; }
  const std::vector<int>& species() const { return species_; }  // the deterministic ones, ascending

  // y holds amounts [voxel * species().size() + d], then books [unknowns() + book * species().size() + d], in
  // molecules.
  void derivative(double t, const double* y, double* dy);                                  // [molecules/s]
  void derivative_along(double t, const double* y, const double* direction, double* out);  // Jacobian times direction

  // The Jacobian at y as a list of entries that are summed; where they are does not depend on y. Without y: zeros.
  void jacobian(double t, const double* y, std::vector<Entry>& entries);

  // Lifts amounts below zero, which the integration leaves within its tolerance, by undoing what took too much: events
  // of reactions, else jumps from nearby, else exits, else jumps from anywhere. Amounts and books change together, so
  // that every conservation law of the network holds after it as before; an amount that nothing took from stays.
  void lift_negatives(double* y) const;

  // Adds the first moment in [from, to] behind each jump of a rate at a time that is the same everywhere.
  void add_steps(double from, double to, std::vector<double>& moments);
  bool reads_time() const { return !laws_.timed.empty(); }

  // Throws base::RunError, naming reaction, voxel and time, where an expression is so far below zero at y that a time
  // dt of it would take more than `allowed` molecules.
  void check_signs(double t, double dt, const double* y, double allowed);

 private:
  struct Row {
    const JumpGraph* graph = nullptr;
    std::vector<double> rate;  // [pairs] [1/s]
  };

  void spread(const double* y, double* dy) const;
  void exchange(const double* y, double* dy, double entries) const;
  double frozen(int species, std::size_t voxel) const;  // of a species that is not integrated
  double frozen_factor(const Factor& factor, std::size_t voxel) const;
  double turn(const Law& law, std::size_t voxel, const double* y) const;
  double rate(const Law& law, int reaction, std::size_t voxel, const double* y);
  double rate_along(const Law& law, int reaction, std::size_t voxel, const double* y, const double* direction);
  double expression_rate(const Law& law, int reaction, std::size_t voxel, const double* y);
  void transport_entries(std::vector<Entry>& entries) const;
  void lift(std::size_t voxel, std::size_t place, double* y) const;
  void lift_by_all(std::size_t place, double* y) const;
  void add(int reaction, std::size_t voxel, double rate, double* dy) const {
    add(network_.reactions()[std::size_t(reaction)], voxel, voxel, rate, dy);
  }
  void add(const Reaction& reaction, std::size_t voxel, std::size_t partner, double rate, double* dy) const;
  struct PairRate {
    double value, slope;
  };
  PairRate pair_rate(const Law& law, double coefficient, std::size_t voxel, std::size_t other, const double* y,
                     const double* direction) const;
  void add_surfaces(const double* y, const double* direction, double* dy) const;  // no direction: null
  void pair_entries(const Reaction& reaction, const Law& law, double k, std::size_t i, std::size_t j, const double* y,
                    std::vector<Entry>& entries);
  void surface_entries(const double* y, std::vector<Entry>& entries);

  const Network& network_;
  Laws laws_;
  std::vector<int> species_;   // deterministic
  std::vector<int> place_of_;  // by species: place in species_, -1 for stochastic ones
  const Voxels* voxels_ = nullptr;
  const State* state_ = nullptr;
  std::vector<Row> rows_;  // by place
  bool diffusion_ = true, reactions_ = true;
  std::vector<double> shifted_, direction_;
};

}  // namespace shmoo::rdme
