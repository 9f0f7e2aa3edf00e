#pragma once
// What the user said, in SI units and with names resolved to indices. Computes nothing. Lengths [m], times [s], masses [kg],
// amounts in molecules (pure numbers). In a scene of fewer than three dimensions `depth` is what one particle stands for in
// the missing ones: [m] in 2-D, [m^2] in 1-D.
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "scene/quantity.hpp"
#include "scene/solid.hpp"

namespace shmoo::scene {

using Point = std::array<double, 3>;  // [m]; unused trailing components are 0

// ---- geometry ------------------------------------------------------------------------------------------------------
struct Shape;
using ShapePointer = std::shared_ptr<const Shape>;

struct BoxShape { Point lower{}, upper{}; };
struct BallShape { Point center{}; double radius = 0; };                 // "disk" in 2-D
struct ShellShape { Point center{}; double inner = 0, outer = 0; };      // "ring" in 2-D; radii
struct HalfSpaceShape { Point point{}, normal{}; };                      // the side the normal points away from is inside
struct PolygonShape { std::vector<std::array<double, 2>> corners; };     // 2-D; even-odd rule
struct UnionShape { std::vector<ShapePointer> parts; };
struct DifferenceShape { ShapePointer from, without; };

struct Shape {
  std::variant<BoxShape, BallShape, ShellShape, HalfSpaceShape, PolygonShape, UnionShape, DifferenceShape> form;
};

// True where the point lies inside or on the lower side of the boundary (boxes are half-open: lower <= x < upper).
bool contains(const Shape& shape, const Point& point, int dimension);

enum class MaterialType {
  fluid,   // flows where the flow is on
  wall,    // rigid; no-slip for the fluid
  still,   // never moves and does not act on a fluid's motion: gels, slabs, wells of pure chemistry
  solid,   // elastic: see Elastic
};

// velocity + angular_velocity x (position - center) + strain_rate (position - center), each axis by itself, until a
// time. In 2-D the angular velocity has a z component only.
struct RigidMotion {
  Point velocity{};          // [m/s]
  Point angular_velocity{};  // [1/s]
  Point center{};            // [m]
  Point strain_rate{};       // [1/s]
  double until = std::numeric_limits<double>::infinity();  // [s]
};

struct Material {
  std::string name;
  MaterialType type = MaterialType::fluid;
  double density = 0;                           // [kg/m^3], solids and fluids; 0 where the scene has no flow
  double viscosity = 0;                         // [Pa s], dynamic shear viscosity, fluids
  double bulk_viscosity = 0;                    // [Pa s], zeta, fluids
  std::optional<RigidMotion> motion;            // walls, and the held part of solids: particles move
  std::optional<RigidMotion> surface_motion;    // walls: the surface slides, particles stay
  std::optional<Elastic> elastic{};             // solids
};

struct Region {
  ShapePointer shape;
  int material = 0;  // index into Scene::materials
  base::Location where;
};

// ---- domain --------------------------------------------------------------------------------------------------------
// wall: no-slip for the fluid and reflecting for species; slip: a mirror, a wall without friction; inlet and outlet: the
// fluid passes, and particles enter and leave
enum class SideType { periodic, wall, reflect, slip, inlet, outlet };

struct Side {
  SideType type = SideType::reflect;
  Point velocity{};                  // [m/s] sliding velocity of a wall side
  std::vector<Quantity> inflow{};    // [m/s] of what enters at an inlet, one per axis; formulas see x, y, z and t
  std::optional<double> pressure{};  // [Pa] held at an outlet, or at an inlet without a velocity
  std::vector<std::pair<int, double>> species{};  // of what enters: species, concentration [molecules/m^3]; others 0
};

inline bool is_open(SideType type) { return type == SideType::inlet || type == SideType::outlet; }
// Whether the fluid rubs on it. A side that only reflects species is a wall to a fluid.
inline bool has_friction(SideType type) { return type == SideType::wall || type == SideType::reflect; }

// Where fluid particles stand closer together than elsewhere.
struct Refinement {
  ShapePointer shape;
  double spacing = 0;  // [m]
  base::Location where;
};

struct Domain {
  Point lower{}, upper{};                      // [m]
  double spacing = 0;                          // [m]
  std::array<std::array<Side, 2>, 3> sides{};  // [axis][0 = min, 1 = max]
  int material = -1;                           // what fills all that no region covers; -1: nothing
  double jitter = 0;                           // random displacement of each starting position, in spacings (uniform in +-jitter per axis)
  std::vector<Refinement> refinements{};
};

// ---- chemistry -----------------------------------------------------------------------------------------------------
// langevin: smooth amounts with the noise of the chemical Langevin equation; automatic: rules decide before anything runs
enum class SpeciesMethod { deterministic, stochastic, langevin, automatic };

struct Species {
  std::string name;
  std::vector<int> homes;  // materials, ascending
  double diffusivity = 0;  // [m^2/s]
  SpeciesMethod method = SpeciesMethod::stochastic;
  base::Location where{};
  int compartment = -1;  // of a well-mixed scene, where it lives instead of `homes`
};

// Of a well-mixed scene, which has no particles: all of it is one well, in which each species has the volume of its
// compartment.
struct Compartment {
  std::string name;
  double volume = 0;  // [m^3]
};

// A name that stands for a formula, evaluated wherever it is read.
struct Definition {
  std::string name, expression;
};

// When `trigger` turns from false to true, and `delay` later, the assignments are made at once (SBML L3V2 section 4.11).
struct Assignment {
  std::string target, expression;  // a species or a parameter
};
struct Event {
  std::string name;
  std::string trigger;    // true where not zero
  std::string delay;      // [s]; empty: none
  std::string priority;   // of events at the same time the largest goes first; empty: whenever
  bool initially = true;  // what the trigger counts as before the start
  bool persistent = true; // made even if the trigger turns false before the delay is over
  bool values_at_trigger = true;  // assignments are evaluated when the trigger turns true; else when they are made
  std::vector<Assignment> assignments;
  base::Location where{};
};

// Initial amount of a species: a concentration, or a total count spread uniformly over the volume it covers.
// Later entries overwrite earlier ones where they overlap.
struct Initial {
  int species = 0;
  int material = -1;                    // only in this material; -1: in all homes
  ShapePointer shape;                   // only inside; null: everywhere
  Quantity concentration;               // [molecules/m^3]
  std::optional<double> count;          // molecules in total; then `concentration` is not used
};

struct Term { int species = 0; int count = 1; };

// One direction of a reaction. v = rate constant * prod C^nu, or the expression; reaction events per volume and time.
struct Reaction {
  std::string name;             // as written, with "(forward)" or "(backward)" where both exist
  std::vector<Term> reactants;  // merged by species, ascending
  std::vector<Term> products;
  double rate_constant = 0;     // [(molecules/m^3)^(1-m)/s], m = sum of reactant counts
  std::string expression;       // custom law for v [molecules/(m^3 s)], where not empty
  std::vector<int> materials;   // runs only in these; empty: wherever all its species live
  std::array<int, 2> surface{-1, -1};  // runs where these two materials meet, between neighbouring voxels
  bool per_volume = true;              // else the expression gives events per time [molecules/s], in a well-mixed scene
};

enum class BoundaryType { reflect, fixed, flux, absorb };

struct SpeciesBoundary {
  int species = 0;
  int axis = -1, side = 0;  // a side of the domain, or
  int material = -1;        // the surface of a material
  BoundaryType type = BoundaryType::reflect;
  double value = 0;         // fixed: [molecules/m^3]; flux into the domain: [molecules/(m^2 s)]
  base::Location where;
};

// ---- flow ----------------------------------------------------------------------------------------------------------
// A sponge: dq/dt = -(q - target) phi(x)/relaxation_time, phi rises from 0 to 1 across the zone along the flow (thesis
// Eq. 2.36 with B = 1 and n = ramp_exponent; phi = 1 everywhere for exponent 0).
struct Inflow {
  ShapePointer zone;                            // a box
  std::optional<Point> velocity;                // [m/s]
  std::vector<std::pair<int, double>> species;  // species, target concentration [molecules/m^3]
  std::optional<double> relaxation_time;        // [s]; derived where absent
  int ramp_exponent = 0;
};

// A species makes the fluid lighter or heavier (Boussinesq): acceleration -expansion (C - reference) gravity.
struct Buoyancy {
  int species = 0;
  double expansion = 0;  // [m^3/molecule]
  double reference = 0;  // [molecules/m^3]
};

struct Flow {
  Point gravity{};                                 // [m/s^2], of buoyancy
  std::vector<Buoyancy> buoyancy;
  std::optional<Point> body_force;                 // [m/s^2], acceleration
  std::vector<Quantity> initial_velocity;          // [m/s], one per axis; empty: at rest
  std::optional<double> reference_speed;           // [m/s]
  std::optional<double> reference_length;          // [m]
  std::optional<double> sound_speed;               // [m/s]
  double density_variation = 0.01;                 // allowed
  double background_pressure = 0;                  // [Pa]
  std::optional<double> thermal_energy;            // [J], kT
};

// What the scene calls for. Anything false is not computed at all.
struct Effects {
  bool flow = false;               // the fluid moves
  bool viscosity = true;
  bool density_diffusion = true;
  bool transport_velocity = true;  // shifting towards even spacing
  bool bounce_back = true;         // guard of walls against what runs into them
  bool closed_room = true;         // what drifts from the volume of a closed room is taken back
  bool thermal_noise = false;
  bool species_advection = true;   // the flow carries species (also the exchange under the transport velocity)
};

struct EffectKey { const char* name; bool Effects::*on; };
inline constexpr std::array<EffectKey, 8> effect_keys{{{"flow", &Effects::flow},
                                                       {"viscosity", &Effects::viscosity},
                                                       {"density_diffusion", &Effects::density_diffusion},
                                                       {"transport_velocity", &Effects::transport_velocity},
                                                       {"bounce_back", &Effects::bounce_back},
                                                       {"closed_room", &Effects::closed_room},
                                                       {"thermal_noise", &Effects::thermal_noise},
                                                       {"species_advection", &Effects::species_advection}}};

// ---- how -----------------------------------------------------------------------------------------------------------
enum class Kernel { lucy, cubic_spline, quintic_spline, wendland_c2 };
enum class PressureForm { automatic, symmetric, difference, riemann };
enum class DensityForm { automatic, continuity, summation };
enum class WallForm { automatic, extrapolated, second_order };  // what a fluid sees in a wall
enum class ViscousStep { automatic, explicit_step, implicit_step };
enum class Sampler { direct, composition_rejection, split, tau_leaping, automatic };  // automatic: rules decide
enum class Splitting { lie, strang };
enum class Limits { refuse, warn };  // what a run does that is beyond a limit that makes its result worthless

struct Numerics {
  Kernel kernel = Kernel::wendland_c2;
  double reach = 3.0;                            // kernel support in spacings
  PressureForm pressure = PressureForm::automatic;
  DensityForm density = DensityForm::automatic;
  WallForm walls = WallForm::automatic;
  ViscousStep viscous_step = ViscousStep::automatic;
  int shepard_every = 0;                         // steps after which densities are renormalised; 0: never
  double courant = 0.25;                         // of hs/(c0 + U)
  Sampler sampler = Sampler::composition_rejection;
  Splitting splitting = Splitting::strang;
  std::optional<double> splitting_step;          // [s]; derived where absent
  double tolerance = 1e-6;                       // relative, of the deterministic chemistry
  double leap_tolerance = 0.03;                  // epsilon of tau-leaping: relative change of a propensity in a leap
  double splitting_tolerance = 1e-3;             // relative error of amounts that the derived splitting step may cost
  SpeciesMethod method = SpeciesMethod::stochastic;  // of species that name none
  Limits limits = Limits::refuse;
  std::optional<double> steady_tolerance;        // relative change of the flow per crossing time below which it is carried; absent: never
};

enum class ObservableType {
  count,           // molecules of a species in a material / shape
  concentration,   // the same divided by the volume that holds it
  profile,         // concentration along an axis, in bins
  kinetic_energy,  // [J], fluid
  max_speed,       // [m/s], fluid
  temperature,     // [J], kinetic kT of the fluid
  density_error,   // max |rho/rho0 - 1|
  min_distance,    // smallest distance of two fluid particles, in spacings
  bounces,         // particles thrown back at walls so far
  velocity_profile, // mean velocity component along an axis, in bins
  displacement,    // [m] mean displacement component of what started in a material / shape, solids
  elastic_energy,  // [J], solids
  solid_energy,    // [J], solids: elastic and kinetic
  velocity_line,   // velocity component at points of a line, by moving least squares
  species_line,    // concentration there
  wall_force,      // component of the force [N] of the fluid on a wall
  wall_torque,     // component of its torque [N m] about a point
  species_flux,    // molecules of a species that leave through a boundary [molecules/s]
  projection_length,  // [m] length from tip to back less that before growth; this and the next: of a quasi-static wall
  tip_curvature,      // [1/m]
  flank_curvature,    // the least curvature of the front half, times the outer radius; negative: a concave neck
  cavity_volume,      // [m^3]
  residual,           // the largest force that an equilibrium left on a particle, of p R^2 (plane strain: p R)
  outside             // particles that were found outside the cavity that they fill
};

struct Observable {
  std::string name;
  ObservableType type = ObservableType::count;
  int species = -1;
  int material = -1;    // -1: every home
  ShapePointer shape;   // null: everywhere
  int axis = 0;         // of a profile or line
  int component = 0;    // of a velocity, a displacement, a force or a torque
  int bins = 0;         // of a profile
  int side = -1;        // of the domain, 2 axis + (0 = min, 1 = max), where a force or flux is measured; else at `material`
  Point point{};        // [m] on the line; about which a torque acts
  std::vector<double> at{};  // [m] coordinates along `axis` of a line's points
};

struct Run {
  double until = 0;                         // [s]
  double record_every = 0;                  // [s]
  std::vector<double> record_at;            // [s], further times, ascending
  int realisations = 1;
  std::uint64_t seed = 1;
  std::vector<std::string> record;          // fields to keep; empty: all that exist
  std::vector<double> quantiles{0.05, 0.5, 0.95};
};

struct Scene {
  std::string title;
  std::string file;  // as given
  std::string text;  // the model file's bytes, overrides applied
  int dimension = 2;
  bool axisymmetric = false;  // of two dimensions: x along the axis, y the distance from it
  double depth = 1;  // [m] in 2-D, [m^2] in 1-D, 1 in 3-D
  Domain domain;
  std::vector<Material> materials;
  std::vector<Region> regions;
  std::map<std::string, double> parameters;  // SI
  std::vector<Compartment> compartments;  // not empty: the scene is well mixed and has no domain
  std::vector<Definition> definitions;
  std::vector<Event> events;
  std::vector<Species> species;
  std::vector<Initial> initials;
  std::vector<Reaction> reactions;
  std::vector<SpeciesBoundary> boundaries;
  std::vector<Inflow> inflows;
  Flow flow;
  Mechanics mechanics;
  Effects effects;
  std::vector<bool Effects::*> undecided;  // "auto": rules decide before anything runs; until then as without rules
  Numerics numerics;
  std::vector<Observable> observables;
  Run run;
};

}  // namespace shmoo::scene
