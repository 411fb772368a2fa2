// Where along a segment another one crosses it.
#pragma once

#include <optional>

#include "engine/geometry/segment.h"

namespace dda {

// As a share of `segment`, ends included; nothing for segments that are parallel or do not meet.
inline std::optional<double> share_at_crossing(const Segment& segment, const Segment& other) {
  const Vec2 along = segment.end - segment.start;
  const Vec2 across = other.end - other.start;
  const double whole = cross(along, across);
  if (whole == 0) return std::nullopt;
  const Vec2 between = other.start - segment.start;
  const double share = cross(between, across) / whole;
  const double other_share = cross(between, along) / whole;
  if (share < 0 || share > 1 || other_share < 0 || other_share > 1) return std::nullopt;
  return share;
}

// The same without the ends of `segment`.
inline std::optional<double> share_at_inner_crossing(const Segment& segment, const Segment& other) {
  const auto share = share_at_crossing(segment, other);
  return share && *share > 0 && *share < 1 ? share : std::nullopt;
}

}  // namespace dda
