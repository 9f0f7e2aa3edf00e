#pragma once
// From a checked document to a Scene: names become indices, defaults are filled in, and what only makes sense together
// is compared. Each function handles one part of the file, reports its mistakes through its section, and relies on
// those before it in this list.
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "scene/formula.hpp"
#include "scene/section.hpp"

namespace shmoo::scene {

// A scene in the making, with what only its making needs.
struct Draft : Scene {
  std::map<std::string, base::Dimension> parameter_dimensions;  // of those that have a unit
  std::set<std::string> bad_names;                              // parameters whose values were found bad
  std::map<std::string, Formula> meaning;                       // of definitions, without definitions in them
  bool well = false;                                            // well mixed, even where its compartments are bad
};

// The meaning of a word from a fixed list; `value` stays where the key is absent.
template <class Enumeration, std::size_t N>
void read_choice(const Section& section, std::string_view key,
                 const std::array<std::pair<const char*, Enumeration>, N>& names, Enumeration& value) {
  const auto text = section.text(key);
  for (const auto& [name, meaning] : names)
    if (text == name) value = meaning;
}

inline constexpr std::array<std::pair<const char*, SpeciesMethod>, 4> species_methods{
    {{"stochastic", SpeciesMethod::stochastic},
     {"langevin", SpeciesMethod::langevin},
     {"deterministic", SpeciesMethod::deterministic},
     {"auto", SpeciesMethod::automatic}}};

void build_well(const Section& root, Draft& draft);
void build_run(const Section& root, Scene& scene);
void build_materials(const Section& root, Scene& scene);
void build_domain(const Section& root, Scene& scene);
void build_sides(const Section& domain, Scene& scene);
void build_numerics(const Section& root, Scene& scene);
void build_openings(const Section& root, Draft& draft);
void build_regions(const Section& root, Scene& scene);
void build_parameters(const Section& root, Draft& draft);
void build_species(const Section& root, Draft& draft);
void build_definitions(const Section& root, Draft& draft);
void build_initials(const Section& root, Draft& draft);
void build_reactions(const Section& root, Draft& draft);
void build_events(const Section& root, Draft& draft);
void build_boundaries(const Section& root, Scene& scene);
void build_inflows(const Section& root, Draft& draft);
void build_flow(const Section& root, Draft& draft);
void build_solids(const Section& root, Draft& draft);
void build_mechanics(const Section& root, Scene& scene);
void build_wall(const Section& root, Scene& scene);
void build_effects(const Section& root, Scene& scene);
void build_refinements(const Section& root, Scene& scene);
void build_depth(const Section& root, Scene& scene);
void build_observables(const Section& root, Scene& scene);
void build_record(const Section& root, Scene& scene);

// The entries of a list of velocities or formulas for them, one per axis; these may read t where `timed`.
std::vector<Quantity> velocity_formulas(const Draft& draft, const Section& section, std::string_view key,
                                        const toml::node& list, bool timed = false);

// The shape that a table describes; null where it is absent or wrong.
ShapePointer build_shape(const Section& section, int dimension);

// Index of a name, or -1 with a message at `at`.
int material_index(const Scene& scene, const std::string& name, const Section& section, std::string_view key,
                   const toml::node& at);
int species_index(const Scene& scene, const std::string& name, const Section& section, std::string_view key,
                  const toml::node& at);

// The two materials that `surface` names, for a reaction whose equation is read; false with a message where they cannot
// be.
bool read_surface(const Section& section, const Scene& scene, Reaction& reaction);

// The materials that a key names (one name or a list), ascending and without repetition. All is well unless `good`
// turns false.
std::vector<int> material_list(const Scene& scene, const Section& section, std::string_view key, bool& good);

// What a formula may read besides x, y, z and the parameters.
enum class Reads { place, time, rate_law };  // nothing; t; t and the species

// Checks a formula: defined names, dimension; a concentration is not negative. Returns the species that it uses.
std::vector<int> check_formula(const Draft& draft, const Section& section, std::string_view key, const toml::node& at,
                               const base::Dimension& dimension, Reads reads);

// Checks a formula of pure numbers: defined names only. Variables are the parameters, t, the species and, in a scene
// with particles, x, y, z. Returns the species that it uses.
std::vector<int> check_numbers(const Draft& draft, const Section& section, std::string_view key, const toml::node& at);

// The text with definitions put in place of their names; as it is where it is no formula.
std::string expanded(const Draft& draft, const std::string& text);

// Why this can be no name in formulas, or "".
std::string identifier_problem(const Draft& draft, const std::string& name);

inline constexpr std::string_view axis_names = "xyz";

}  // namespace shmoo::scene
