#pragma once
// The Min reactions as text of a model file: K. C. Huang, Y. Meir, N. S. Wingreen, "Dynamic structures in Escherichia
// coli: spontaneous formation of MinE rings and MinD polar zones", PNAS 100, 12724 (2003). For bench and verify, whose
// cells differ.
#include <string>

namespace shmoo::run {

inline const std::string min_reactions = R"toml(
[[reaction]]
equation = "D_ADP -> D_ATP"
forward = "1 1/s"
[[reaction]]
equation = "D_ATP -> d"
surface = ["membrane", "cytoplasm"]
forward = "0.025 um/s"
[[reaction]]
equation = "D_ATP + d -> 2 d"
surface = ["membrane", "cytoplasm"]
forward = "0.0015 um^3/(molecule s)"
[[reaction]]
equation = "D_ATP + de -> d + de"
surface = ["membrane", "cytoplasm"]
forward = "0.0015 um^3/(molecule s)"
[[reaction]]
equation = "E + d -> de"
surface = ["membrane", "cytoplasm"]
forward = "0.093 um^3/(molecule s)"
[[reaction]]
equation = "de -> D_ADP + E"
surface = ["membrane", "cytoplasm"]
forward = "0.7 1/s"
)toml";

}  // namespace shmoo::run
