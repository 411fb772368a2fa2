#include "engine/advice/at_odds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

#include "engine/advice/block_named.h"
#include "engine/core/place_in_words.h"
#include "engine/geometry/segment.h"
#include "engine/model/motion.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

// Supports.

bool holds_along(const PointSupport& support, const Vec2& direction) {
  constexpr double parallel = 1 - 1e-9;
  if (!support.direction.isZero(0)) return std::abs(support.direction.dot(direction)) > parallel;
  return (support.holds_x || std::abs(direction.y()) > parallel) &&
         (support.holds_y || std::abs(direction.x()) > parallel);
}

double displacement_at(double time, const PointSupport& support, const Vec2& direction) {
  return direction.dot(support.amplitude) * motion_at(support.kind, support.history, time).displacement;
}

// s, from the start to when the first of the two is let go.
double time_together(const PointSupport& a, const PointSupport& b, const Model& model) {
  double end = 0;
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const auto is_over = [i](const PointSupport& s) { return s.last_stage >= 0 && s.last_stage < static_cast<int>(i); };
    if (!is_over(a) && !is_over(b)) end += model.stages[i].duration;
  }
  return end;
}

// Looks at times that no period of a history falls in with.
bool move_differently(const PointSupport& a, const PointSupport& b, const Vec2& direction, double end) {
  constexpr int times = 64;
  constexpr double golden = 0.6180339887498949;
  double largest = 0, difference = 0;
  for (int i = 0; i <= times; ++i) {
    const double share = i * golden, time = i == times ? end : (share - std::floor(share)) * end;
    const double of_a = displacement_at(time, a, direction), of_b = displacement_at(time, b, direction);
    largest = std::max({largest, std::abs(of_a), std::abs(of_b)});
    difference = std::max(difference, std::abs(of_a - of_b));
  }
  constexpr double round_off = 1e-9;
  return difference > round_off * largest;
}

bool are_at_odds(const PointSupport& a, const PointSupport& b, const Model& model) {
  if (a.partner || b.partner || (a.amplitude.isZero(0) && b.amplitude.isZero(0))) return false;
  if ((a.point - b.point).norm() > point_tolerance(model)) return false;
  const double end = time_together(a, b, model);
  const auto differ_along = [&](const Vec2& direction) {
    return holds_along(a, direction) && holds_along(b, direction) && move_differently(a, b, direction, end);
  };
  return differ_along(Vec2::UnitX()) || differ_along(Vec2::UnitY()) || differ_along(a.direction) ||
         differ_along(b.direction);
}

void remark_on_supports(const Model& model, std::vector<std::string>& remarks) {
  std::vector<const PointSupport*> supports;
  for (const PointSupport& support : model.supports) supports.push_back(&support);
  std::ranges::stable_sort(supports, {}, &PointSupport::block);
  std::vector<const PointSupport*> found;
  for (auto a = supports.begin(); a != supports.end(); ++a)
    for (auto b = a + 1; b != supports.end() && (*b)->block == (*a)->block; ++b)
      if (are_at_odds(**a, **b, model)) found.push_back(*a);
  if (found.empty()) return;
  const PointSupport& first = *found.front();
  remarks.push_back(
      fmt::format("two supports hold {} at {}{} and move it differently: it goes where neither of them "
                  "says, and their springs pull at each other",
                  block_named(model, first.block), place_in_words(first.point), and_more(found.size() - 1)));
}

// Viscous boundaries.

bool is_there_beside(const ViscousEdge& edge, int block, const Model& model) {
  for (auto stage = static_cast<std::size_t>(edge.first_stage); stage < model.stages.size(); ++stage) {
    const std::vector<bool> absent = model.absent_in(stage);
    if (absent.empty() || !absent[static_cast<std::size_t>(block)]) return true;
  }
  return false;
}

bool lies_along(const ViscousEdge& edge, const Interface& face, const Model& model) {
  constexpr double negligible = 1e-3;  // of the edge: ends are often written in few digits
  if (face.length == 0) return false;
  const auto common = collinear_overlap({edge.from, edge.to}, {face.from, face.to}, point_tolerance(model));
  return common && (common->second - common->first).norm() > negligible * (edge.to - edge.from).norm();
}

// Finds for each edge the block behind the joint along which it runs, as long as that is there while the edge absorbs;
// -1: none. Large scenes have many faces, of which few are beside an edge.
std::vector<int> blocks_behind(const ContactSet& contacts, const Model& model) {
  std::unordered_multimap<int, std::size_t> edges_on;
  for (std::size_t i = 0; i < model.viscous_edges.size(); ++i) edges_on.emplace(model.viscous_edges[i].block, i);
  std::vector<int> behind(model.viscous_edges.size(), -1);
  const auto look_at = [&](const Interface& face, int own, int other) {
    const auto [first, last] = edges_on.equal_range(own);
    for (auto edge = first; edge != last; ++edge) {
      const ViscousEdge& viscous = model.viscous_edges[edge->second];
      if (behind[edge->second] < 0 && lies_along(viscous, face, model) && is_there_beside(viscous, other, model))
        behind[edge->second] = other;
    }
  };
  for (const Interface& face : contacts.interfaces) {
    look_at(face, face.block_a, face.block_b);
    look_at(face, face.block_b, face.block_a);
  }
  return behind;
}

void remark_on_viscous_edges(const Model& model, const ContactSet& contacts, std::vector<std::string>& remarks) {
  if (model.viscous_edges.empty()) return;
  const std::vector<int> behind = blocks_behind(contacts, model);
  const auto first = std::ranges::find_if(behind, [](int block) { return block >= 0; });
  if (first == behind.end()) return;
  const auto others = std::count_if(first + 1, behind.end(), [](int block) { return block >= 0; });
  const ViscousEdge& edge = model.viscous_edges[static_cast<std::size_t>(first - behind.begin())];
  remarks.push_back(fmt::format(
      "a viscous boundary lies on the face of {} at {} on its joint with {}{}: dashpots between the "
      "rock and a ground that stands still take from waves that cross the joint; a boundary belongs on the outside or "
      "on the wall of an opening",
      block_named(model, edge.block), place_in_words((edge.from + edge.to) / 2), block_named(model, *first),
      and_more(static_cast<std::size_t>(others))));
}

}  // namespace

std::vector<std::string> remarks_on_odds(const Model& model, const ContactSet& contacts) {
  std::vector<std::string> remarks;
  remark_on_supports(model, remarks);
  remark_on_viscous_edges(model, contacts, remarks);
  return remarks;
}

}  // namespace dda
