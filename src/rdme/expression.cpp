#include "rdme/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

constexpr const char* coordinates[] = {"x", "y", "z", "t"};

}  // namespace

Expression::Expression(const std::string& text, const ExpressionNames& names)
    : parser_(std::make_unique<mu::Parser>()), variables_(4 + names.species.size(), 0.0) {
  try {
    for (int i = 0; i < 4; ++i) parser_->DefineVar(coordinates[i], &variables_[i]);
    for (std::size_t s = 0; s < names.species.size(); ++s) parser_->DefineVar(names.species[s], &variables_[4 + s]);
    for (const auto& [name, value] : names.parameters) parser_->DefineConst(name, value);
    parser_->SetExpr(text);
    const auto used = parser_->GetUsedVar();
    reads_time_ = used.contains("t");
    for (std::size_t s = 0; s < names.species.size(); ++s) {
      if (used.contains(names.species[s])) reads_.push_back(static_cast<int>(s));
    }
    parser_->Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw base::InputError(
        fmt::format("the expression '{}' cannot be used: {}. It may read x, y, z, t, the parameters and "
                    "the species by name.",
                    text, error.GetMsg()));
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

void Expression::set_position(double x, double y, double z) {
  variables_[0] = x;
  variables_[1] = y;
  variables_[2] = z;
}

double Expression::value() const { return parser_->Eval(); }

}  // namespace shmoo::rdme
