// Spectra of a fluctuating fluid at rest: the structure factor at small k is kT/(m c0^2) (Landau & Lifshitz,
// Statistical Physics, section 112), transverse modes have the variance kT/(m N) and decay at the rate nu k^2.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <vector>

#include "../scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

using Complex = std::complex<double>;
template <int D>
using Waves = std::array<Complex, std::size_t(D)>;

struct Spectra {
  double structure = 0;  // S(k) m c0^2/kT
  double variance = 0;   // of transverse modes over kT/(m N)
  double decay = 0;      // their rate over nu k^2
};

// Sums over the fluid of e^(ikx) and of a transverse velocity times that, along each axis.
template <int D>
void transform(const Fluid<D>& fluid, double k, Waves<D>& density, Waves<D>& transverse) {
  density = transverse = {};
  for (const auto i : fluid.state().rows.fluid()) {
    for (int a = 0; a < D; ++a) {
      const Complex wave = std::polar(1.0, -k * fluid.particles().position[i][a]);
      density[std::size_t(a)] += wave;
      transverse[std::size_t(a)] += wave * fluid.velocity(i)[(a + 1) % D];
    }
  }
}

template <int D>
Spectra measure(int across, double viscosity, double speed, double until) {
  auto scene = box_scene(D, 1.0, 1.0 / across, viscosity);
  scene.effects.thermal_noise = true;
  scene.effects.transport_velocity = false;
  scene.flow.thermal_energy = 1e-4 * std::pow(across, -D);  // thermal speed of 0.01 a component
  scene.flow.reference_speed = speed;
  auto fluid = make_fluid<D>(scene);
  const double k = 2.0 * std::numbers::pi, rate = viscosity * k * k, n = double(fluid.state().rows.fluid().size());
  const double kT = fluid.scales().thermal_energy, m = fluid.scales().mass, c0 = fluid.scales().sound_speed;
  const double every = 0.1 / rate, lag = 0.5 / rate;
  fluid.advance(5.0 / rate);
  std::vector<Waves<D>> course;
  Spectra result;
  while (fluid.time() < until / rate) {
    fluid.advance(fluid.time() + every);
    Waves<D> density;
    transform<D>(fluid, k, density, course.emplace_back());
    for (const auto& wave : density) result.structure += std::norm(wave) / n / D * m * c0 * c0 / kT;
    for (const auto& wave : course.back()) result.variance += std::norm(wave) / n / D * m / kT;
  }
  const auto later = std::size_t(std::lround(lag / every));
  double product = 0.0, square = 0.0;
  for (std::size_t t = 0; t + later < course.size(); ++t) {
    for (std::size_t a = 0; a < std::size_t(D); ++a) {
      product += (course[t][a] * std::conj(course[t + later][a])).real();
      square += 0.5 * (std::norm(course[t][a]) + std::norm(course[t + later][a]));
    }
  }
  result.structure /= double(course.size());
  result.variance /= double(course.size());
  result.decay = -std::log(product / square) / (lag * rate);
  fmt::print(
      "{}-D, {} across, kT/(m c0^2) {:.1e}, gamma dt {:.2f}: S m c0^2/kT {:.3f}, transverse variance {:.3f}, "
      "decay {:.3f}\n",
      D, across, kT / (m * c0 * c0), fluid.scales().friction * fluid.dt(), result.structure, result.variance,
      result.decay);
  return result;
}

}  // namespace

// Chance is about 2 % of the structure factor; it carries the kernel's width too, about 3 % at this wave length.
void expect_spectra(const Spectra& spectra) {
  EXPECT_NEAR(spectra.structure, 1.0, 0.05);
  EXPECT_NEAR(spectra.variance, 1.0, 0.05);
  EXPECT_NEAR(spectra.decay, 1.0, 0.05);
}

TEST(NoiseSpectra, In2D) { expect_spectra(measure<2>(24, 0.005, 0.0, 1500.0)); }

TEST(NoiseSpectra, In3D) { expect_spectra(measure<3>(12, 0.005, 0.0, 300.0)); }

}  // namespace shmoo::hydro::testing
