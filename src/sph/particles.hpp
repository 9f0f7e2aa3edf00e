#pragma once
// The particle store: a structure of arrays. Position, id, material and role always exist; every other column exists
// only after somebody asked for it. Particles may be permuted (for locality); an id never changes.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace shmoo::sph {

using base::Mat;
using base::Vec;

// open: fluid beyond an open side, which shows what is held there
enum class Role : std::uint8_t { fluid, wall, still, solid, open };

class ColumnBase {
 public:
  ColumnBase(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}
  virtual ~ColumnBase() = default;
  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }
  virtual std::size_t bytes() const = 0;
  virtual void resize(std::size_t particles) = 0;
  virtual void permute(std::span<const std::uint32_t> order) = 0;
  virtual void copy(std::size_t from, std::size_t to) = 0;

 private:
  std::string name_, unit_;
};

template <class T>
class Column final : public ColumnBase {
 public:
  using ColumnBase::ColumnBase;
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  std::vector<T>& values() { return values_; }
  const std::vector<T>& values() const { return values_; }

  std::size_t bytes() const override { return values_.size() * sizeof(T); }
  void resize(std::size_t particles) override { values_.resize(particles, zero()); }
  void permute(std::span<const std::uint32_t> order) override {
    scratch_.resize(values_.size());
    for (std::size_t i = 0; i < order.size(); ++i) scratch_[i] = values_[order[i]];
    values_.swap(scratch_);
  }
  void copy(std::size_t from, std::size_t to) override { values_[to] = values_[from]; }

 private:
  static T zero() {
    if constexpr (requires { T::Zero(); })
      return T::Zero();
    else
      return T{};
  }
  std::vector<T> values_, scratch_;
};

template <int D>
class Particles {
  std::size_t size_ = 0;
  std::vector<std::unique_ptr<ColumnBase>> columns_;  // before the references below, which point into it

 public:
  Particles();
  Particles(Particles&&) noexcept = default;

  Column<Vec<D>>& position;         // [m]
  Column<std::uint32_t>& id;        // persistent; voxels come first: ids 0 .. voxels-1
  Column<std::uint16_t>& material;  // index into Scene::materials; of layers beyond a side see side_material()
  Column<Role>& role;

  std::size_t size() const { return size_; }
  void resize(std::size_t particles);

  // The column of this name; made, and filled with zeros, where it does not exist. References stay valid for the
  // store's life. Throws std::logic_error where it exists with another type.
  template <class T>
  Column<T>& require(const std::string& name, const std::string& unit) {
    if (ColumnBase* existing = find(name)) {
      if (auto* column = dynamic_cast<Column<T>*>(existing)) return *column;
      throw_other_type(name);
    }
    auto& column = add<T>(name, unit);
    column.resize(size_);
    return column;
  }

  ColumnBase* find(const std::string& name);
  const std::vector<std::unique_ptr<ColumnBase>>& columns() const { return columns_; }
  std::size_t bytes() const;  // of all columns

  // Particle i becomes what order[i] was; order is a permutation of 0 .. size-1.
  void permute(std::span<const std::uint32_t> order);
  // Leaves out those of which gone(i) is true; the others keep their order.
  template <class Gone>
  void remove(Gone&& gone) {
    std::vector<std::uint32_t> order, last;
    for (std::size_t i = 0; i < size_; ++i) (gone(i) ? last : order).push_back(std::uint32_t(i));
    const std::size_t rest = order.size();
    order.insert(order.end(), last.begin(), last.end());
    permute(order);
    resize(rest);
  }
  // Adds a copy of every one of these at the end.
  void append(std::span<const std::uint32_t> originals);

 private:
  template <class T>
  Column<T>& add(const std::string& name, const std::string& unit) {
    auto column = std::make_unique<Column<T>>(name, unit);
    auto& reference = *column;
    columns_.push_back(std::move(column));
    return reference;
  }
  [[noreturn]] static void throw_other_type(const std::string& name);
};

// The material number of wall particles that stand beyond a side of the domain.
inline std::uint16_t side_material(std::size_t materials, int axis, int side) {
  return static_cast<std::uint16_t>(materials + 2 * static_cast<std::size_t>(axis) + static_cast<std::size_t>(side));
}

extern template class Particles<1>;
extern template class Particles<2>;
extern template class Particles<3>;

}  // namespace shmoo::sph
