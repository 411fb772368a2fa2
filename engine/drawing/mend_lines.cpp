#include "engine/drawing/mend_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/core/error.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/nearness.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

using Stretches = std::vector<std::pair<double, double>>;  // shares of a piece

double length_of(const Segment& piece) { return (piece.end - piece.start).norm(); }

struct Pieces {
  std::vector<Segment> all;        // of one line after the other
  std::vector<std::size_t> lines;  // of each
  std::vector<std::size_t> first;  // of each line; at the end, how many there are
};

Pieces pieces_of(const std::vector<OpenLine>& lines) {
  Pieces pieces;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    pieces.first.push_back(pieces.all.size());
    const std::vector<Vec2>& points = lines[line].points;
    for (std::size_t i = 1; i < points.size(); ++i) pieces.all.push_back({points[i - 1], points[i]});
    pieces.lines.resize(pieces.all.size(), line);
  }
  pieces.first.push_back(pieces.all.size());
  return pieces;
}

std::vector<Box> boxes_of(const std::vector<Segment>& pieces, double reach) {
  std::vector<Box> boxes;
  for (const Segment& piece : pieces) boxes.push_back(edge_box(piece, reach));
  return boxes;
}

// Returns what of each piece runs along longer ones, from its start on.
std::vector<Stretches> covered_stretches(const std::vector<Segment>& pieces, double reach) {
  std::vector<Stretches> covered(pieces.size());
  for (const auto& [i, j] : overlapping_pairs(boxes_of(pieces, reach))) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    const bool is_first_shorter = length_of(pieces[a]) < length_of(pieces[b]);
    const std::size_t shorter = is_first_shorter ? a : b;
    const std::size_t longer = is_first_shorter ? b : a;
    if (const auto common = collinear_overlap(pieces[shorter], pieces[longer], reach))
      covered[shorter].emplace_back(closest_parameter(pieces[shorter], common->first),
                                    closest_parameter(pieces[shorter], common->second));
  }
  for (Stretches& stretches : covered) std::ranges::sort(stretches);
  return covered;
}

// A line without its covered stretches, as the lines that are left of it.
class Remains {
 public:
  Remains(const OpenLine& line, double reach, MendedLines& mended) : line_(line), reach_(reach), mended_(mended) {}
  ~Remains() { end(); }

  void add(const Segment& piece, const Stretches& covered) {
    double reached = 0;
    for (const auto& [from, to] : covered) {
      if (to <= reached) continue;
      const double begin = std::max(from, reached);
      keep(piece, reached, begin);
      end();
      mended_.cleaned.push_back({Cleaning::lines_overlap, point_at(piece, begin), point_at(piece, to),
                                 (to - begin) * length_of(piece), line_.origin});
      reached = to;
    }
    keep(piece, reached, 1);
  }

 private:
  // A rest no longer than the tolerance is none: its ends are one place.
  void keep(const Segment& piece, double from, double to) {
    if ((from > 0 || to < 1) && (to - from) * length_of(piece) <= reach_) return;
    if (points_.empty()) points_.push_back(point_at(piece, from));
    points_.push_back(to < 1 ? point_at(piece, to) : piece.end);
  }

  void end() {
    if (points_.size() > 1) mended_.lines.push_back({std::move(points_), line_.origin});
    points_.clear();
  }

  const OpenLine& line_;
  double reach_;
  MendedLines& mended_;
  std::vector<Vec2> points_;
};

MendedLines without_overlaps(const std::vector<OpenLine>& lines, double reach) {
  const Pieces pieces = pieces_of(lines);
  const std::vector<Stretches> covered = covered_stretches(pieces.all, reach);
  MendedLines mended;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    Remains remains(lines[line], reach, mended);
    for (std::size_t i = pieces.first[line]; i < pieces.first[line + 1]; ++i) remains.add(pieces.all[i], covered[i]);
  }
  return mended;
}

// An end that sticks out beyond the place where its line meets another.
struct Overshoot {
  Vec2 corner;
  double length = 0;      // m, from there to the end
  std::size_t other = 0;  // the line that it meets
};

// Returns where both pieces meet; where the other one ends on this one it is that end, to the bit.
std::optional<Vec2> meeting(const Segment& own, const Segment& other, double reach) {
  constexpr double round_off = 1e-12;  // of the length
  for (const Vec2& end : {other.start, other.end}) {
    if (distance(own, end) <= round_off * length_of(own)) return end;
  }
  if (auto crossing = proper_intersection(own, other)) return crossing;
  for (const Vec2& end : {other.start, other.end}) {
    if (distance(own, end) <= reach) return closest_point(own, end);
  }
  return std::nullopt;
}

// Finds where the line's piece at that end meets one of `numbers` in its outer half, nearest to the end; else nothing.
template <typename Numbers>
std::optional<Overshoot> overshoot_of(const Pieces& pieces, std::size_t line, bool at_last, const Numbers& numbers,
                                      double reach) {
  const std::size_t number = at_last ? pieces.first[line + 1] - 1 : pieces.first[line];
  const Segment& piece = pieces.all[number];
  const Segment own = at_last ? piece : Segment{piece.end, piece.start};
  std::optional<Overshoot> found;
  for (const auto each : numbers) {
    const auto other = static_cast<std::size_t>(each);
    const auto corner = other == number ? std::nullopt : meeting(own, pieces.all[other], reach);
    if (!corner) continue;
    const double length = (own.end - *corner).norm();
    if (length < (found ? found->length : length_of(own) / 2)) found = Overshoot{*corner, length, pieces.lines[other]};
  }
  return found;
}

// Ends that are near no other: two of each line, as a place and a number.
std::vector<bool> are_alone(const std::vector<OpenLine>& lines, double reach) {
  std::vector<Vec2> ends;
  for (const OpenLine& line : lines) ends.insert(ends.end(), {line.points.front(), line.points.back()});
  std::vector<Box> boxes;
  for (const Vec2& end : ends) boxes.push_back(expanded(Box{end, end}, reach / 2));
  std::vector<bool> alone(ends.size(), true);
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    if ((ends[a] - ends[b]).norm() <= reach) alone[a] = alone[b] = false;
  }
  return alone;
}

void trim(OpenLine& line, bool at_last, const Overshoot& overshoot, std::vector<Cleaned>& cleaned) {
  Vec2& end = at_last ? line.points.back() : line.points.front();
  cleaned.push_back({Cleaning::dangle_trimmed, overshoot.corner, end, overshoot.length, line.origin});
  end = overshoot.corner;
}

}  // namespace

MendedLines mended_lines(const std::vector<OpenLine>& lines, double reach) {
  MendedLines mended = without_overlaps(lines, reach);
  const std::vector<bool> alone = are_alone(mended.lines, reach);
  const Pieces pieces = pieces_of(mended.lines);
  const BoxIndex index(boxes_of(pieces.all, reach));
  for (std::size_t end = 0; end < alone.size(); ++end) {
    if (!alone[end]) continue;
    const bool at_last = end % 2 == 1;
    OpenLine& line = mended.lines[end / 2];
    const Vec2& place = at_last ? line.points.back() : line.points.front();
    const std::vector<int> near = index.overlapping(expanded(Box{place, place}, reach));
    const auto overshoot = overshoot_of(pieces, end / 2, at_last, near, reach);
    if (overshoot && overshoot->length <= reach) trim(line, at_last, *overshoot, mended.cleaned);
  }
  return mended;
}

std::optional<Gap> overshoot_at(const std::vector<OpenLine>& lines, std::size_t line, bool at_last, double reach) {
  const Pieces pieces = pieces_of(lines);
  const Vec2 place = at_last ? lines[line].points.back() : lines[line].points.front();
  std::vector<std::size_t> all(pieces.all.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::pair<std::size_t, bool>> ends{{line, at_last}};
  for (const std::size_t i : all) {
    if (pieces.lines[i] == line || distance(pieces.all[i], place) > reach) continue;
    ends.insert(ends.end(), {{pieces.lines[i], false}, {pieces.lines[i], true}});
  }
  for (const auto& [each, is_last] : ends) {
    const auto found = overshoot_of(pieces, each, is_last, all, reach);
    const bool is_there = each == line || (found && (found->corner - place).norm() <= reach);
    if (!found || !is_there || found->length <= reach) continue;
    return Gap{lines[each].origin,
               fmt::format("too long: it ends {:.4g} m beyond the corner at {}, where it meets {}", found->length,
                           written(found->corner), lines[found->other].origin),
               "a line that ends at the corner, or a larger \"tolerance\" of the rock in a scene"};
  }
  return std::nullopt;
}

}  // namespace dda
