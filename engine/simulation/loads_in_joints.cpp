#include "engine/simulation/loads_in_joints.h"

#include "engine/contact/interface.h"
#include "engine/geometry/segment.h"
#include "engine/model/edge_loads_of_blocks.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Along more than half of the load, or all of it where it is next to nothing, as what a water table cuts off.
bool lies_along(const EdgeLoad& load, const Segment& stretch, double tolerance) {
  if ((load.to - load.from).norm() <= tolerance) return distance(stretch, load.from) <= tolerance;
  const auto common = collinear_overlap({load.from, load.to}, stretch, tolerance);
  return common && (common->second - common->first).norm() > (load.to - load.from).norm() / 2;
}

// Whether a load that begins with this stage acts where that one did.
bool is_replaced(const EdgeLoad& load, std::size_t stage, const Model& model) {
  for (const EdgeLoad& other : model.edge_loads)
    if (other.block == load.block && at(other.stages.first) == stage &&
        lies_along(load, {other.from, other.to}, point_tolerance(model)))
      return true;
  return false;
}

}  // namespace

std::vector<bool> loads_in_joints_of(const std::vector<int>& blocks, const Model& model) {
  std::vector<bool> is_meant(model.blocks.size(), false);
  for (const int block : blocks) is_meant[at(block)] = true;
  std::vector<bool> found(model.edge_loads.size(), false);
  if (found.empty() || blocks.empty()) return found;
  const auto loads_of_block = edge_loads_of_blocks(model);
  for (const Interface& joint : find_interfaces(model)) {
    if (joint.length == 0 || (!is_meant[at(joint.block_a)] && !is_meant[at(joint.block_b)])) continue;
    for (const int block : {joint.block_a, joint.block_b})
      for (const std::size_t load : loads_of_block[at(block)])
        if (lies_along(model.edge_loads[load], {joint.from, joint.to}, point_tolerance(model))) found[load] = true;
  }
  return found;
}

std::vector<bool> loads_that_go_with_blocks(std::size_t stage, const Model& model) {
  std::vector<bool> found = loads_in_joints_of(model.stages[stage].removal.blocks, model);
  const std::vector<bool> absent = model.absent_in(stage);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const EdgeLoad& load = model.edge_loads[i];
    const bool ends_here = stage > 0 && load.stages.has(stage - 1) && load.stages.is_over_in(stage);
    found[i] = found[i] && ends_here && !absent[at(load.block)] && !is_replaced(load, stage, model);
  }
  return found;
}

}  // namespace dda
