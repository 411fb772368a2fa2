#include "engine/simulation/small_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/contact/closure.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/overlap.h"
#include "engine/geometry/segment.h"
#include "engine/model/current_outline.h"
#include "engine/model/held_flags.h"
#include "engine/simulation/block_extent.h"

namespace dda {
namespace {

struct Limits {
  double doubtful, ruinous;
};
constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::array<Limits, small_motion_faults> limits{
    {{0.005, 0.05}, {0.05, 0.5}, {0.05, 1}, {0.01, 0.2}, {0.01, never}}};

const Limits& limits_of(SmallMotionFault fault) { return limits[static_cast<std::size_t>(fault)]; }

// A contact's lever is not less than this share of its block's size: corners that blocks share carry nothing alone.
constexpr double least_lever = 0.25;

constexpr double in_line = 1e-6;  // sine of the angle between edges of one straight face

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A stretch along a contact's tangent, measured from the contact's middle, m.
struct Stretch {
  double low = 0, high = 0;
  [[nodiscard]] double length() const { return high - low; }
};

class Judge {
 public:
  Judge(const BlocksInMotion& blocks, const std::vector<double>& thickness, SmallMotionErrors& worst)
      : blocks_(blocks),
        model_(blocks.model),
        state_(blocks.state),
        thickness_(thickness),
        worst_(worst),
        held_(held_flags(blocks.model)) {}

  // Turns are counted from those `before`, with which the geometry is no longer that of the drawing.
  void look_at_end(const std::vector<double>& before) {
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block)
      look_at_turn(block, before.empty() ? 0 : before[at(block)]);
    if (!blocks_.plan.linear && before.empty())
      for (std::size_t i = 0; i < blocks_.contacts.interfaces.size(); ++i) look_at_contact(i);
    if (model_.stays_linear()) look_at_straight_ways();
  }

  // Follows blocks from where they were looked at last, in stretches of a quarter of a thickness.
  void look_at_way(const std::vector<Vec6>& from, double thicknesses) {
    constexpr double most_looks = 1000;
    const int looks = static_cast<int>(std::clamp(std::ceil(4 * thicknesses), 1.0, most_looks));
    in_contact_ = pairs_in_contact();
    for (int look = 1; look <= looks; ++look) {
      const double to_come = 1 - static_cast<double>(look) / looks;
      look_at_overlaps(SmallMotionFault::passed,
                       [&](int block) -> Vec6 { return to_come * (from[at(block)] - state_.displacement[at(block)]); });
    }
  }

 private:
  void note(SmallMotionFault fault, double error, double amount, int block, int other = -1) {
    SmallMotionError& worst = worst_[static_cast<std::size_t>(fault)];
    if (error > worst.error) worst = {fault, error, amount, block, other, current_centroid(model_, state_, block)};
  }

  [[nodiscard]] bool is_absent(int block) const { return !blocks_.absent.empty() && blocks_.absent[at(block)]; }
  [[nodiscard]] double turn_of(int block) const { return std::abs(state_.displacement[at(block)](2)); }
  [[nodiscard]] double size_of(int block) const { return std::sqrt(model_.blocks[at(block)].moments.area); }

  void look_at_turn(int block, double before) {
    const double turn = std::abs(state_.displacement[at(block)](2) - before);
    if (!is_absent(block)) note(SmallMotionFault::turned, turn * turn / 2, turn, block);
  }

  void look_at_contact(std::size_t index) {
    const Interface& interface = blocks_.contacts.interfaces[index];
    if (is_open(index)) return;
    for (const int block : {interface.block_a, interface.block_b}) look_at_lean(interface, block);
    look_at_slide(interface);
  }

  [[nodiscard]] bool is_open(std::size_t index) const {
    return dda::is_open(blocks_.contacts.elements.but_for_blocks(index), blocks_.contacts.states[index]);
  }

  void look_at_lean(const Interface& interface, int block) {
    if (held_[at(block)]) return;
    const Vec2 middle = (interface.from + interface.to) / 2;
    const double arm = std::abs(interface.normal.dot(model_.blocks[at(block)].moments.centroid - middle));
    const double lean = turn_of(block) * arm;
    note(SmallMotionFault::leaned, lean / std::max(interface.length, least_lever * size_of(block)), lean, block);
  }

  // Block b goes along its face of a, each with the ends of its own.
  void look_at_slide(const Interface& interface) {
    const Vec2 along(-interface.normal.y(), interface.normal.x());
    const Vec2 middle = (interface.from + interface.to) / 2;
    const double slide = along.dot(point_displacement(model_, state_, interface.block_b, middle) -
                                   point_displacement(model_, state_, interface.block_a, middle));
    const Stretch drawn{-interface.length / 2, interface.length / 2};
    const Stretch a = face_of(interface.block_a, middle, along, drawn);
    const Stretch b = face_of(interface.block_b, middle, along, drawn);
    const double common = std::min(a.high, b.high + slide) - std::max(a.low, b.low + slide);
    const double lost =
        interface.length > 0 ? 1 - std::clamp(common / interface.length, 0.0, 1.0) : common < -model_.length_tolerance;
    note(SmallMotionFault::slid, lost, std::abs(slide), interface.block_b, interface.block_a);
    for (const auto& [block, face] : {std::pair{interface.block_a, a}, {interface.block_b, b}})
      if (!held_[at(block)] && face.length() > drawn.length() + model_.length_tolerance)
        note(SmallMotionFault::slid, std::abs(slide) / face.length(), std::abs(slide), interface.block_b,
             interface.block_a);
  }

  // The straight face of a block that a contact lies in, past vertices within it.
  [[nodiscard]] Stretch face_of(int block, const Vec2& middle, const Vec2& along, Stretch face) const {
    const Polygon& shape = model_.blocks[at(block)].shape;
    for (bool grows = true; grows;) {
      grows = grow(shape.outer, middle, along, face);
      for (const Ring& hole : shape.holes) grows = grow(hole, middle, along, face) || grows;
    }
    return face;
  }

  bool grow(const Ring& ring, const Vec2& middle, const Vec2& along, Stretch& face) const {
    const double near = 2 * model_.length_tolerance;
    const Stretch before = face;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i] - middle, to = ring[(i + 1) % ring.size()] - middle;
      if (std::abs(cross(along, from)) > near || std::abs(cross(along, to - from)) > in_line * (to - from).norm())
        continue;
      const auto [low, high] = std::minmax({along.dot(from), along.dot(to)});
      if (low > face.high + near || high < face.low - near) continue;
      face = {std::min(face.low, low), std::max(face.high, high)};
    }
    return face.low < before.low || face.high > before.high;
  }

  // Follows blocks from the drawing, as far as that takes no longer than looking at many blocks once.
  void look_at_straight_ways() {
    constexpr double most_outlines = 2e5;
    double least = never, most = 0;
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) {
      least = std::min(least, thickness_[at(block)]);
      for (const Vec2& vertex : model_.blocks[at(block)].shape.outer)
        most = std::max(most, point_displacement(model_, state_, block, vertex).norm());
    }
    if (!(2 * most > doubtful_error(SmallMotionFault::passed) * least)) return;
    const double most_looks = std::max(1.0, most_outlines / static_cast<double>(model_.blocks.size()));
    const int looks = static_cast<int>(std::min({most_looks, 1000.0, std::ceil(4 * most / least)}));
    in_contact_ = pairs_in_contact();
    look_at_overlaps(SmallMotionFault::passed, [](int) -> Vec6 { return Vec6::Zero(); });
    for (int look = looks - 1; look > 0; --look)
      look_at_overlaps(SmallMotionFault::may_have_passed, [&](int block) -> Vec6 {
        return (static_cast<double>(look) / looks - 1) * state_.displacement[at(block)];
      });
  }

  // Looks at blocks where they are by `off(block)` beside where they are now.
  template <typename Off>
  void look_at_overlaps(SmallMotionFault fault, const Off& off) {
    std::vector<Polygon> outlines;
    std::vector<Box> boxes;
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) {
      outlines.push_back(outline_at(off(block), block));
      boxes.push_back(is_absent(block) ? Box{} : bounding_box(outlines.back().outer));
    }
    for (const std::pair<int, int>& pair : overlapping_pairs(boxes)) {
      if (std::ranges::binary_search(in_contact_, pair)) continue;
      const double thickness = std::min(thickness_[at(pair.first)], thickness_[at(pair.second)]);
      for (const double share : {ruinous_error(SmallMotionFault::passed), doubtful_error(SmallMotionFault::passed)})
        if (interiors_overlap(outlines[at(pair.first)], outlines[at(pair.second)], share * thickness)) {
          const bool first_moves = !held_[at(pair.first)];
          note(fault, share, share * thickness, first_moves ? pair.first : pair.second,
               first_moves ? pair.second : pair.first);
          break;
        }
    }
  }

  [[nodiscard]] Polygon outline_at(const Vec6& off, int block) const {
    const Vec2& centroid = model_.blocks[at(block)].moments.centroid;
    return outline_with(model_.blocks[at(block)].shape, [&](const Vec2& vertex) -> Vec2 {
      return vertex + (point_displacement(model_, state_, block, vertex) + displacement_rows(vertex - centroid) * off);
    });
  }

  // Overlap of these is that of a closed contact.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs_in_contact() const {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < blocks_.contacts.interfaces.size(); ++i) {
      const Interface& interface = blocks_.contacts.interfaces[i];
      if (blocks_.plan.linear || !is_open(i)) pairs.emplace_back(std::minmax(interface.block_a, interface.block_b));
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  const BlocksInMotion& blocks_;
  const Model& model_;
  const State& state_;
  const std::vector<double>& thickness_;
  SmallMotionErrors& worst_;
  std::vector<bool> held_;
  std::vector<std::pair<int, int>> in_contact_;
};

}  // namespace

double doubtful_error(SmallMotionFault fault) { return limits_of(fault).doubtful; }

double ruinous_error(SmallMotionFault fault) { return limits_of(fault).ruinous; }

void SmallMotionWatch::begin_stage(const BlocksInMotion& blocks) {
  if (blocks.plan.finite_kinematics) return;
  const std::size_t stage = blocks.clock.stage;
  if (stage > 0 && blocks.model.stages[stage - 1].kinematics == Kinematics::finite) {
    turns_before_.clear();
    for (const Vec6& each : blocks.state.displacement) turns_before_.push_back(each(2));
  }
  if (blocks.model.stays_linear()) return;
  looked_at_ = blocks.state.displacement;
  measure(blocks.model);  // not in the first step that asks, as steps take no memory
}

// Returns how far some block has gone at most since it was looked at, as a share of its own thickness.
double SmallMotionWatch::gone(const BlocksInMotion& blocks) const {
  double most = 0;
  for (std::size_t i = 0; i < looked_at_.size(); ++i) {
    const Vec6 since = blocks.state.displacement[i] - looked_at_[i];
    const double gone = since.head<2>().norm() + radius_[i] * (std::abs(since(2)) + since.tail<3>().norm());
    most = std::max(most, gone / thickness_[i]);
  }
  return most;
}

void SmallMotionWatch::follow(const BlocksInMotion& blocks) {
  constexpr std::int64_t steps_between = 8;  // asking all blocks after each step was 1.4 % of sliding blocks' time
  if (blocks.plan.finite_kinematics || looked_at_.empty()) return;
  if (!blocks.model.stages[blocks.clock.stage].paces_itself() && blocks.clock.step % steps_between != 0) return;
  measure(blocks.model);
  const double thicknesses = gone(blocks);
  if (!(thicknesses > 0.25)) return;
  Judge(blocks, thickness_, worst_).look_at_way(looked_at_, thicknesses);
  looked_at_ = blocks.state.displacement;
}

void SmallMotionWatch::end_stage(const BlocksInMotion& blocks) {
  if (blocks.plan.finite_kinematics) return;
  measure(blocks.model);
  Judge judge(blocks, thickness_, worst_);
  judge.look_at_end(turns_before_);
  if (looked_at_.empty()) return;
  const double thicknesses = gone(blocks);
  if (!(2 * thicknesses > doubtful_error(SmallMotionFault::passed))) return;
  judge.look_at_way(looked_at_, thicknesses);
  looked_at_ = blocks.state.displacement;
}

void SmallMotionWatch::measure(const Model& model) {
  if (!radius_.empty()) return;
  radius_.reserve(model.blocks.size());
  thickness_.reserve(model.blocks.size());
  for (const Block& block : model.blocks) {
    radius_.push_back(radius_of(block));
    thickness_.push_back(thickness_of(block, radius_.back()));
  }
}

std::vector<SmallMotionError> SmallMotionWatch::errors() const {
  std::vector<SmallMotionError> found(worst_.begin(), worst_.end());
  std::erase_if(found, [](const SmallMotionError& each) { return !(each.error >= doubtful_error(each.fault)); });
  return found;
}

}  // namespace dda
