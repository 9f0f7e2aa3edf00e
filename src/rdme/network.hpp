#pragma once
// The reaction network: who takes part, at which propensity, who is treated how, and what an event changes.
//
// One law without special cases. A reaction runs v = k prod_s C_s^nu_s events per volume and time (or v is an
// expression).
//   Propensity in a voxel of volume V:   a = k V^(1-m) prod_s n_s (n_s - 1) ... (n_s - nu_s + 1),   m = sum_s nu_s.
//   Deterministic:                       dn_s/dt = (net change of s) V v.
// So A+B: (k/V) n_A n_B; A+A: (k/V) n (n-1), and d[A]/dt = -2 k [A]^2 for 2 A -> B. There is no 1/2 anywhere.
// In a well-mixed scene (scene/well.hpp: in_numbers) expressions give a itself; those that are mass action in disguise
// are treated as such.
//
// Which reactions are sampled. A reaction is sampled (stochastic) if and only if one event changes the number of at
// least one stochastic species; of the others, one that changes a Langevin species happens smoothly but with noise
// (langevin.hpp); every other reaction is integrated deterministically.
//
// Reactions between species of different kinds:
// * A deterministic or Langevin reactant enters the propensity of a sampled reaction as its real amount: n^nu. An event
//   takes or adds whole molecules of it, and the propensity is zero while the amount is below what an event takes on
//   balance.
// * An integrated reaction reads stochastic counts and Langevin amounts as they stand at the start of the step, in
//   which they are frozen. Counts enter through the same falling
//   factorial, amounts as powers.
// * Amounts below zero (deterministic integration, within its tolerance) are read as zero by propensities.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shmoo::rdme {

struct Change {
  int species = 0;
  int amount = 0;       // net, never zero
  bool beyond = false;  // in the other voxel of a reaction on a surface
};

enum class Treatment { sampled, langevin, integrated };

struct Reaction {
  std::string name;
  std::vector<scene::Term> reactants;
  std::vector<Change> changes;         // ascending by species
  double rate_constant = 0;            // [(molecules/m^3)^(1-m)/s], v = k prod C^nu
  int order = 0;                       // m
  std::string expression;              // v [molecules/(m^3 s)]; empty: mass action
  std::vector<int> reads;              // species whose numbers the rate depends on, ascending
  bool reads_time = false;             // the expression contains t
  std::vector<bool> in_material;       // by material: does it run there? On a surface: the first of the two
  std::array<int, 2> surface{-1, -1};  // of a reaction between neighbouring voxels of two materials
  bool per_area = false;               // on a surface, with no reactant in the first material
  bool on_surface() const { return surface[0] >= 0; }
  bool stochastic = false;  // an event changes a stochastic species
  bool langevin = false;    // that is not so, and an event changes a Langevin species
  Treatment treatment() const {
    return stochastic ? Treatment::sampled : langevin ? Treatment::langevin : Treatment::integrated;
  }
};

class Network {
 public:
  // Throws base::InputError, all mistakes at once: an expression that does not parse or reads an unknown name, a
  // reaction that can run nowhere or runs where one of its species does not live, a negative or infinite constant.
  explicit Network(const scene::Scene& scene);

  std::size_t species() const { return species_.size(); }
  const std::vector<scene::Species>& species_list() const { return species_; }
  const std::string& name(int species) const { return species_[species].name; }
  bool stochastic(int species) const { return species_[species].method == scene::SpeciesMethod::stochastic; }
  bool langevin(int species) const { return species_[species].method == scene::SpeciesMethod::langevin; }
  bool deterministic(int species) const { return species_[species].method == scene::SpeciesMethod::deterministic; }
  double diffusivity(int species) const { return species_[species].diffusivity; }  // [m^2/s]
  bool lives_in(int species, int material) const;

  const std::vector<Reaction>& reactions() const { return reactions_; }
  const std::vector<std::pair<std::string, double>>& parameters() const { return parameters_; }  // SI
  const std::vector<int>& varying() const { return varying_; }  // parameters that events change, ascending

  // Indices of the reactions that run in a material, ascending.
  std::span<const int> sampled_in(int material) const { return sampled_[material]; }
  std::span<const int> integrated_in(int material) const { return integrated_[material]; }
  std::span<const int> langevin_in(int material) const { return langevin_[material]; }

  // Integrated reactions on surfaces, which integrated_in() leaves out. Sampled ones belong to their first material.
  const std::vector<int>& integrated_on_surfaces() const { return integrated_on_surfaces_; }
  bool samples_surfaces() const { return samples_surfaces_; }

  // Sampled reactions of a material whose propensity one event of `reaction` changes, or one molecule of `species` more
  // or less, ascending.
  std::span<const int> after_reaction(int reaction, int material) const {
    return after_reaction_[material * reactions_.size() + reaction];
  }
  std::span<const int> after_species(int species, int material) const {
    return after_species_[material * species_.size() + species];
  }

  bool any_sampled() const { return any_sampled_; }
  bool any_integrated() const { return any_integrated_; }
  bool any_langevin() const { return any_langevin_; }
  bool any_smooth() const { return any_smooth_; }  // species that are not stochastic
  bool sampled_rates_change_in_time() const { return sampled_time_; }

 private:
  void compile(const scene::Reaction& from, const std::vector<scene::Material>& materials,
               std::vector<base::Diagnostic>& mistakes);
  void recognise_mass_action(Reaction& reaction) const;
  void find_varying(const scene::Scene& scene);
  void find_materials(const scene::Reaction& from, const std::vector<scene::Material>& materials, Reaction& reaction,
                      std::vector<base::Diagnostic>& mistakes) const;
  void divide(const std::vector<scene::Material>& materials, Reaction& reaction,
              std::vector<base::Diagnostic>& mistakes) const;
  void sort_by_material(std::size_t materials);
  void find_dependencies(std::size_t materials);

  std::vector<scene::Species> species_;
  std::vector<std::pair<std::string, double>> parameters_;
  std::vector<int> varying_;
  std::vector<Reaction> reactions_;
  std::vector<std::vector<int>> sampled_, integrated_, langevin_, after_reaction_, after_species_;
  bool any_sampled_ = false, any_integrated_ = false, any_langevin_ = false, any_smooth_ = false, sampled_time_ = false;
  bool samples_surfaces_ = false;
  std::vector<int> integrated_on_surfaces_;
};

// The names that this network's expressions may read.
struct ExpressionNames;
ExpressionNames expression_names(const Network& network);

}  // namespace shmoo::rdme
