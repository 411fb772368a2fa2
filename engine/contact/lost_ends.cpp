#include "engine/contact/lost_ends.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "engine/contact/vertex_contact.h"

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

// History is that of the end which came first; forces add up.
void give(const StretchEnd& end, double part, std::optional<InterfaceState>& heir) {
  if (heir) {
    heir->force += part * end.state.force;
  } else {
    heir = end.state;
    heir->force *= part;
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

void give_to_those_beside(const StretchEnd& end, const Beside& beside, Heirs& states) {
  if (beside.before && beside.after) {
    const double whole = beside.to_before + beside.to_after;
    give(end, beside.to_after / whole, states[*beside.before]);
    give(end, beside.to_before / whole, states[*beside.after]);
  } else if (beside.before || beside.after) {
    give(end, 1, states[beside.before ? *beside.before : *beside.after]);
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
    for (const std::size_t i : here) give(end, 1 / static_cast<double>(here.size()), states[i]);
    if (here.empty()) between.emplace_back(&end, beside);
  }
  for (const auto& [end, beside] : between) give_to_those_beside(*end, beside, states);
  return states;
}

}  // namespace dda
