#include "engine/simulation/small_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/overlap.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

struct Limits {
  double doubtful, ruinous;
};
constexpr std::array limits{Limits{0.005, 0.05}, Limits{0.05, 0.5}, Limits{0.05, 1}, Limits{0.01, 0.2}};

const Limits& limits_of(SmallMotionFault fault) { return limits[static_cast<std::size_t>(fault)]; }

// A contact's lever is not less than this share of its block's size: corners that blocks share carry nothing alone.
constexpr double least_lever = 0.25;

constexpr double in_line = 1e-6;  // sine of the angle between edges of one straight face

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Along a contact's tangent, from its middle: m.
struct Stretch {
  double low = 0, high = 0;
  [[nodiscard]] double length() const { return high - low; }
};

class Judge {
 public:
  explicit Judge(const Simulation& simulation)
      : simulation_(simulation), model_(simulation.model()), state_(simulation.state()) {
    for (std::size_t i = 0; i < worst_.size(); ++i) worst_[i].fault = static_cast<SmallMotionFault>(i);
  }

  std::vector<SmallMotionError> errors() {
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) look_at_turn(block);
    if (!simulation_.plan().linear)
      for (std::size_t i = 0; i < simulation_.contacts().interfaces.size(); ++i) look_at_contact(i);
    look_at_ways();
    std::vector<SmallMotionError> found(worst_.begin(), worst_.end());
    std::erase_if(found, [](const SmallMotionError& each) { return !(each.error >= doubtful_error(each.fault)); });
    return found;
  }

 private:
  void note(SmallMotionFault fault, double error, double amount, int block, int other = -1) {
    SmallMotionError& worst = worst_[static_cast<std::size_t>(fault)];
    if (error > worst.error) worst = {fault, error, amount, block, other, current_centroid(model_, state_, block)};
  }

  [[nodiscard]] bool is_absent(int block) const {
    return !simulation_.absent().empty() && simulation_.absent()[at(block)];
  }
  [[nodiscard]] double turn_of(int block) const { return std::abs(state_.displacement[at(block)](2)); }
  [[nodiscard]] double size_of(int block) const { return std::sqrt(model_.blocks[at(block)].moments.area); }

  void look_at_turn(int block) {
    const double turn = turn_of(block);
    if (!is_absent(block)) note(SmallMotionFault::turned, turn * turn / 2, turn, block);
  }

  void look_at_contact(std::size_t index) {
    const Interface& interface = simulation_.contacts().interfaces[index];
    if (is_open(index)) return;
    for (const int block : {interface.block_a, interface.block_b}) look_at_lean(interface, block);
    look_at_slide(interface);
  }

  [[nodiscard]] bool is_open(std::size_t index) const {
    if (has_stress_rows(simulation_.contacts().elements[index])) return false;
    const InterfaceState state = simulation_.interface_state(index);
    const bool second_open =
        simulation_.contacts().interfaces[index].length == 0 || state.status[1] == ContactStatus::open;
    return state.status[0] == ContactStatus::open && second_open;
  }

  void look_at_lean(const Interface& interface, int block) {
    if (model_.is_held(block)) return;
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
    const double lost = interface.length > 0 ? 1 - std::clamp(common / interface.length, 0.0, 1.0) : common < 0;
    note(SmallMotionFault::slid, lost, std::abs(slide), interface.block_b, interface.block_a);
    for (const auto& [block, face] : {std::pair{interface.block_a, a}, {interface.block_b, b}})
      if (!model_.is_held(block) && face.length() > drawn.length() + model_.length_tolerance)
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

  // On straight ways from the drawing, in stretches of half a block's thickness as far as that takes no longer than
  // looking at many blocks once.
  void look_at_ways() {
    constexpr double most_outlines = 2e5;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) {
      least = std::min(least, thickness_of(block));
      for (const Vec2& vertex : model_.blocks[at(block)].shape.outer)
        most = std::max(most, point_displacement(model_, state_, block, vertex).norm());
    }
    if (!(2 * most > doubtful_error(SmallMotionFault::passed) * least)) return;
    const double most_looks = std::max(1.0, most_outlines / static_cast<double>(model_.blocks.size()));
    const int looks = static_cast<int>(std::min({most_looks, 1000.0, std::ceil(4 * most / least)}));
    held_ = pairs_in_contact();
    for (int look = looks; look > 0; --look) look_at_overlaps(static_cast<double>(look) / looks);
  }

  // At this share of the way.
  void look_at_overlaps(double share_of_way) {
    std::vector<Polygon> outlines;
    std::vector<Box> boxes;
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) {
      outlines.push_back(outline_at(share_of_way, block));
      boxes.push_back(is_absent(block) ? Box{} : bounding_box(outlines.back().outer));
    }
    for (const std::pair<int, int>& pair : overlapping_pairs(boxes)) {
      if (std::ranges::binary_search(held_, pair)) continue;
      const double thickness = std::min(thickness_of(pair.first), thickness_of(pair.second));
      for (const double share : {ruinous_error(SmallMotionFault::passed), doubtful_error(SmallMotionFault::passed)})
        if (interiors_overlap(outlines[at(pair.first)], outlines[at(pair.second)], share * thickness)) {
          const bool first_moves = !model_.is_held(pair.first);
          note(SmallMotionFault::passed, share, share * thickness, first_moves ? pair.first : pair.second,
               first_moves ? pair.second : pair.first);
          break;
        }
    }
  }

  [[nodiscard]] Polygon outline_at(double share_of_way, int block) const {
    Polygon outline = model_.blocks[at(block)].shape;
    const auto move = [&](Ring& ring) {
      for (Vec2& vertex : ring) vertex += share_of_way * point_displacement(model_, state_, block, vertex);
    };
    move(outline.outer);
    for (Ring& hole : outline.holes) move(hole);
    return outline;
  }

  // Overlap of these is that of a closed contact.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs_in_contact() const {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < simulation_.contacts().interfaces.size(); ++i) {
      const Interface& interface = simulation_.contacts().interfaces[i];
      if (simulation_.plan().linear || !is_open(i))
        pairs.emplace_back(std::minmax(interface.block_a, interface.block_b));
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  // Area over diameter: at most the least width of a block.
  [[nodiscard]] double thickness_of(int block) const {
    const Block& own = model_.blocks[at(block)];
    double radius = 0;
    for (const Vec2& vertex : own.shape.outer) radius = std::max(radius, (vertex - own.moments.centroid).norm());
    return own.moments.area / (2 * radius);
  }

  const Simulation& simulation_;
  const Model& model_;
  const State& state_;
  std::array<SmallMotionError, limits.size()> worst_;
  std::vector<std::pair<int, int>> held_;
};

}  // namespace

double doubtful_error(SmallMotionFault fault) { return limits_of(fault).doubtful; }

double ruinous_error(SmallMotionFault fault) { return limits_of(fault).ruinous; }

std::vector<SmallMotionError> errors_of_small_motion(const Simulation& simulation) {
  const auto is_finite = [](const Stage& stage) { return stage.kinematics == Kinematics::finite; };
  if (std::ranges::any_of(simulation.model().stages, is_finite)) return {};
  return Judge(simulation).errors();
}

}  // namespace dda
