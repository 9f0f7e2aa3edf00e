#pragma once
// Propensities of sampled reactions (the law is in network.hpp). Holds compiled expressions: one object per sampler and
// thread.
//
// Rates that contain t are sampled exactly by thinning (Lewis and Shedler 1979, Nav. Res. Logist. Q. 26, 403): a step
// is cut into windows, in a window events are drawn at a bound of the rate, and one that is drawn at time t happens
// with probability rate(t)/bound. Windows end where rates jump.
#include <cstdint>
#include <vector>

#include "rdme/laws.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

struct Window {
  double from = 0, to = 0;
};  // [s]

class Propensities {
 public:
  explicit Propensities(const Network& network);

  // References must outlive it, and stay of the same size.
  void bind(const Voxels& voxels, const State& state);

  void set_time(double t);  // [s]; expressions are evaluated there

  // Cuts the step from t to t + dt into windows in which the rates that contain t neither jump at a time that is the
  // same everywhere nor change much. Where there are no such rates: one window, from 0 to dt.
  const std::vector<Window>& windows(double t, double dt);
  // From now on a rate that contains t is given by its bound in the window.
  void set_window(const Window& window) {
    window_ = window;
    if (!network_.varying().empty()) laws_.set_parameters(network_, parameter_);
  }
  // Does an event that was drawn at the bound happen at time t? `rest` is uniform in [0, bound). True for a rate that
  // does not contain t. Throws base::RunError where the rate is above its bound.
  bool happens(int reaction, std::size_t voxel, double t, double rest, double bound) {
    return laws_.of_reaction[reaction].timed < 0 || thin(reaction, voxel, t, rest, bound);
  }

  // Events per second of a reaction in a voxel, at the numbers that the state holds now. Throws base::RunError, naming
  // the reaction, the voxel and the time, where the value is negative, infinite or not a number.
  double operator()(int reaction, std::size_t voxel) {
    const Quick& quick = quick_[reaction];
    if (quick.applies) {
      const std::int64_t* const n = count_ + voxel * species_;
      const double first = static_cast<double>(n[quick.first]) * quick.first_scale + quick.first_shift;
      const double second = static_cast<double>(n[quick.second]) * quick.second_scale + quick.second_shift;
      const double a = quick.constant * quick.volume[voxel * quick.stride] * (first * second);
      if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a, time_);
      return a;
    }
    const Law& law = laws_.of_reaction[reaction];
    if (!law.simple) return law.surface ? on_surface(reaction, voxel) : evaluate(reaction, voxel);
    double a = law.constant * available(law, voxel);
    if (law.order != 1) a *= volume_factor(law.order, volume_[voxel], inverse_volume_[voxel]);
    if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a, time_);
    return a;
  }

  // The other voxel of an event of a reaction on a surface; elsewhere the voxel itself. `rest` is uniform in [0,
  // propensity).
  std::size_t partner(int reaction, std::size_t voxel, double rest) const;

 private:
  // prod n (n-1) ... (n-nu+1) over stochastic reactants, times prod n^nu over deterministic ones; zero where short of
  // any.
  double available(const Law& law, std::size_t voxel) const {
    double product = 1.0;
    for (std::uint32_t f = law.first; f < law.last; ++f) {
      const Factor& factor = laws_.factors[f];
      const std::size_t at = voxel * species_ + factor.species;
      if (factor.stochastic) {
        product *= falling(count_[at], factor.count);
      } else {
        const double n = amount_[at] > 0.0 ? amount_[at] : 0.0;
        if (n < factor.taken) return 0.0;
        for (int k = 0; k < factor.count; ++k) product *= n;
      }
    }
    return product;
  }

  // Mass action of at most two whole molecules, without branches: each factor is n, n - 1, or 1 where there is none.
  struct Quick {
    bool applies = false;
    int first = 0, second = 0;  // species
    double first_scale = 0, first_shift = 1, second_scale = 0, second_shift = 1;
    double constant = 0;
    const double* volume = nullptr;  // V^(1-m) of voxel i at [i * stride]
    std::size_t stride = 0;
  };
  Quick make_quick(const Law& law) const;
  void bind_quick();
  void bind_surfaces();
  double on_surface(int reaction, std::size_t voxel);
  double on_pair(const Law& law, const Surface& surface, std::uint64_t pair, std::size_t voxel) const;
  double available(const Law& law, std::size_t voxel, bool beyond) const;

  double evaluate(int reaction, std::size_t voxel);
  double number(std::size_t voxel, int species) const;
  bool thin(int reaction, std::size_t voxel, double t, double rest, double bound);
  [[noreturn]] void refuse(int reaction, std::size_t voxel, double value, double t) const;

  // A timed reaction where one looks at it to choose windows.
  struct Lookout {
    int reaction;
    std::size_t voxel;
  };
  void place_lookouts();
  void prepare(const Lookout& lookout);
  void split(const Window& window, int depth);
  bool calm(const Lookout& lookout, const Window& window);

  const Network& network_;
  Laws laws_;
  std::size_t species_ = 0;
  const std::int64_t* count_ = nullptr;
  const double* amount_ = nullptr;
  const double* volume_ = nullptr;
  const double* parameter_ = nullptr;
  const Voxels* voxels_ = nullptr;
  std::vector<Quick> quick_;                // by reaction
  std::vector<const Surface*> surface_of_;  // by reaction
  std::vector<double> inverse_volume_;
  double time_ = 0;
  Window window_;
  std::vector<Window> windows_;
  std::vector<Lookout> lookouts_;
};

}  // namespace shmoo::rdme
