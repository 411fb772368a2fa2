// Lines end to end into closed ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cutting/cleaned.h"
#include "engine/drawing/open_line.h"
#include "engine/geometry/polygon.h"

namespace dda {

struct JoinedRing {
  Ring ring;           // the first vertex is not repeated
  std::string origin;  // of the first of its lines
};

struct Joined {
  std::vector<JoinedRing> rings;
  std::optional<Gap> gap;  // the first one; no ring goes through it
  std::vector<Cleaned> cleaned;
};

// Ends nearer than `reach` (m) belong together. Lines drawn twice count once, lines shorter than that not at all, and
// corners nearer than that are one; all that is listed, but for what is nearer than round-off. Where more or fewer than
// two ends meet there is a gap, which is mended where lines run along each other or stick out by less than that.
Joined join_lines(const std::vector<OpenLine>& lines, double reach);

// What is wrong with a drawing of which nothing is left then, for messages.
std::string smaller_than_one_place(double reach);

}  // namespace dda
