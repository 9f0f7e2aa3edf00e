#pragma once
// A result told on one page: what was run and how, derived numbers with their reasons, observables and fields as
// pictures, the account of molecules, and the model itself.
#include <string>

#include "run/result_file.hpp"

namespace shmoo::run {

// HTML that needs no other file. Pictures show `time` (a record) and are drawn by gnuplot: base::RunError without it.
std::string result_page(const ResultFile& result, std::size_t time);

}  // namespace shmoo::run
