#pragma once
// What a quantity should be, at the places and times of a sample.
#include <functional>

#include "run/study/point.hpp"

namespace shmoo::run::study {

// The sample of the same quantity by another method or at another level, its values averaged over repeats; null where
// no run gave one.
using Others = std::function<const Sample*(std::size_t method, std::size_t level)>;

// Empty where the runs that the reference is made of failed.
std::vector<double> reference_values(const scene::Study& study, const scene::StudyQuantity& quantity, const Task& task,
                                     const Sample& sample, const Others& others);

// Values of `other` at the places of `sample`: its own where the places are the same, else linear along the one axis on
// which they differ. base::RunError where that cannot be done.
std::vector<double> at_places(const Sample& other, const Sample& sample);

}  // namespace shmoo::run::study
