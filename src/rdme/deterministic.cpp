#include "rdme/deterministic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "base/error.hpp"
#include "rdme/integrator.hpp"
#include "rdme/rate_system.hpp"

namespace shmoo::rdme {
namespace {

constexpr double share_of_largest = 0.01, share_of_molecule = 0.01;  // of the absolute tolerance
constexpr double stiff = 100;                                        // times a reaction could run within an advance
constexpr double products = 100;      // with the Jacobian, whose work may go into its factors
constexpr double least_step = 1e-18;  // of an advance; what blows up would end in ever shorter ones
constexpr long most_steps = 1000000;  // of one advance

}  // namespace

struct DeterministicSolver::Solver {
  Solver(const Network& of, double relative) : network(of), tolerance(relative), system(of) {
    if (!(tolerance > 0 && tolerance < 1)) {
      throw base::InputError(
          fmt::format("the tolerance of the deterministic chemistry is {}; it must be between 0 and 1", tolerance));
    }
    for (const Reaction& reaction : network.reactions()) {
      for (int s : reaction.reads) reads_counts |= !reaction.stochastic && network.stochastic(s);
    }
  }

  const Network& network;
  double tolerance;
  RateSystem system;
  std::unique_ptr<Integrator> integrator;  // made for `process`; null: to be made
  SparseJacobian jacobian;                 // where it is solved directly
  std::vector<Entry> entries;              // of it
  std::exception_ptr error;
  const Voxels* voxels = nullptr;
  State* state = nullptr;
  RootWatch* watch = nullptr;
  bool reads_counts = false;  // integrated reactions read stochastic counts
  std::uint64_t evaluations = 0;

  // What the last advance left behind; it goes on from there if all of it still holds.
  bool fresh = true;
  double reached = 0;
  Process process = Process::both;
  std::vector<double> amounts;       // as written to the state
  std::vector<std::int64_t> counts;  // as they stood
  std::vector<double> books;         // as already in the ledger
  std::vector<double> lifted;        // amounts and books without negative amounts

  void create(double t, double dt);
  bool may_be_stiff(double t, double dt);
  bool solve_directly(double t, double dt);
  bool goes_on(double t) const;
  void start(double t, double dt);
  void step(double t, double dt);
  double pass(double t, double until);
  void write_amounts(const double* y);
  void write();
};

namespace {

// CVODE calls these; what they throw waits until CVODE has returned.
template <class Work>
int guarded(std::exception_ptr& error, const Work& work) {
  try {
    work();
    return 0;
  } catch (...) {
    error = std::current_exception();
    return -1;
  }
}

void keep_message(int, const char*, const char*, char* message, void* integrator) {
  static_cast<Integrator*>(integrator)->message = message;
}

}  // namespace

// Factors are worth what they cost where a reaction could run many times within dt, as it would if every species were
// as abundant as the most abundant one.
bool DeterministicSolver::Solver::may_be_stiff(double t, double dt) {
  if (!network.any_integrated() || process == Process::diffusion) return false;
  const double most = *std::ranges::max_element(state->amount);
  const std::vector<double> crowd(system.size(), std::max(1.0, most));
  system.act_on(Process::reactions);
  const bool known = guarded(error, [&] { system.jacobian(t, crowd.data(), entries); }) == 0;
  system.act_on(process);
  if (!known) return true;  // a law that is undefined for such a crowd
  double fastest = 0;
  for (const Entry& entry : entries) {
    if (entry.row == entry.column) fastest = std::max(fastest, std::abs(entry.value));
  }
  return fastest * dt >= stiff;
}

bool DeterministicSolver::Solver::solve_directly(double t, double dt) {
  if (!may_be_stiff(t, dt)) return false;
  system.jacobian(t, nullptr, entries);
  jacobian.learn(system.size(), entries);
  return jacobian.factors_within(products);
}

void DeterministicSolver::Solver::create(double begin, double dt) {
  integrator = std::make_unique<Integrator>(system.size(), solve_directly(begin, dt) ? &jacobian : nullptr);
  void* const memory = integrator->memory;
  const auto derivative = [](double t, N_Vector y, N_Vector dy, void* self) {
    Solver& solver = *static_cast<Solver*>(self);
    ++solver.evaluations;
    return guarded(solver.error, [&] { solver.system.derivative(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy)); });
  };
  const auto along = [](N_Vector v, N_Vector out, double t, N_Vector y, N_Vector, void* self, N_Vector) {
    Solver& solver = *static_cast<Solver*>(self);
    return guarded(solver.error, [&] {
      solver.system.derivative_along(t, N_VGetArrayPointer(y), N_VGetArrayPointer(v), N_VGetArrayPointer(out));
    });
  };
  const auto matrix = [](double t, N_Vector y, N_Vector, SUNMatrix out, void* self, N_Vector, N_Vector, N_Vector) {
    Solver& solver = *static_cast<Solver*>(self);
    return guarded(solver.error, [&] {
      solver.system.jacobian(t, N_VGetArrayPointer(y), solver.entries);
      copy_structure(solver.jacobian, out);
      solver.jacobian.fill(solver.entries, SUNSparseMatrix_Data(out));
    });
  };
  N_VConst(0.0, integrator->y);
  N_VConst(1.0, integrator->allowed);
  CVodeInit(memory, derivative, 0.0, integrator->y);
  CVodeSetUserData(memory, this);
  CVodeSetErrHandlerFn(memory, keep_message, integrator.get());
  CVodeSVtolerances(memory, tolerance, integrator->allowed);
  CVodeSetLinearSolver(memory, integrator->linear, integrator->matrix);
  if (integrator->matrix) {
    CVodeSetJacFn(memory, matrix);
  } else {
    CVodeSetJacTimes(memory, nullptr, along);
  }
  CVodeSetMaxNumSteps(memory, most_steps);
  if (!watch || watch->roots() == 0) return;
  CVodeRootInit(memory, watch->roots(), [](double t, N_Vector y, double* values, void* self) {
    Solver& solver = *static_cast<Solver*>(self);
    return guarded(solver.error, [&] {
      solver.write_amounts(N_VGetArrayPointer(y));
      solver.watch->distances(t, *solver.state, values);
    });
  });
  CVodeSetNoInactiveRootWarn(memory);
}

bool DeterministicSolver::Solver::goes_on(double t) const {
  return !fresh && std::abs(t - reached) <= 1e-12 * std::abs(t) && amounts == state->amount &&
         (!reads_counts || counts == state->count);
}

void DeterministicSolver::Solver::start(double t, double dt) {
  const std::vector<int>& species = system.species();
  const std::size_t stride = species.size(), unknowns = system.unknowns();
  double* const y = N_VGetArrayPointer(integrator->y);
  double* const allowed = N_VGetArrayPointer(integrator->allowed);
  for (std::size_t d = 0; d < stride; ++d) {
    double largest = 0;
    for (std::size_t i = 0; i < voxels->size(); ++i) {
      y[i * stride + d] = state->amount[i * state->species + species[d]];
      largest = std::max(largest, std::abs(y[i * stride + d]));
    }
    const double molecules = tolerance * (share_of_largest * largest + share_of_molecule);
    for (std::size_t at = d; at < unknowns; at += stride) allowed[at] = molecules;
  }
  // Books follow from the amounts, so they need no watch of their own.
  std::fill(y + unknowns, y + system.size(), 0.0);
  std::fill(allowed + unknowns, allowed + system.size(), 1e100);
  books.assign(system.size() - unknowns, 0.0);
  system.check_signs(t, dt, y, tolerance);
  CVodeReInit(integrator->memory, t, integrator->y);
  CVodeSetMinStep(integrator->memory, least_step * dt);
  CVodeSVtolerances(integrator->memory, tolerance, integrator->allowed);
}

void DeterministicSolver::Solver::step(double t, double dt) {
  double now = t;
  error = nullptr;
  if (system.reads_time()) CVodeSetStopTime(integrator->memory, t + dt);  // what is beyond may be another law
  const int flag = CVode(integrator->memory, t + dt, integrator->y, &now, CV_NORMAL);
  if (error) std::rethrow_exception(error);
  if (flag < 0) {
    throw base::RunError(
        fmt::format("deterministic chemistry cannot go on from t = {} s: {} Reactions that blow up, or rates "
                    "many orders of magnitude apart, are the usual reasons.",
                    now, integrator->message));
  }
  system.check_signs(now, dt, N_VGetArrayPointer(integrator->y), tolerance);
  reached = flag == CV_ROOT_RETURN ? now : t + dt;
}

void DeterministicSolver::Solver::write_amounts(const double* y) {
  const std::vector<int>& species = system.species();
  const std::size_t stride = species.size();
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    for (std::size_t d = 0; d < stride; ++d) state->amount[i * state->species + species[d]] = y[i * stride + d];
  }
}

void DeterministicSolver::Solver::write() {
  const std::vector<int>& species = system.species();
  const std::size_t stride = species.size();
  const double* const reached_y = N_VGetArrayPointer(integrator->y);
  lifted.assign(reached_y, reached_y + system.size());
  system.lift_negatives(lifted.data());
  const double* const y = lifted.data();
  write_amounts(y);
  const double* const book = y + system.unknowns();
  for (std::size_t d = 0; d < stride; ++d) {
    Account<double>& account = state->ledger.amounts[species[d]];
    const auto since = [&](RateSystem::Book which) { return book[which * stride + d] - books[which * stride + d]; };
    account.created += since(RateSystem::created);
    account.destroyed += since(RateSystem::destroyed);
    account.entered += since(RateSystem::entered);
    account.left += since(RateSystem::left);
  }
  books.assign(book, book + books.size());
}

DeterministicSolver::DeterministicSolver(const Network& network, double tolerance)
    : solver_(std::make_unique<Solver>(network, tolerance)) {}

DeterministicSolver::~DeterministicSolver() = default;

std::uint64_t DeterministicSolver::evaluations() const { return solver_->evaluations; }

void DeterministicSolver::bind(const Voxels& voxels, State& state) {
  Solver& solver = *solver_;
  solver.voxels = &voxels;
  solver.state = &state;
  const std::size_t before = solver.system.size();
  solver.system.bind(voxels, state);
  if (solver.integrator && (solver.integrator->matrix || solver.system.size() != before)) solver.integrator.reset();
  solver.fresh = true;
}

double DeterministicSolver::advance(double t, double dt, Process process) {
  Solver& solver = *solver_;
  if (solver.system.species().empty() || solver.voxels->size() == 0 || dt <= 0) return t + dt;
  solver.system.act_on(process);
  if (!solver.integrator || process != solver.process) {
    solver.process = process;
    solver.create(t, dt);
    solver.fresh = true;
  }
  // From jump to jump of rates that contain t: no step reaches across, so that no pulse is too short to be seen.
  std::vector<double> moments;
  solver.system.add_steps(t, t + dt, moments);
  std::ranges::sort(moments);
  double from = t;
  for (const double moment : moments) {
    if (moment <= from) continue;
    const double before = std::nextafter(moment, from);
    if (before > from && solver.pass(from, before) < before) return solver.reached;
    from = moment;
    solver.fresh = true;
  }
  return from < t + dt ? solver.pass(from, t + dt) : t + dt;
}

double DeterministicSolver::Solver::pass(double t, double until) {
  if (!goes_on(t)) start(t, until - t);
  fresh = true;  // until it has gone well
  step(t, until - t);
  write();
  fresh = false;
  amounts = state->amount;
  if (reads_counts) counts = state->count;
  return reached;
}

void DeterministicSolver::watch(RootWatch* watch) { solver_->watch = watch; }

void DeterministicSolver::parameters_changed() { solver_->fresh = true; }

}  // namespace shmoo::rdme
