#include "engine/advice/on_the_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/advice/block_named.h"
#include "engine/advice/chain_path.h"
#include "engine/advice/reach.h"
#include "engine/model/held_motion.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;    // of lengths, over the size of a block; of directions
constexpr double hardly_free = 1e-3;  // of a block's outline: what rounding leaves between neighbours

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double slack_of(const Block& block) { return tolerance * std::sqrt(block.moments.area); }

// Where the rock ends that moves, so that what holds it there, or lies behind it, is its far end.
double far_end(const Model& model, const std::vector<bool>& absent, const Vec2& direction) {
  double far = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (!model.is_held(static_cast<int>(i)) && (absent.empty() || !absent[i]))
      far = std::max(far, reach_of(model.blocks[i], direction).high);
  return far;
}

// N s/m: force over velocity of a wave that goes by.
double impedance_at(const Model& model, int block, double width) {
  const Material& rock = model.material_of(block);
  return std::sqrt(rock.young * rock.density) * width;
}

class Search {
 public:
  Search(const Model& model, std::size_t stage, const PassingWave& wave)
      : model_(model),
        stage_(static_cast<int>(stage)),
        wave_(wave),
        far_(far_end(model, model.absent_in(stage), wave.direction)) {}

  std::vector<Hindrance> run() {
    for (const PointSupport& support : model_.supports) add(support);
    for (const HeldBlock& held : model_.held_blocks) add(held);
    for (std::size_t i = 0; i < model_.viscous_edges.size(); ++i)
      if (!is_of_free_field(static_cast<int>(i))) add(model_.viscous_edges[i]);
    return std::move(hindrances_);
  }

 private:
  // A spring k sends k/(2 Z omega) of a wave back.
  void add(const PointSupport& support) {
    if (!is_still(support) || support.partner || (support.last_stage >= 0 && support.last_stage < stage_)) return;
    const Block& block = model_.blocks[at(support.block)];
    if (reach_of(block, wave_.direction).high > far_ - slack_of(block)) return;
    const double omega = 2 * std::numbers::pi * wave_.frequency;
    const double held = (held_directions(support) * wave_.particles).squaredNorm();
    if (held < tolerance) return;
    hindrances_.push_back({fmt::format("{} is held on its way", block_named(model_, support.block)), place_of(support),
                           support.stiffness * held / (2 * impedance(support.block) * omega)});
  }

  void add(const HeldBlock& held) {
    const Block& block = model_.blocks[at(held.block)];
    if (moves(held) || reach_of(block, wave_.direction).low > far_ - slack_of(block)) return;
    hindrances_.push_back({fmt::format("{} is held on its way", block_named(model_, held.block)), place_of(held), 1});
  }

  // A dashpot c takes c/(2 Z) of a wave.
  void add(const ViscousEdge& edge) {
    if (edge.first_stage > stage_) return;
    const ActingPlace place{edge.block, {edge.from, edge.to}};
    if (reach_of(model_, place, wave_.direction).low > far_ - slack_of(model_.blocks[at(edge.block)])) return;
    const Vec2 way = edge.to - edge.from;
    const double along = std::pow(way.normalized().dot(wave_.particles), 2);
    const double dashpot = (along * edge.shear_impedance + (1 - along) * edge.normal_impedance) * way.norm();
    hindrances_.push_back(
        {"an edge beside its way absorbs it", place, std::min(1.0, dashpot / (2 * impedance(edge.block)))});
  }

  // Such a side goes with a column that moves as the wave does.
  [[nodiscard]] bool is_of_free_field(int edge) const {
    return std::ranges::any_of(model_.free_field_sides, [&](const FreeFieldSide& side) {
      return std::ranges::find(side.viscous_edges, edge) != side.viscous_edges.end();
    });
  }

  [[nodiscard]] double impedance(int block) const { return impedance_at(model_, block, wave_.width); }

  const Model& model_;
  int stage_;
  PassingWave wave_;
  double far_;  // m
  std::vector<Hindrance> hindrances_;
};

// m, of the outline of a block that lies on either of the sides.
double length_on(const Ring& ring, const Vec2& direction, const Reach& sides, double slack) {
  return length_at(ring, direction, sides.low, slack) + length_at(ring, direction, sides.high, slack);
}

}  // namespace

std::vector<Hindrance> holding_or_absorbing(const Model& model, std::size_t stage, const PassingWave& wave) {
  return Search(model, stage, wave).run();
}

std::vector<Hindrance> missing_blocks(const Model& model, std::size_t stage, const Vec2& direction) {
  const std::vector<bool> absent = model.absent_in(stage);
  const double far = far_end(model, absent, direction);
  std::vector<Hindrance> hindrances;
  for (std::size_t i = 0; i < absent.size(); ++i) {
    const Block& block = model.blocks[i];
    if (!absent[i] || reach_of(block, direction).low > far - slack_of(block)) continue;
    const int index = static_cast<int>(i);
    hindrances.push_back({fmt::format("{} is not there in this stage, which the wave meets", block_named(model, index)),
                          {.block = index, .all_of_it = true},
                          1});
  }
  return hindrances;
}

std::vector<Hindrance> free_faces_inside(const Model& model, const ContactSet& drawn, const Vec2& direction) {
  const Vec2 across = left_of(direction);
  const Reach ends = reach_of(model, direction), sides = reach_of(model, across);
  std::vector<double> touching(model.blocks.size(), 0.0);  // m
  for (const Interface& interface : drawn.interfaces)
    for (const int block : {interface.block_a, interface.block_b}) touching[at(block)] += interface.length;
  std::vector<Hindrance> hindrances;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    if (model.is_held(static_cast<int>(i))) continue;
    const double outline = perimeter(block.shape);
    const double outside = length_on(block.shape.outer, direction, ends, slack_of(block)) +
                           length_on(block.shape.outer, across, sides, slack_of(block));
    if (outline - outside - touching[i] < hardly_free * outline) continue;
    const int index = static_cast<int>(i);
    hindrances.push_back({fmt::format("{} has a free face, which the wave meets", block_named(model, index)),
                          {.block = index, .all_of_it = true},
                          1});
  }
  return hindrances;
}

double way_over(const Model& model, const ActingPlace& place, const Vec2& direction, double front, const Vec2& seen) {
  return std::max(0.0, reach_of(model, place, direction).low - front) + distance(model, place, seen);
}

}  // namespace dda
