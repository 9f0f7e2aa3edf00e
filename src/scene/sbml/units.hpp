#pragma once
// The units that an SBML model declares, as what they are here: molecules, litres, seconds.
#include <optional>
#include <string>

class Model;

namespace shmoo::scene::sbml {

// The size of a unit in molecules, litres or seconds; nothing where it is none of that kind. `id`: of a unit definition
// or a base unit.
enum class Quantity { substance, volume, time };
std::optional<double> unit_size(const Model& model, const std::string& id, Quantity quantity);

// The unit that holds for the whole model: declared as an attribute (Level 3) or by redefining the built-in unit (Level
// 2);
// "" where none is declared.
std::string declared_unit(const Model& model, Quantity quantity);

}  // namespace shmoo::scene::sbml
