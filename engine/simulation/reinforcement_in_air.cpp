#include "engine/simulation/reinforcement_in_air.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/core/types.h"
#include "engine/model/state.h"
#include "engine/model/tolerance.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

// One of the two points between which a bolt or lining is.
struct Place {
  int block;
  Vec2 drawn;
};

class Widest {
 public:
  Widest(const BlockSystem& system, ReinforcementInAir what) : system_(system), widest_(what) {}

  void look(const Place& a, const Place& b) {
    if (a.block == b.block) return;
    const auto now = [&](const Place& place) {
      return local_position(system_.model, system_.state, place.block, place.drawn);
    };
    const auto size = [&](const Place& place) {
      return std::sqrt(system_.model.blocks[static_cast<std::size_t>(place.block)].moments.area);
    };
    const double way = (now(b) - now(a)).norm() - (b.drawn - a.drawn).norm();
    if (way <= std::max(widest_.way, widest_joint * std::min(size(a), size(b)))) return;
    widest_.block_a = a.block;
    widest_.block_b = b.block;
    widest_.way = way;
  }

  void add_to(std::vector<ReinforcementInAir>& all) const {
    if (widest_.block_a >= 0) all.push_back(widest_);
  }

 private:
  const BlockSystem& system_;
  ReinforcementInAir widest_;
};

}  // namespace

void note_reinforcement_in_air(const BlockSystem& system, std::vector<ReinforcementInAir>& all) {
  const Model& model = system.model;
  const int stage = static_cast<int>(system.clock.stage);
  if (stage == 0 || !system.geometry_moves()) return;
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    if (!model.bolts[i].grouted || model.bolts[i].first_stage != stage) continue;
    Widest widest(system, {.is_lining = false, .number = static_cast<int>(i)});
    for (const BoltLink& link : model.bolts[i].links)
      widest.look({link.block_a, link.point_a}, {link.block_b, link.point_b});
    widest.add_to(all);
  }
  for (std::size_t i = 0; i < model.linings.size(); ++i) {
    const Lining& lining = model.linings[i];
    if (lining.first_stage != stage) continue;
    Widest widest(system, {.is_lining = true, .number = static_cast<int>(i)});
    for (std::size_t j = 0; j < lining.elements(); ++j)
      widest.look({lining.start_of(j).block, lining.start_of(j).point},
                  {lining.end_of(j).block, lining.end_of(j).point});
    widest.add_to(all);
  }
}

}  // namespace dda
