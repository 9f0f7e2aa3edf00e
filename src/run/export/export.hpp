#pragma once
// Results for other programs.
#include <filesystem>
#include <vector>

#include "run/result_file.hpp"

namespace shmoo::run {

// One VTK PolyData file (.vtp, appended raw data) per record and result.pvd, which ParaView opens as an animation.
// Varying fields give NAME (their mean) and NAME_deviation. Returns the path of the .pvd.
std::vector<std::filesystem::path> export_vtk(const ResultFile& result, const std::filesystem::path& folder);

// field_NAME.csv with a row per record and particle, observable_NAME.csv with a row per record (and bin). Returns all
// paths.
std::vector<std::filesystem::path> export_csv(const ResultFile& result, const std::filesystem::path& folder);

// Makes the folder; base::InputError where that cannot be done.
void make_folder(const std::filesystem::path& folder);

}  // namespace shmoo::run
