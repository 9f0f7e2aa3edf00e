// Reactions in one voxel.
#include "run/verify/chemistry/experiment.hpp"
#include "run/verify/jump_chain.hpp"

namespace shmoo::run::verify {
namespace {

Experiment birth_and_death() {
  std::vector<ChainJump> jumps;
  for (std::size_t n = 0; n < 80; ++n) {
    jumps.push_back({n, n + 1, 20.0});
    if (n > 0) jumps.push_back({n, n - 1, double(n)});
  }
  return {row_of(1, species("X", 3) + reaction("nothing <-> X", "20 molecules/(m^3 s)", "1 1/s"), "1.5 s", "1 s"), "X",
          chain_law(80, jumps, 3, 1.5)};
}

Experiment batches() {
  std::vector<ChainJump> jumps;
  for (std::size_t n = 0; n < 120; ++n) {
    jumps.push_back({n, n + 5, 3.0});
    if (n > 0) jumps.push_back({n, n - 1, double(n)});
  }
  return {
      row_of(1, species("X", 0) + reaction("nothing -> 5 X", "3 molecules/(m^3 s)") + reaction("X -> nothing", "1 1/s"),
             "2 s", "1 s"),
      "X", chain_law(120, jumps, 0, 2.0)};
}

// 2 M <-> D from 30 M: k M (M - 1) and back.
Experiment dimers() {
  std::vector<ChainJump> jumps;
  for (std::size_t d = 0; d <= 15; ++d) {
    const double m = 30.0 - 2.0 * double(d);
    if (d < 15) jumps.push_back({d, d + 1, 0.02 * m * (m - 1.0)});
    if (d > 0) jumps.push_back({d, d - 1, 0.5 * double(d)});
  }
  return {row_of(1, species("M", 30) + species("D", 0) + reaction("2 M <-> D", "0.02 m^3/(s molecule)", "0.5 1/s"),
                 "0.4 s", "0.2 s"),
          "D", chain_law(16, jumps, 0, 0.4)};
}

Experiment binding() {
  std::vector<ChainJump> jumps;
  for (std::size_t c = 0; c <= 15; ++c) {
    if (c < 15) jumps.push_back({c, c + 1, 0.1 * (20.0 - double(c)) * (15.0 - double(c))});
    if (c > 0) jumps.push_back({c, c - 1, double(c)});
  }
  return {row_of(1,
                 species("A", 20) + species("B", 15) + species("C", 0) +
                     reaction("A + B <-> C", "0.1 m^3/(s molecule)", "1 1/s"),
                 "0.3 s", "0.1 s"),
          "C", chain_law(16, jumps, 0, 0.3)};
}

// Schloegl's model in our convention: 2 X -> 3 X at k1 n (n - 1), 3 X -> 2 X at k2 n (n - 1)(n - 2), and birth and
// death.
double schloegl_up(double n) { return 0.15 * n * (n - 1.0) + 45.0; }
double schloegl_down(double n) { return 0.0015 * n * (n - 1.0) * (n - 2.0) + 5.0 * n; }

Experiment schloegl(const std::string& until, std::vector<double> law, int realisations) {
  Experiment experiment{row_of(1,
                               species("X", 25) + reaction("2 X -> 3 X", "0.15 m^3/(s molecule)") +
                                   reaction("3 X -> 2 X", "0.0015 m^6/(s molecule^2)") +
                                   reaction("nothing <-> X", "45 molecules/(m^3 s)", "5 1/s"),
                               until, "0.5 s"),
                        "X", std::move(law)};
  experiment.realisations = realisations;
  return experiment;
}

constexpr std::size_t schloegl_states = 160;

Experiment schloegl_transient() {
  std::vector<ChainJump> jumps;
  for (std::size_t k = 0; k < schloegl_states; ++k) {
    jumps.push_back({k, k + 1, schloegl_up(double(k))});
    if (k > 0) jumps.push_back({k, k - 1, schloegl_down(double(k))});
  }
  return schloegl("1 s", chain_law(schloegl_states, jumps, 25, 1.0), 4000);
}

// It forgets its start within a second.
Experiment schloegl_stationary() {
  return schloegl("15 s", balanced_law(schloegl_states, schloegl_up, schloegl_down), 1000);
}

// Births at k(t) are Poisson with the integral of k as mean.
Experiment births_in_time(const std::string& rate, double mean) {
  return {row_of(1,
                 "[parameters]\nk = \"1 molecule/(m^3 s)\"\nw = \"2.5 1/s\"\nt1 = \"3.3 s\"\nt2 = \"3.301 s\"\n" +
                     species("X", 0) + custom_reaction("nothing -> X", rate),
                 "5 s", "1.7 s"),
          "X", poisson_law(mean, 100)};
}

Experiment sine() { return births_in_time("k*(4 + 3*sin(w*t))", 20.0 + 3.0 / 2.5 * (1.0 - std::cos(12.5))); }
Experiment pulse() { return births_in_time("t > t1 && t < t2 ? 9000*k : 2*k", 9.0 + 2.0 * 4.999); }

}  // namespace

std::vector<NamedExperiment> reactions_alone() {
  return {{"birth-death", "nothing <-> X, on its way to Poisson", birth_and_death},
          {"batches", "nothing -> 5 X -> ..., immigration in batches", batches},
          {"dimers", "2 M <-> D on its way to equilibrium", dimers},
          {"binding", "A + B <-> C on its way to equilibrium", binding},
          {"schloegl", "2 X <-> 3 X, nothing <-> X: broad and of two peaks", schloegl_transient},
          {"schloegl-stationary", "the same, long after the start", schloegl_stationary},
          {"sine", "births at a rate that swings in time", sine},
          {"pulse", "births at a rate with a pulse of a millisecond", pulse}};
}

}  // namespace shmoo::run::verify
