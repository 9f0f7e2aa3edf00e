#include "rdme/langevin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rdme/langevin_reactions.hpp"
#include "rdme/langevin_transport.hpp"

namespace shmoo::rdme {
namespace {

constexpr double part_that_jumps = 0.1;
constexpr double almost_all = 1 - 1e-14;  // so that round-off leaves nothing below zero

}  // namespace

struct LangevinSolver::Solver {
  Solver(const Network& of, double part) : network(of), tolerance(part), reactions(of), transport(of) {}

  const Network& network;
  double tolerance;
  LangevinReactions reactions;
  LangevinTransport transport;
  const Voxels* voxels = nullptr;
  State* state = nullptr;
  bool react = true, move = true;
  std::vector<double> start, effective, taken;  // as amounts: before a step; what rates are made of; what is taken

  double longest();
  void stage(double h, const StageAddress& address);
};

LangevinSolver::LangevinSolver(const Network& network, double tolerance)
    : solver_(std::make_unique<Solver>(network, tolerance)) {}

LangevinSolver::~LangevinSolver() = default;

void LangevinSolver::bind(const Voxels& voxels, State& state) {
  Solver& solver = *solver_;
  solver.voxels = &voxels;
  solver.state = &state;
  solver.reactions.bind(voxels, state);
  solver.transport.bind(voxels, state);
}

// [s] at the rates that stand now.
double LangevinSolver::Solver::longest() {
  double longest = std::numeric_limits<double>::infinity();
  if (react) longest = tolerance / reactions.fastest();
  if (move) longest = std::min(longest, part_that_jumps / transport.fastest());
  return longest;
}

// Everything happens as often as its rate says for h [s], but takes no more than there is.
void LangevinSolver::Solver::stage(double h, const StageAddress& address) {
  std::fill(taken.begin(), taken.end(), 0.0);
  if (react) reactions.draw(h, address, taken);
  if (move) transport.draw(h, address, effective, taken);
  for (std::size_t at = 0; at < taken.size(); ++at) {  // now the share of what is asked for
    const double there = std::max(0.0, almost_all * state->amount[at]);
    taken[at] = taken[at] > there ? there / taken[at] : 1.0;
  }
  if (react) reactions.apply(taken);
  if (move) transport.apply(taken);
}

void LangevinSolver::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  Solver& solver = *solver_;
  auto& amount = solver.state->amount;
  solver.react = process != Process::diffusion && solver.network.any_langevin();
  solver.move = process != Process::reactions;
  solver.taken.resize(amount.size());
  StageAddress address{key, step, 0};
  for (double left = dt; left > 0;) {
    solver.start = solver.effective = amount;
    if (solver.react) solver.reactions.evaluate(t + dt - left);
    const double parts = std::ceil(left / solver.longest() * (1 - 1e-12)), h = parts > 1 ? left / parts : left;
    solver.stage(0.5 * h, address);
    ++address.stage;
    for (std::size_t at = 0; at < amount.size(); ++at) {
      solver.effective[at] = std::max(0.0, 2 * amount[at] - solver.start[at]);
    }
    if (solver.react) solver.reactions.evaluate_again(t + dt - left + 0.5 * h);
    solver.stage(0.5 * h, address);
    ++address.stage;
    left = parts > 1 ? left - h : 0.0;
  }
}

}  // namespace shmoo::rdme
