// Lines of an outline that do not close as they are drawn: they run along each other, or beyond their corners.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/cutting/cleaned.h"
#include "engine/drawing/open_line.h"

namespace dda {

struct MendedLines {
  std::vector<OpenLine> lines;
  std::vector<Cleaned> cleaned;
};

// Without stretches that run along another line within `reach` (m), of which the longer piece stays, and without ends
// that stick out beyond a corner by no more than that.
MendedLines mended_lines(const std::vector<OpenLine>& lines, double reach);

// Why an end that meets no other is left open, where a line sticks out there beyond the place where it meets another,
// by more than `reach` (m): that of the end itself, or one on which the end lies.
std::optional<Gap> overshoot_at(const std::vector<OpenLine>& lines, std::size_t line, bool at_last, double reach);

}  // namespace dda
