#include "scene/sbml/units.hpp"

#include <sbml/Model.h>
#include <sbml/UnitDefinition.h>

#include <cmath>

namespace shmoo::scene::sbml {
namespace {

constexpr double avogadro = 6.02214076e23;

// Molecules, litres, seconds of one base unit, where it is of the kind at `exponent`.
std::optional<double> base_size(UnitKind_t kind, double exponent, Quantity quantity) {
  switch (quantity) {
    case Quantity::substance:
      if (exponent != 1) return std::nullopt;
      if (kind == UNIT_KIND_MOLE) return avogadro;
      if (kind == UNIT_KIND_ITEM || kind == UNIT_KIND_DIMENSIONLESS) return 1.0;
      return std::nullopt;
    case Quantity::volume:
      if ((kind == UNIT_KIND_LITRE || kind == UNIT_KIND_LITER || kind == UNIT_KIND_DIMENSIONLESS) && exponent == 1)
        return 1.0;
      if ((kind == UNIT_KIND_METRE || kind == UNIT_KIND_METER) && exponent == 3) return 1000.0;
      return std::nullopt;
    default:
      if ((kind == UNIT_KIND_SECOND || kind == UNIT_KIND_DIMENSIONLESS) && exponent == 1) return 1.0;
      return std::nullopt;
  }
}

}  // namespace

std::optional<double> unit_size(const Model& model, const std::string& id, Quantity quantity) {
  const UnitDefinition* definition = model.getUnitDefinition(id);
  if (!definition) return base_size(UnitKind_forName(id.c_str()), id == "metre" ? 3 : 1, quantity);
  if (definition->getNumUnits() != 1) return std::nullopt;
  const Unit& unit = *definition->getUnit(0);
  const auto size = base_size(unit.getKind(), unit.getExponentAsDouble(), quantity);
  if (!size) return std::nullopt;
  return *size * std::pow(unit.getMultiplier() * std::pow(10.0, unit.getScale()), unit.getExponentAsDouble());
}

std::string declared_unit(const Model& model, Quantity quantity) {
  const std::string built_in = quantity == Quantity::substance ? "substance"
                               : quantity == Quantity::volume  ? "volume"
                                                               : "time";
  if (model.getLevel() < 3) return model.getUnitDefinition(built_in) ? built_in : "";
  if (quantity == Quantity::substance) return model.getSubstanceUnits();
  return quantity == Quantity::volume ? model.getVolumeUnits() : model.getTimeUnits();
}

}  // namespace shmoo::scene::sbml
