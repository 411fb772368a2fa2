#include "engine/cutting/opening_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

const double least_turn = std::sqrt(0.75);  // cosine of 30 degrees

// On an edge of the outline, as a share of it from 0 (included) to 1.
struct OutlinePlace {
  std::size_t edge = 0;
  double share = 0;
  bool operator==(const OutlinePlace&) const = default;
};

bool operator<(const OutlinePlace& a, const OutlinePlace& b) {
  return std::tie(a.edge, a.share) < std::tie(b.edge, b.share);
}

// An outline whose every point moves outwards as the distance from the opening grows.
class Offset {
 public:
  explicit Offset(const Ring& outline) : ring_(normalized({outline, {}}).outer) {
    const std::size_t count = ring_.size();
    std::vector<Vec2> normals;  // outwards, of the edge after each corner
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 along = (ring_[(i + 1) % count] - ring_[i]).normalized();
      normals.emplace_back(along.y(), -along.x());
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2& before = normals[(i + count - 1) % count];
      cosines_.push_back(before.dot(normals[i]));
      ways_.emplace_back((before + normals[i]) / (1 + cosines_.back()));
    }
  }

  [[nodiscard]] std::size_t corners() const { return ring_.size(); }
  [[nodiscard]] bool turns(std::size_t corner) const { return cosines_[corner] < least_turn; }
  [[nodiscard]] double edge_length(std::size_t edge) const {
    return (ring_[(edge + 1) % ring_.size()] - ring_[edge]).norm();
  }

  // The place that `place` of the outline has moved to.
  [[nodiscard]] Vec2 at(const OutlinePlace& place, double distance) const {
    Vec2 from = ring_[place.edge] + distance * ways_[place.edge];
    if (place.share == 0) return from;
    const std::size_t next = (place.edge + 1) % ring_.size();
    return (1 - place.share) * from + place.share * (ring_[next] + distance * ways_[next]);
  }

 private:
  Ring ring_;
  std::vector<double> cosines_;  // of the angle by which each corner turns
  std::vector<Vec2> ways_;       // of each corner, for a distance of 1
};

std::vector<double> distances(const OpeningRings& rings) {
  std::vector<double> all;
  double thickness = rings.thickness;
  for (double distance = thickness; static_cast<int>(all.size()) < rings.count; distance += thickness) {
    all.push_back(distance);
    thickness *= rings.growth;
  }
  return all;
}

// Where cuts leave the outline.
class CutPlaces {
 public:
  CutPlaces(const Offset& offset, const OpeningRings& rings) : offset_(offset) {
    double perimeter = 0;
    for (std::size_t i = 0; i < offset.corners(); ++i) perimeter += offset.edge_length(i);
    wanted_ = perimeter / (rings.cuts > 0 ? rings.cuts : std::max(3.0, std::round(perimeter / rings.thickness)));
  }

  std::vector<OutlinePlace> find() {
    const std::size_t count = offset_.corners();
    std::size_t first = 0;
    while (first < count && !offset_.turns(first)) ++first;
    std::vector<std::size_t> run;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t edge = (first + k) % count;
      run.push_back(edge);
      if (k + 1 < count && !offset_.turns((edge + 1) % count)) continue;
      divide(run);
      run.clear();
    }
    return std::move(places_);
  }

 private:
  // At the start of the run and evenly along it; at a corner where that is nearer than round-off.
  void divide(const std::vector<std::size_t>& run) {
    constexpr double round_off = 1e-9;
    double length = 0;
    for (const std::size_t edge : run) length += offset_.edge_length(edge);
    const int parts = std::max(1, static_cast<int>(std::lround(length / wanted_)));
    double passed = 0;
    std::size_t k = 0;
    for (int i = 0; i < parts; ++i) {
      const double way = length * i / parts;
      while (k + 1 < run.size() && passed + (1 - round_off) * offset_.edge_length(run[k]) <= way)
        passed += offset_.edge_length(run[k++]);
      const double share = (way - passed) / offset_.edge_length(run[k]);
      places_.push_back({run[k], share < round_off ? 0 : share});
    }
  }

  const Offset& offset_;
  double wanted_ = 0;  // m, between cuts
  std::vector<OutlinePlace> places_;
};

Ring ring_through(const std::vector<OutlinePlace>& places, const Offset& offset, double distance) {
  Ring ring;
  for (const OutlinePlace& place : places) ring.push_back(offset.at(place, distance));
  return ring;
}

}  // namespace

// Rings have corners where cuts cross them, so that both have the same bits there.
std::vector<PlanLine> rings_around(const Ring& outline, const OpeningRings& rings) {
  const Offset offset(outline);
  const std::vector<double> all = distances(rings);
  const std::vector<OutlinePlace> cuts = CutPlaces(offset, rings).find();
  std::vector<OutlinePlace> places = cuts;
  for (std::size_t i = 0; i < offset.corners(); ++i) places.push_back({i, 0});
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<PlanLine> lines;
  for (const double distance : all) {
    Ring ring = ring_through(places, offset, distance);
    if (const auto why = defect({ring, {}}))
      throw InputError("", rings.origin, fmt::format("{:.4g} m away from the outline {}", distance, *why),
                       "fewer or thinner rings");
    ring.push_back(Vec2(ring.front()));
    lines.push_back({std::move(ring), rings.joint, rings.origin, true});
  }
  for (const OutlinePlace& cut : cuts) {
    PlanLine line{{offset.at(cut, 0)}, rings.joint, rings.origin, true};
    for (const double distance : all) line.points.push_back(offset.at(cut, distance));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace dda
