#include "engine/simulation/water_apart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/geometry/segment.h"
#include "engine/model/edge_loads_of_blocks.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool acts(const EdgeLoad& load, std::size_t stage, double time) {
  const bool presses = !load.traction.isZero(0) || !load.rise.isZero(0);
  return presses && load.stages.has(stage) && evaluate(load.history, time) != 0;
}

// Whether a load that acts lies within this joint.
class PressedJoints {
 public:
  PressedJoints(const Model& model, std::size_t stage, double time)
      : model_(model), stage_(stage), time_(time), loads_(edge_loads_of_blocks(model)) {}

  [[nodiscard]] bool presses(const Interface& joint, int block) const {
    const double tolerance = point_tolerance(model_);
    const Segment face{joint.from, joint.to};
    return std::ranges::any_of(loads_[at(block)], [&](std::size_t i) {
      const EdgeLoad& load = model_.edge_loads[i];
      return acts(load, stage_, time_) && distance(face, load.from) <= tolerance &&
             distance(face, load.to) <= tolerance;
    });
  }

 private:
  const Model& model_;
  std::size_t stage_;
  double time_;
  std::vector<std::vector<std::size_t>> loads_;
};

// How far the middle of a joint's face is on one block from that face of the other, m. Blocks that slide along their
// joint are not apart.
double way_between(const Interface& joint, const Model& model, const State& state) {
  const auto now = [&](int block, const Vec2& point) { return current_position(model, state, block, point); };
  const Segment face{now(joint.block_b, joint.from), now(joint.block_b, joint.to)};
  return distance(face, now(joint.block_a, (joint.from + joint.to) / 2));
}

}  // namespace

std::optional<WaterApart> water_apart(const Model& model, const State& state, std::size_t stage) {
  if (model.edge_loads.empty()) return {};
  const PressedJoints pressed(model, stage, state.time);
  std::set<std::pair<int, int>> apart;
  WaterApart worst;
  for (const Interface& joint : find_interfaces(model)) {
    if (joint.length == 0) continue;
    const double area =
        std::min(model.blocks[at(joint.block_a)].moments.area, model.blocks[at(joint.block_b)].moments.area);
    const double way = way_between(joint, model, state), share = way / std::sqrt(area);
    if (share <= share_of_a_joint || !pressed.presses(joint, joint.block_a) || !pressed.presses(joint, joint.block_b))
      continue;
    apart.insert(std::minmax(joint.block_a, joint.block_b));
    if (share > worst.share) worst = {static_cast<int>(stage), joint.block_a, joint.block_b, 0, way, share, state.time};
  }
  if (apart.empty()) return {};
  worst.pairs = static_cast<int>(apart.size());
  return worst;
}

}  // namespace dda
