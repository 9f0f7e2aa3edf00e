#pragma once
// What stands in a slot of the pair loops where the scene does not call for an effect: no arithmetic, no column, no
// draw.
#include <type_traits>
#include <variant>

namespace shmoo::hydro {

struct Absent {};

template <class Effect>
using Slot = std::variant<Absent, Effect>;

template <class T>
inline constexpr bool present = !std::is_same_v<T, Absent>;

template <class Effect>
bool is_present(const Slot<Effect>& slot) {
  return slot.index() == 1;
}

}  // namespace shmoo::hydro
