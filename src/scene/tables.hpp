#pragma once
// The parts of the schema's table, one function per part of a model.
#include <vector>

#include "scene/schema.hpp"

namespace shmoo::scene {

std::vector<Table> world_tables();       // the file itself, domain, materials, regions
std::vector<Table> refinement_tables();  // zones of a finer spacing
std::vector<Table> chemistry_tables();   // parameters, species, reactions, boundaries
Table softening_table();                 // of solids
std::vector<Key> solid_keys();           // of materials that are solids
std::vector<Table> flow_tables();        // inflow, flow, effects
std::vector<Table> mechanics_tables();   // mechanics, sources, growth
std::vector<Table> run_tables();         // numerics, observables, run
std::vector<Table> study_file_tables();

}  // namespace shmoo::scene
