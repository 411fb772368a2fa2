// Joint sets: parallel lines of traces, with deviations.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/cutting/random_stream.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

struct JointSet {
  std::string name;
  std::string joint;
  // rad, direction of the traces, counter-clockwise from +x. Lines have the mean; each trace turns about its middle.
  RandomQuantity dip;
  RandomQuantity spacing;                // m, between lines, across the mean direction
  std::optional<RandomQuantity> length;  // m, of traces; none: from one side of the rock to the other
  RandomQuantity bridge;                 // m, of intact rock between traces of a line
  std::optional<Vec2> start;             // a point on the first line, the middle of its first trace; none: anywhere
  Ring region;                           // traces lie inside; empty: the whole rock
  std::vector<std::string> ends_at;      // names of earlier sets, at whose traces these end
  std::string origin;                    // for messages
};

inline constexpr std::size_t most_traces = 2'000'000;

// The traces of all sets that can meet the boundary's box, in the order of the sets. A set draws its own random
// numbers: what one set looks like does not depend on the others. Throws InputError when there would be too many.
std::vector<PlanLine> traces_of(const std::vector<JointSet>& sets, const Ring& boundary, std::uint64_t seed);

}  // namespace dda
