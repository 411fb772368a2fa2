#include "engine/app/unsettled_report.h"

#include <fmt/format.h>

#include <cstddef>

#include "engine/simulation/block_system.h"

namespace dda {
namespace {

const std::string& name_of(const Simulation& simulation, int block) {
  return simulation.model().blocks[static_cast<std::size_t>(block)].name;
}

}  // namespace

nlohmann::ordered_json unsettled_json(const Simulation& simulation) {
  const UnsettledSteps& steps = simulation.system().audit.unsettled;
  if (steps.count == 0) return nullptr;
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  if (steps.block_a >= 0) blocks = {name_of(simulation, steps.block_a), name_of(simulation, steps.block_b)};
  return {{"count", steps.count}, {"first_s", steps.first_time}, {"first_blocks", blocks}};
}

std::string unsettled_remark(const Simulation& simulation) {
  const UnsettledSteps& steps = simulation.system().audit.unsettled;
  if (steps.count == 0) return "";
  const std::string place = steps.block_a < 0
                                ? ""
                                : fmt::format(" between \"{}\" and \"{}\"", name_of(simulation, steps.block_a),
                                              name_of(simulation, steps.block_b));
  return fmt::format(
      "contacts left the answer open in {} step{}, first at {:.6g} s{}: no balance was found for the whole step at "
      "first, and it was found from elsewhere or the step taken in parts; another solver may find another, after which "
      "blocks go another way: compare with a smaller dt",
      steps.count, steps.count == 1 ? "" : "s", steps.first_time, place);
}

}  // namespace dda
