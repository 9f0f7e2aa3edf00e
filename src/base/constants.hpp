#pragma once
// Exact constants of the SI (2019).
namespace shmoo::base {

inline constexpr double avogadro = 6.02214076e23;    // [1/mol]
inline constexpr double boltzmann = 1.380649e-23;    // [J/K]

}  // namespace shmoo::base
