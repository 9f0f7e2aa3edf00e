#pragma once
// For messages: the valid name that a mistyped one most likely stands for.
#include <span>
#include <string>
#include <string_view>

namespace shmoo::base {

// Insertions, deletions, substitutions and swaps of neighbours (Damerau 1964, optimal string alignment) from a to b.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The name nearest to `given`, or empty where none is near (distance above a third of the length, at least 2).
std::string nearest_name(std::string_view given, std::span<const std::string> names);

// "; did you mean 'NAME'?" or "".
std::string did_you_mean(std::string_view given, std::span<const std::string> names);

// "a, b, c" for messages; "(none)" for nothing.
std::string list_of(std::span<const std::string> names);

}  // namespace shmoo::base
