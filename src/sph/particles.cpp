#include "sph/particles.hpp"

#include <stdexcept>

namespace shmoo::sph {

template <int D>
Particles<D>::Particles()
    : position(add<Vec<D>>("position", "m")),
      id(add<std::uint32_t>("id", "1")),
      material(add<std::uint16_t>("material", "1")),
      role(add<Role>("role", "1")) {}

template <int D>
void Particles<D>::resize(std::size_t particles) {
  size_ = particles;
  for (auto& column : columns_) column->resize(particles);
}

template <int D>
ColumnBase* Particles<D>::find(const std::string& name) {
  for (auto& column : columns_)
    if (column->name() == name) return column.get();
  return nullptr;
}

template <int D>
std::size_t Particles<D>::bytes() const {
  std::size_t sum = 0;
  for (const auto& column : columns_) sum += column->bytes();
  return sum;
}

template <int D>
void Particles<D>::permute(std::span<const std::uint32_t> order) {
  for (auto& column : columns_) column->permute(order);
}

template <int D>
void Particles<D>::append(std::span<const std::uint32_t> originals) {
  const std::size_t before = size_;
  resize(before + originals.size());
  for (auto& column : columns_)
    for (std::size_t k = 0; k < originals.size(); ++k) column->copy(originals[k], before + k);
}

template <int D>
void Particles<D>::throw_other_type(const std::string& name) {
  throw std::logic_error("column '" + name + "' exists with another type");
}

template class Particles<1>;
template class Particles<2>;
template class Particles<3>;

}  // namespace shmoo::sph
