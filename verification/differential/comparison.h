// One scene, run in several ways that must give the same.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace verify {

enum class Agreement {
  agreed,     // in the end all runs went through and say the same
  stopped,    // all of them stopped at the same place with the same status
  refused,    // the scene is none
  sensitive,  // solvers differ by what round-off makes of the scene anyway
  other_way,  // open-close iterations went different ways, and friction allows for both answers
  differs,    // and nothing explains it
};
[[nodiscard]] std::string name_of(Agreement agreement);

struct Comparison {
  Agreement agreement = Agreement::agreed;
  std::string what;  // how far apart, or why it was refused
};

// Runs that stop half-way and go on from a snapshot, and runs with two threads, must agree to the last bit. Runs with
// each linear solver must agree to 1e-9, or to a hundred times what a change of 1e-13 to 1e-12 in the stiffness of the
// rock does to the runs of either solver. Coulomb's friction can have several answers to a step: where, when the two
// part, their open-close iterations have gone different ways or left other contacts sticking, that is told; without
// friction such ways end in the same answer, up to what the iteration leaves.
[[nodiscard]] Comparison compare_runs(const nlohmann::ordered_json& scene);

}  // namespace verify
