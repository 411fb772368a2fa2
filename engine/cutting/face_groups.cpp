#include "engine/cutting/face_groups.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Curves = std::vector<int>;  // that a face lies in, ascending

void toggle(Curves& curves, int curve) {
  const auto place = std::lower_bound(curves.begin(), curves.end(), curve);
  if (place != curves.end() && *place == curve)
    curves.erase(place);
  else
    curves.insert(place, curve);
}

FacePlace place_in(const Curves& curves, const RockPlan& plan) {
  FacePlace place;
  place.in_boundary = !curves.empty() && curves.front() == boundary_curve;
  for (const int curve : curves) {
    const int opening = curve - curve_of_opening(plan, 0);
    if (curve == boundary_curve) continue;
    if (opening < 0) {
      place.in_boundary = false;
    } else {
      place.opening = opening;
      place.left_out = place.left_out || plan.openings[at(opening)].left_out;
    }
  }
  return place;
}

// Half-edges by the face on their left.
struct Borders {
  explicit Borders(const Arrangement& arrangement) : starts(at(arrangement.faces()) + 1, 0) {
    for (int h = 0; h < arrangement.half_edges(); ++h) ++starts[at(arrangement.face(h)) + 1];
    for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
    half_edges.resize(at(arrangement.half_edges()));
    std::vector<int> fill(starts.begin(), starts.end() - 1);
    for (int h = 0; h < arrangement.half_edges(); ++h) half_edges[at(fill[at(arrangement.face(h))]++)] = h;
  }
  std::vector<int> starts, half_edges;
};

}  // namespace

std::vector<FacePlace> places_of_faces(const Arrangement& arrangement, const PlanPieces& pieces, const RockPlan& plan) {
  const Borders borders(arrangement);
  std::map<Curves, int> numbers{{Curves{}, 0}};
  std::vector<Curves> kinds{Curves{}};
  std::vector<int> kind_of(at(arrangement.faces()), -1);
  kind_of[0] = 0;
  std::vector<int> to_do{0};
  while (!to_do.empty()) {
    const int face = to_do.back();
    to_do.pop_back();
    for (int i = borders.starts[at(face)]; i < borders.starts[at(face + 1)]; ++i) {
      const int half_edge = borders.half_edges[at(i)];
      const int beyond = arrangement.face(twin(half_edge));
      if (kind_of[at(beyond)] >= 0) continue;
      Curves curves = kinds[at(kind_of[at(face)])];
      for (const int straight : arrangement.straights(half_edge / 2)) {
        if (pieces.sources[at(straight)].curve != no_curve) toggle(curves, pieces.sources[at(straight)].curve);
      }
      const auto [number, is_new] = numbers.try_emplace(curves, static_cast<int>(kinds.size()));
      if (is_new) kinds.push_back(curves);
      kind_of[at(beyond)] = number->second;
      to_do.push_back(beyond);
    }
  }
  std::vector<FacePlace> places(kind_of.size());
  for (std::size_t face = 0; face < places.size(); ++face) places[face] = place_in(kinds[at(kind_of[face])], plan);
  return places;
}

FaceGroups::FaceGroups(const std::vector<FacePlace>& places) : parent_(places.size()) {
  for (std::size_t face = 0; face < places.size(); ++face)
    parent_[face] = places[face].in_rock() ? static_cast<int>(face) : outside;
}

// Writes only where a way is long: none is once all faces have been asked for, and then threads may ask.
int FaceGroups::of(int face) const {
  int parent = parent_[at(face)];
  while (parent_[at(parent)] != parent) parent = parent_[at(face)] = parent_[at(parent)];
  return parent;
}

void FaceGroups::settle() {
  for (int face = 0; at(face) < parent_.size(); ++face) parent_[at(face)] = of(face);
}

void FaceGroups::merge(int into, int group) { parent_[at(of(group))] = of(into); }

}  // namespace dda
