#include "engine/advice/gap_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "engine/contact/joint_stiffness.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double widest_gap = 1e-2;      // of the smaller block's size: wider ones are seen in a drawing
constexpr double facing_share = 0.25;    // of the shorter of two edges that run beside each other
constexpr double facing_cosine = 0.999;  // within 2.5 degrees of opposite directions

const Block& block_at(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

// The distance at which two edges face each other over a good part of the shorter one; infinity where they do not.
double facing_distance(const Segment& a, const Segment& b) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vec2 along_a = a.end - a.start;
  const Vec2 along_b = b.end - b.start;
  const double shorter = std::min(along_a.norm(), along_b.norm());
  if (along_a.dot(along_b) > -facing_cosine * along_a.norm() * along_b.norm()) return none;
  const Vec2 unit = along_a.normalized();
  const double from = std::max(0.0, unit.dot(b.end - a.start));
  const double to = std::min(along_a.norm(), unit.dot(b.start - a.start));
  if (to - from < facing_share * shorter) return none;
  const double gap = cross(b.start + b.end - 2 * a.start, unit) / 2;  // material of `a` lies on its left
  if (gap <= 0) return none;
  return gap;
}

// Between outlines; holes are not looked at.
double gap_between(const Block& a, const Block& b) {
  const std::vector<Segment> edges_of_b = edges_of(Polygon{b.shape.outer, {}});
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& edge_a : edges_of(Polygon{a.shape.outer, {}}))
    for (const Segment& edge_b : edges_of_b) least = std::min(least, facing_distance(edge_a, edge_b));
  return least;
}

// Pairs of blocks that touch. Where blocks move contacts are followed before they close, too.
std::set<std::pair<int, int>> touching_pairs(const Model& model, const ContactSet& contacts) {
  std::set<std::pair<int, int>> touching;
  for (std::size_t k = 0; k < contacts.interfaces.size(); ++k) {
    const Interface& interface = contacts.interfaces[k];
    const bool closes_in_a_point = interface.length == 0;
    if (closes_in_a_point && contacts.states[k].gap(0) > model.length_tolerance) continue;
    touching.insert(std::minmax(interface.block_a, interface.block_b));
  }
  return touching;
}

}  // namespace

std::vector<std::string> gap_remarks(const Model& model, const ContactSet& contacts) {
  const std::set<std::pair<int, int>> touching = touching_pairs(model, contacts);
  std::vector<Box> boxes;
  for (const Block& block : model.blocks)
    boxes.push_back(expanded(bounding_box(block.shape), widest_gap * block_size(block)));
  std::size_t count = 0;
  std::string first;
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    if (touching.contains({a, b})) continue;
    const Block& block_a = block_at(model, a);
    const Block& block_b = block_at(model, b);
    const double gap = gap_between(block_a, block_b);
    if (gap <= model.length_tolerance || gap > widest_gap * std::min(block_size(block_a), block_size(block_b)))
      continue;
    if (count++ == 0)
      first = fmt::format("blocks \"{}\" and \"{}\" are {:.2g} m apart", block_a.name, block_b.name, gap);
  }
  if (count == 0) return {};
  return {fmt::format("{}{} and do not touch: blocks touch within {:.2g} m", first,
                      count > 1 ? fmt::format(", {} more pairs as little,", count - 1) : "", model.length_tolerance)};
}

}  // namespace dda
