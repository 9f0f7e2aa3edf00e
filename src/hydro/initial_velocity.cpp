#include "hydro/initial_velocity.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include "base/error.hpp"

namespace shmoo::hydro {

template <int D>
InitialVelocity<D>::InitialVelocity(const std::vector<scene::Quantity>& given,
                                    const std::map<std::string, double>& parameters)
    : variables_(std::make_unique<std::array<double, 4>>()) {
  for (std::size_t a = 0; a < D && a < given.size(); ++a) {
    components_[a].value = given[a].value;
    if (given[a].expression.empty()) continue;
    auto parser = std::make_unique<mu::Parser>();
    try {
      const char* names[] = {"x", "y", "z", "t"};
      for (std::size_t k = 0; k < 4; ++k) parser->DefineVar(names[k], &(*variables_)[k]);
      for (const auto& [name, value] : parameters) parser->DefineConst(name, value);
      parser->SetExpr(given[a].expression);
      parser->Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw base::InputError(
          fmt::format("the velocity '{}' cannot be used: {}. It may read x, y, z, t and the "
                      "parameters.",
                      given[a].expression, error.GetMsg()));
    }
    components_[a].parser = std::move(parser);
  }
}

template <int D>
InitialVelocity<D>::InitialVelocity(InitialVelocity&&) noexcept = default;

template <int D>
InitialVelocity<D>::~InitialVelocity() = default;

template <int D>
base::Vec<D> InitialVelocity<D>::operator()(const base::Vec<D>& position, double t) const {
  for (std::size_t a = 0; a < D; ++a) (*variables_)[a] = position[int(a)];
  (*variables_)[3] = t;
  base::Vec<D> v;
  for (std::size_t a = 0; a < D; ++a) {
    v[int(a)] = components_[a].parser ? components_[a].parser->Eval() : components_[a].value;
  }
  return v;
}

template class InitialVelocity<2>;
template class InitialVelocity<3>;

}  // namespace shmoo::hydro
