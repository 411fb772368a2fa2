#include "engine/contact/lost_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "engine/contact/interface_element.h"
#include "engine/contact/vertex_contact.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

using Heirs = std::vector<std::optional<InterfaceState>>;
using Places = std::map<std::pair<int, int>, std::vector<std::size_t>>;  // of heirs, by their blocks

Places by_pair(const std::vector<Interface>& heirs) {
  Places places;
  for (std::size_t i = 0; i < heirs.size(); ++i) places[std::minmax(heirs[i].block_a, heirs[i].block_b)].push_back(i);
  return places;
}

bool faces_as(const Interface& heir, const StretchEnd& end) {
  const double sense = end.block_a == heir.block_a ? 1 : -1;
  return sense * end.normal.dot(heir.normal) >= same_direction;
}

// Sine of the angle between the two normals.
double turned(const Interface& heir, const StretchEnd& end) { return std::abs(cross(end.normal, heir.normal)); }

// Where a joint bends two faces meet in the place of an end, and both face much as it does: those that lie as it lay go
// on with its force.
void keep_nearest_in_direction(const std::vector<Interface>& heirs, const StretchEnd& end,
                               std::vector<std::size_t>& here) {
  constexpr double same = 1e-6;
  double least = 1;
  for (const std::size_t i : here) least = std::min(least, turned(heirs[i], end));
  std::erase_if(here, [&](std::size_t i) { return turned(heirs[i], end) > least + same; });
}

// A force as the heir sees it, whose face may have turned from that of the end by a few degrees: in the plane it stays.
Vec2 seen_by(const Interface& heir, const StretchEnd& end) {
  const Vec2 normal = end.block_a == heir.block_a ? end.normal : Vec2(-end.normal);
  return local_axes(heir.normal) * (local_axes(normal).transpose() * end.state.force.head<2>());
}

// History is that of the end which came first; forces add up.
void give(const StretchEnd& end, double part, const Interface& heir, std::optional<InterfaceState>& state) {
  const Vec2 force = part * seen_by(heir, end);
  if (state) {
    state->force.head<2>() += force;
  } else {
    state = end.state;
    state->force.head<2>() = force;
  }
}

// The nearest heir on each side of an end, along its stretch.
struct Beside {
  std::optional<std::size_t> before, after;
  double to_before = std::numeric_limits<double>::infinity(), to_after = std::numeric_limits<double>::infinity();

  void look_at(std::size_t heir, const Vec2& way, const Vec2& along) {
    const double distance = way.dot(along);
    if ((way - distance * along).norm() > (1 - same_direction) * way.norm()) return;  // of another face
    if (distance < 0 && -distance < to_before) {
      before = heir;
      to_before = -distance;
    } else if (distance > 0 && distance < to_after) {
      after = heir;
      to_after = distance;
    }
  }
};

void give_to_those_beside(const StretchEnd& end, const Beside& beside, const std::vector<Interface>& heirs,
                          Heirs& states) {
  const auto give_to = [&](std::size_t heir, double part) { give(end, part, heirs[heir], states[heir]); };
  if (beside.before && beside.after) {
    const double whole = beside.to_before + beside.to_after;
    give_to(*beside.before, beside.to_after / whole);
    give_to(*beside.after, beside.to_before / whole);
  } else if (beside.before || beside.after) {
    give_to(beside.before ? *beside.before : *beside.after, 1);
  }
}

}  // namespace

Heirs LostEnds::shared_among(const std::vector<Interface>& heirs, double tolerance) const {
  Heirs states(heirs.size());
  const Places places = by_pair(heirs);
  std::vector<std::pair<const StretchEnd*, Beside>> between;
  for (const StretchEnd& end : ends_) {
    const auto own = places.find(end.pair());
    if (own == places.end()) continue;
    std::vector<std::size_t> here;
    Beside beside;
    for (const std::size_t i : own->second) {
      if (!faces_as(heirs[i], end)) continue;
      const Vec2 way = heirs[i].from - end.place;
      if (way.norm() <= tolerance) {
        here.push_back(i);
      } else {
        beside.look_at(i, way, end.along);
      }
    }
    keep_nearest_in_direction(heirs, end, here);
    for (const std::size_t i : here) give(end, 1 / static_cast<double>(here.size()), heirs[i], states[i]);
    if (here.empty()) between.emplace_back(&end, beside);
  }
  for (const auto& [end, beside] : between) give_to_those_beside(*end, beside, heirs, states);
  return states;
}

}  // namespace dda
