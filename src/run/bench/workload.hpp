#pragma once
// A workload of the bench: work of a known kind that a method does for a while, counted per CPU second, with a check
// that what was computed is right.
#include <functional>
#include <string>
#include <vector>

namespace shmoo::run::bench {

struct Measurement {
  double rate = 0;         // [unit]
  double cpu_seconds = 0;  // spent on what is counted
  // What the method holds beyond the voxels themselves and their neighbour rows, or of a flow per particle; and the
  // rows.
  double bytes_per_voxel = 0, row_bytes_per_voxel = 0;
  std::string check;  // what was looked at and its value
  bool right = true;
};

struct Workload {
  std::string name, method;
  std::string unit;                                    // of the rate, per CPU second
  std::function<Measurement(double seconds)> measure;  // for about this long [CPU s]
};

std::vector<Workload> chemistry_workloads();
std::vector<Workload> lattice_workloads(const std::string& name);  // D3-n and RD-n of any n; empty: no such name
std::vector<Workload> geometry_workloads();
std::vector<Workload> smooth_workloads();  // of chemistry
std::vector<Workload> flow_workloads();
std::vector<Workload> solid_workloads();

double allocated_bytes();  // on the heap, now

}  // namespace shmoo::run::bench
