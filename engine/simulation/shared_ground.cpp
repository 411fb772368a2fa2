#include "engine/simulation/shared_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/contact/closure.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/contact/strain_jumps.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/overlap.h"
#include "engine/geometry/segment.h"
#include "engine/model/current_outline.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// How far a contact gives way, m; a projected stretch does so most at an end, beyond the points of its gaps.
double give_of(const InterfaceElement& element, const InterfaceState& own, const State& state) {
  const double depth = penetration_depth(element, own.gap, state.stress);
  if (element.law != InterfaceLaw::projected) return depth;
  return std::max(depth, deepest_end(element.lever, {own.gap(0), own.gap(2)}));
}

// The most that contacts of each pair of blocks do.
std::map<std::pair<int, int>, double> give_of_pairs(const BlockSystem& s) {
  std::map<std::pair<int, int>, double> give;
  const ContactSet& contacts = s.contacts;
  const std::vector<InterfaceElement>& elements = contacts.elements.own();  // they can change
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const InterfaceElement& element = elements[i];
    double& most = give[std::minmax(element.block_a, element.block_b)];
    most = std::max(most, give_of(element, contacts.states[i], s.state));
  }
  return give;
}

double size_of(const Model& model, int block) { return std::sqrt(model.blocks[at(block)].moments.area); }

// m: how far the deepest corner of `a` is inside `b`, and where; 0 where none is.
std::pair<double, Vec2> deepest_corner(const Polygon& a, const Polygon& b) {
  std::pair<double, Vec2> deepest{0, Vec2::Zero()};
  for (const Vec2& corner : a.outer) {
    if (!contains(b, corner)) continue;
    double depth = std::numeric_limits<double>::infinity();
    for (const Segment& edge : edges_of(b)) depth = std::min(depth, distance(edge, corner));
    if (depth > deepest.first) deepest = {depth, corner};
  }
  return deepest;
}

Vec2 place_of(const Polygon& a, const Polygon& b) {
  const auto in_b = deepest_corner(a, b), in_a = deepest_corner(b, a);
  if (std::max(in_a.first, in_b.first) > 0) return in_a.first > in_b.first ? in_a.second : in_b.second;
  const Box box_a = bounding_box(a), box_b = bounding_box(b);
  return (box_a.lower.cwiseMax(box_b.lower) + box_a.upper.cwiseMin(box_b.upper)) / 2;
}

// The largest tolerance by which they overlap, which they do by `least`.
double depth_of(const Polygon& a, const Polygon& b, double least) {
  double low = least, high = 2 * least;
  while (interiors_overlap(a, b, high)) high = 2 * std::exchange(low, high);
  constexpr int digits = 10;  // binary ones
  for (int i = 0; i < digits; ++i) {
    const double middle = (low + high) / 2;
    (interiors_overlap(a, b, middle) ? low : high) = middle;
  }
  return low;
}

double smaller_size(const Model& model, int a, int b) { return std::min(size_of(model, a), size_of(model, b)); }

std::vector<Box> boxes_of(const std::vector<Polygon>& outlines, const std::vector<bool>& absent) {
  std::vector<Box> boxes(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (absent.empty() || !absent[i]) boxes[i] = bounding_box(outlines[i]);
  return boxes;
}

// Pairs, the smaller first, that are deeper in each other than `tolerance` (m) of them, but for those to be left out.
template <typename IsLeftOut, typename Tolerance>
std::vector<SharedGround> overlaps(const BlockSystem& s, const IsLeftOut& is_left_out, const Tolerance& tolerance) {
  std::vector<SharedGround> found;
  const std::vector<Polygon> outlines = current_outlines(s.model, s.state);
  for (const auto& [a, b] : overlapping_pairs(boxes_of(outlines, s.excavated.absent))) {
    if (is_left_out(a, b)) continue;
    const Polygon &one = outlines[at(a)], &other = outlines[at(b)];
    const double least = tolerance(a, b);
    if (!interiors_overlap(one, other, least)) continue;
    const double depth = depth_of(one, other, least);
    found.push_back({a, b, depth, depth / smaller_size(s.model, a, b), place_of(one, other)});
  }
  return found;
}

// What strains make of it (strain_jumps.h), m.
double depth_by_strain(const BlockSystem& s, const SharedGround& shared, double near) {
  const Eigen::VectorXd nothing_more = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(6 * s.model.blocks.size()));
  double by_strain = 0;
  for (const int block : {shared.block_a, shared.block_b})
    by_strain +=
        strain_jump_at(block, local_place(s.model, shared.place), near, s.model, s.state, s.contacts, nothing_more);
  return by_strain;
}

}  // namespace

std::vector<SharedGround> shared_ground(const BlockSystem& s, double least_share) {
  std::vector<SharedGround> found;
  if (!s.plan.finite_kinematics || !s.plan.contacts_can_change) return found;
  const Model& model = s.model;
  auto allowed = give_of_pairs(s);
  for (const CameInOver& each : s.excavated.came_in_over)
    if (each.share <= told_share) allowed[{each.block_a, each.block_b}] += each.depth;
  const auto are_held = [&](int a, int b) { return model.is_held(a) && model.is_held(b); };
  const auto tolerance = [&](int a, int b) {
    const auto more = allowed.find({a, b});
    return least_share * smaller_size(model, a, b) + (more == allowed.end() ? 0 : more->second);
  };
  found = overlaps(s, are_held, tolerance);
  std::erase_if(found, [&](const SharedGround& each) {
    const double least = tolerance(each.block_a, each.block_b);
    return each.depth <= least + depth_by_strain(s, each, least);
  });
  std::ranges::stable_sort(found, std::ranges::greater{}, &SharedGround::share);
  return found;
}

void note_came_in_over(const std::vector<int>& added, BlockSystem& s) {
  constexpr double least_share = tolerated_share / 20;  // less is within what is tolerated with or without it
  const std::set<int> comes_in(added.begin(), added.end());
  const auto is_of_others = [&](int a, int b) { return !comes_in.contains(a) && !comes_in.contains(b); };
  std::vector<CameInOver>& noted = s.excavated.came_in_over;
  std::erase_if(noted, [&](const CameInOver& each) { return !is_of_others(each.block_a, each.block_b); });
  const auto tolerance = [&](int a, int b) { return least_share * smaller_size(s.model, a, b); };
  for (const SharedGround& each : overlaps(s, is_of_others, tolerance))
    noted.push_back({each.block_a, each.block_b, each.depth, each.share});
}

std::optional<SharedGroundOfStage> shared_ground_of_stage(const BlockSystem& s) {
  const std::vector<SharedGround> found = shared_ground(s);
  if (found.empty()) return std::nullopt;
  return SharedGroundOfStage{static_cast<int>(s.clock.stage), found.front(), static_cast<int>(found.size())};
}

}  // namespace dda
