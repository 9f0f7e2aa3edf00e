#pragma once
// What this process holds, and what a run's records will.
#include <cstddef>
#include <functional>

#include "coupling/record.hpp"

namespace shmoo::run {

std::size_t heap_bytes();      // allocated and not freed
std::size_t resident_bytes();  // in memory, libraries included

// Of all finished realisations together (results.hpp). `filled(info)` is the part of a field's values that differ
// between realisations at all: a species' share of voxels.
using Filled = std::function<double(const coupling::FieldInfo&)>;
double results_bytes(const coupling::RecordLayout& layout, double realisations, const Filled& filled);

// Of what one realisation, or what all share, keeps until it has ended (recorder.hpp).
double recorder_bytes(const coupling::RecordLayout& layout, bool shared);

// Of writing the result: the HDF5 library's code and buffers, and its caches for the datasets of the largest field.
double writing_bytes(const coupling::RecordLayout& layout);

}  // namespace shmoo::run
