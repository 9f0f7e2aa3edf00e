#include "rdme/mass_action.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "rdme/expression.hpp"
#include "scene/formula.hpp"

namespace shmoo::rdme {
namespace {

using scene::Formula;

// What a product is made of.
class Product {
 public:
  Product(const std::vector<std::string>& species, const std::vector<std::pair<std::string, double>>& fixed)
      : species_(species), fixed_(fixed) {}

  // Multiplies by the formula, or divides by it; false where that is no mass action.
  bool take(const Formula& formula, bool divide = false) {
    if (formula.kind == Formula::Kind::call && formula.of.size() == 2 && (formula.word == "*" || formula.word == "/"))
      return take(formula.of[0], divide) && take(formula.of[1], divide != (formula.word == "/"));
    if (const auto value = constant(formula)) {
      constant_ = divide ? constant_ / *value : constant_ * *value;
      return true;
    }
    if (divide) return false;
    if (formula.kind == Formula::Kind::name) return shift(formula, 0);
    const bool less = formula.kind == Formula::Kind::call && formula.word == "-" && formula.of.size() == 2;
    if (!less || formula.of[0].kind != Formula::Kind::name || formula.of[1].kind != Formula::Kind::number) return false;
    return shift(formula.of[0], formula.of[1].value);
  }

  std::optional<MassAction> result() const {
    MassAction law{constant_, {}};
    if (!(law.constant >= 0 && std::isfinite(law.constant))) return std::nullopt;
    for (auto [which, shifts] : shifts_) {
      std::sort(shifts.begin(), shifts.end());
      for (std::size_t k = 0; k < shifts.size(); ++k)
        if (shifts[k] != static_cast<double>(k)) return std::nullopt;
      law.reactants.push_back({which, static_cast<int>(shifts.size())});
    }
    return law;
  }

 private:
  std::optional<double> constant(const Formula& formula) const {
    try {
      return Expression(write(formula), {fixed_, {}}).constant();
    } catch (const base::InputError&) {
      return std::nullopt;  // it reads something else
    }
  }

  bool shift(const Formula& formula, double by) {
    const auto found = std::find(species_.begin(), species_.end(), formula.word);
    if (found == species_.end()) return false;
    shifts_[static_cast<int>(found - species_.begin())].push_back(by);
    return true;
  }

  const std::vector<std::string>& species_;
  const std::vector<std::pair<std::string, double>>& fixed_;
  double constant_ = 1;
  std::map<int, std::vector<double>> shifts_;  // by species: j of each factor (n - j)
};

}  // namespace

std::optional<MassAction> as_mass_action(const std::string& formula, const std::vector<std::string>& species,
                                         const std::vector<std::pair<std::string, double>>& fixed) {
  Product product(species, fixed);
  try {
    if (!product.take(scene::parse_formula(formula))) return std::nullopt;
  } catch (const scene::ExpressionError&) {
    return std::nullopt;
  }
  return product.result();
}

}  // namespace shmoo::rdme
