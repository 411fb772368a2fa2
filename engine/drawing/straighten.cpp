#include "engine/drawing/straighten.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/error.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/diameter.h"

namespace dda {
namespace {

constexpr double most_chords = 100'000;          // of one stretch of a curve
constexpr std::size_t most_points = 20'000'000;  // of a drawing

// A corner of chords that some line asks for.
struct Seat {
  double parameter;
  Vec2 place;
};

// Where a line starts, ends or turns, or a point.
struct Place {
  Vec2 corner;
  Vec2 other;  // the other end of the straight piece that ends there, for an end of a line; else the corner itself
};

Box box_of(const DrawnCurve& curve) {
  constexpr int steps = 16;
  const double step = (curve.to - curve.from) / steps;
  Box box;
  for (int i = 0; i <= steps; ++i) box = expanded(box, curve.at(curve.from + i * step));
  return expanded(box, curve.bend * step * step / 8);
}

class Straightener {
 public:
  Straightener(const LineDrawing& drawing, const ChordTolerance& tolerance, double reach)
      : tolerance_(tolerance), reach_(reach), corners_(corner_boxes(drawing)) {}

  std::vector<Vec2> points_of(const DrawnLine& line) {
    std::vector<Vec2> points{line.start};
    for (const DrawnPiece& piece : line.pieces) {
      if (piece.curve) append_chords(*piece.curve, line.origin, points);
      points.push_back(piece.end);
    }
    if (!std::ranges::all_of(points, [](const Vec2& point) { return point.allFinite(); }))
      throw InputError("", line.origin, "a curve without end", "finite coordinates");
    total_ += points.size();
    if (total_ > most_points) refuse(line.origin);
    return points;
  }

 private:
  std::vector<Box> corner_boxes(const LineDrawing& drawing) {
    std::vector<Box> boxes;
    const auto add = [&](const Vec2& corner, const Vec2& other) {
      places_.push_back({corner, other});
      boxes.push_back({corner, corner});
    };
    for (const DrawnLine& line : drawing.lines) {
      const DrawnPiece& first = line.pieces.front();
      add(line.start, first.curve ? line.start : first.end);
      for (std::size_t i = 0; i + 1 < line.pieces.size(); ++i) add(line.pieces[i].end, line.pieces[i].end);
      const DrawnPiece& last = line.pieces.back();
      const Vec2& before = line.pieces.size() > 1 ? line.pieces[line.pieces.size() - 2].end : line.start;
      add(last.end, last.curve ? last.end : before);
    }
    for (const DrawnPoint& point : drawing.points) add(point.at, point.at);
    return boxes;
  }

  // Where the chords of the curve get a corner for the sake of the place. A line that crosses the curve and ends
  // between it and its chord would end inside a block, although as drawn it does not.
  void add_seat(const DrawnCurve& curve, const Place& place, double beside, std::vector<Seat>& seats) const {
    const double parameter = parameter_near(curve, place.corner, reach_);
    if (!std::isnan(parameter)) return seats.push_back({parameter, place.corner});
    if (place.corner == place.other) return;
    const double crossed = parameter_crossed(curve, place.corner, place.other, beside);
    if (std::isnan(crossed)) return;
    const Vec2 crossing = curve.at(crossed);
    const auto is_end = [&](double end) { return (curve.at(end) - crossing).norm() <= reach_; };
    if (!is_end(curve.from) && !is_end(curve.to)) seats.push_back({crossed, crossing});
  }

  // In the order of parameters, each at a place of its own.
  [[nodiscard]] std::vector<Seat> seats_on(const DrawnCurve& curve) const {
    std::vector<Seat> seats;
    const double beside = allowed_beside(curve, tolerance_);
    const Box box = expanded(box_of(curve), std::max(reach_, beside));
    if (!box.lower.allFinite() || !box.upper.allFinite()) return seats;
    for (const int corner : corners_.overlapping(box))
      add_seat(curve, places_[static_cast<std::size_t>(corner)], beside, seats);
    std::ranges::sort(seats, {}, &Seat::parameter);
    const auto same = [this](const Seat& a, const Seat& b) { return (a.place - b.place).norm() <= reach_; };
    seats.erase(std::unique(seats.begin(), seats.end(), same), seats.end());
    return seats;
  }

  // Without the ends of the curve.
  void append_chords(const DrawnCurve& curve, const std::string& origin, std::vector<Vec2>& points) const {
    double from = curve.from;
    for (const Seat& seat : seats_on(curve)) {
      append_between(curve, from, seat.parameter, origin, points);
      points.push_back(seat.place);
      from = seat.parameter;
    }
    append_between(curve, from, curve.to, origin, points);
  }

  void append_between(const DrawnCurve& curve, double from, double to, const std::string& origin,
                      std::vector<Vec2>& points) const {
    const double chords = chords_needed(curve, from, to, tolerance_);
    if (!(chords <= most_chords)) refuse(origin);
    for (int i = 1; i < static_cast<int>(chords); ++i) points.push_back(curve.at(from + (to - from) * i / chords));
  }

  [[noreturn]] static void refuse(const std::string& origin) {
    throw InputError("", origin, "a curve of more chords than can be cut", "a larger chord_tolerance");
  }

  const ChordTolerance& tolerance_;
  double reach_;
  std::vector<Place> places_;
  BoxIndex corners_;
  std::size_t total_ = 0;
};

}  // namespace

std::vector<std::vector<Vec2>> straightened(const LineDrawing& drawing, const ChordTolerance& tolerance, double reach) {
  Straightener straightener(drawing, tolerance, reach);
  std::vector<std::vector<Vec2>> lines;
  lines.reserve(drawing.lines.size());
  for (const DrawnLine& line : drawing.lines) lines.push_back(straightener.points_of(line));
  return lines;
}

double diameter_of(const LineDrawing& drawing) {
  std::vector<Vec2> points;
  for (const DrawnLine& line : drawing.lines) {
    points.push_back(line.start);
    for (const DrawnPiece& piece : line.pieces) {
      points.push_back(piece.end);
      if (piece.curve) points.push_back(piece.curve->at((piece.curve->from + piece.curve->to) / 2));
    }
  }
  return diameter(std::move(points));
}

}  // namespace dda
