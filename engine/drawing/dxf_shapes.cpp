#include "engine/drawing/dxf_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/dxf_names.h"
#include "engine/drawing/fit_spline.h"

namespace dda {
namespace {

constexpr double radians = std::numbers::pi / 180;

// A corner of a polyline; `bulge` bends the piece to the next one.
struct Corner {
  Vec2 at = Vec2::Zero();
  double bulge = 0;
};

DrawnLine line_of(const DxfEntity& entity, const DxfPlacement& placement) {
  DrawnLine line;
  line.layer = layer_of(entity, placement);
  line.origin = entity.origin();
  line.material = entity.extended(dxf_material_key);
  return line;
}

[[noreturn]] void fail(const DxfEntity& entity, const std::string& value, const std::string& expected) {
  throw InputError("", fmt::format("{} ({})", entity.origin(), readable(entity.type())), value, expected);
}

void add_line(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  DrawnLine line = line_of(entity, placement);
  line.start = placement.at(entity.needed_point(10));
  line.pieces.push_back({placement.at(entity.needed_point(11)), nullptr});
  pencil.add(std::move(line));
}

void add_point(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  pencil.add(DrawnPoint{layer_of(entity, placement), entity.origin(), placement.at(entity.needed_point(10))});
}

// The part of an ellipse about `centre` with the half axes u and v, all in the coordinates of the entity.
void add_ellipse(const DxfEntity& entity, const DxfPlacement& placement, const Vec2& centre, const Mat2& axes,
                 double from, double to, Pencil& pencil) {
  const Mat2 placed = placement.turn * axes;
  const DrawnCurve curve = elliptic_arc(placement.at(centre), placed.col(0), placed.col(1), from, to);
  DrawnLine line = line_of(entity, placement);
  line.start = curve.at(from);
  const bool whole = to - from == 2 * std::numbers::pi;
  line.pieces.push_back({whole ? line.start : curve.at(to), std::make_shared<const DrawnCurve>(curve)});
  pencil.add(std::move(line));
}

// Where an arc that begins at `from` ends when it goes counter-clockwise to the direction `to`.
double end_after(double from, double to) {
  constexpr double turn = 2 * std::numbers::pi;
  const double sweep = std::remainder(to - from, turn);
  if (std::abs(sweep) < 1e-12) return from + turn;
  return from + (sweep > 0 ? sweep : sweep + turn);
}

void add_circle(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  const double radius = entity.needed_number(40);
  if (!(radius > 0)) fail(entity, fmt::format("of radius {}", radius), "a radius above 0");
  const Mat2 view = seen_from_above(entity);
  const bool arc = entity.type() == "ARC";
  const double from = arc ? radians * entity.needed_number(50) : 0;
  const double to = arc ? end_after(from, radians * entity.needed_number(51)) : 2 * std::numbers::pi;
  add_ellipse(entity, placement, view * entity.needed_point(10), radius * view, from, to, pencil);
}

// The centre and axes of an ellipse are given in the plane itself, and its extrusion only says which way it turns.
void add_ellipse(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  const Vec2 major = entity.needed_point(11);
  const double ratio = entity.needed_number(40);
  if (!(major.norm() > 0) || !(ratio > 0)) fail(entity, "without extent", "axes above 0");
  const double side = seen_from_above(entity).determinant();
  Mat2 axes;
  axes.col(0) = major;
  axes.col(1) = side * ratio * Vec2(-major.y(), major.x());
  const double from = entity.number(41);
  add_ellipse(entity, placement, entity.needed_point(10), axes, from, end_after(from, entity.number(42, 0)), pencil);
}

void add_corners(const DxfEntity& entity, const DxfPlacement& placement, const std::vector<Corner>& corners,
                 bool closed, Pencil& pencil) {
  if (corners.size() < 2) fail(entity, fmt::format("a line of {} points", corners.size()), "two or more");
  const Mat2 view = seen_from_above(entity);
  const auto placed = [&](std::size_t i) { return placement.at(view * corners[i % corners.size()].at); };
  DrawnLine line = line_of(entity, placement);
  line.start = placed(0);
  const std::size_t pieces = closed ? corners.size() : corners.size() - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    DrawnPiece piece{placed(i + 1), nullptr};
    const Vec2& from = corners[i].at;
    const Vec2& to = corners[(i + 1) % corners.size()].at;
    if (corners[i].bulge != 0 && from != to)
      piece.curve = std::make_shared<const DrawnCurve>(
          bulge_arc(from, to, corners[i].bulge, placement.turn * view, placement.shift));
    line.pieces.push_back(std::move(piece));
  }
  pencil.add(std::move(line));
}

bool add_light_polyline(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  std::vector<Corner> corners;
  for (const DxfGroup& group : entity.groups()) {
    if (group.code == 10)
      corners.push_back({{entity.number_of(group), missing}, 0});
    else if (group.code == 20 && !corners.empty())
      corners.back().at.y() = entity.number_of(group);
    else if (group.code == 42 && !corners.empty())
      corners.back().bulge = entity.number_of(group);
  }
  if (std::ranges::any_of(corners, [](const Corner& corner) { return std::isnan(corner.at.y()); }))
    fail(entity, "with a corner that has no group 20", "both coordinates of each");
  const auto said = static_cast<std::size_t>(std::max(0, entity.whole(90, static_cast<int>(corners.size()))));
  if (said != corners.size())
    fail(entity, fmt::format("of {} corners, and says that it has {}", corners.size(), said), "as many as it says");
  if (corners.size() == 1) return false;
  add_corners(entity, placement, corners, (entity.whole(70) & 1) != 0, pencil);
  return true;
}

// The old form: vertices are entities of their own, up to SEQEND. Corners of the frame of a smoothed line are not on
// it.
std::size_t add_old_polyline(std::span<const DxfEntity> entities, const DxfPlacement& placement, Pencil& pencil) {
  constexpr int closed = 1;
  constexpr int mesh_or_faces = 16 | 64;
  constexpr int frame_corner = 16;
  const DxfEntity& head = entities.front();
  std::vector<Corner> corners;
  std::size_t taken = 1;
  for (; taken < entities.size() && entities[taken].type() == "VERTEX"; ++taken) {
    const DxfEntity& vertex = entities[taken];
    if ((vertex.whole(70) & frame_corner) == 0) corners.push_back({vertex.needed_point(10), vertex.number(42)});
  }
  if (taken == entities.size() || entities[taken].type() != "SEQEND")
    fail(head, fmt::format("a polyline of {} vertices without an end", taken - 1), "SEQEND after its vertices");
  if ((head.whole(70) & mesh_or_faces) != 0 || corners.size() == 1) return 0;
  add_corners(head, placement, corners, (head.whole(70) & closed) != 0, pencil);
  return taken + 1;
}

// Where there are no control points. Without a tangent an end is not bent.
BSpline spline_through_fit_points(const DxfEntity& entity, const DxfPlacement& placement) {
  constexpr int closed = 1;
  const std::vector<double> x = entity.numbers(11);
  const std::vector<double> y = entity.numbers(21);
  if (x.empty()) fail(entity, "a spline without points", "control points or fit points");
  if (x.size() != y.size()) fail(entity, fmt::format("of {} fit points", x.size()), "as many x as y");
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  FitEnds ends{entity.point(12), entity.point(13), (entity.whole(70) & closed) != 0};
  auto spline = fit_spline(points, ends);
  if (!spline)
    fail(entity, fmt::format("of {} fit points", x.size()), "two different ones or more, three where it is closed");
  for (Vec2& point : spline->points) point = placement.at(point);
  return std::move(*spline);
}

BSpline spline_of(const DxfEntity& entity, const DxfPlacement& placement) {
  constexpr int highest_degree = 25;
  BSpline spline;
  spline.degree = entity.whole(71, 3);
  if (spline.degree < 1 || spline.degree > highest_degree)
    fail(entity, fmt::format("of degree {}", spline.degree), fmt::format("a degree from 1 to {}", highest_degree));
  const std::vector<double> x = entity.numbers(10);
  const std::vector<double> y = entity.numbers(20);
  if (x.empty()) return spline_through_fit_points(entity, placement);
  spline.knots = entity.numbers(40);
  if (x.size() != y.size() || x.size() <= static_cast<std::size_t>(spline.degree))
    fail(entity, fmt::format("of {} control points", x.size()), "as many x as y, and more than its degree");
  if (spline.knots.size() != x.size() + static_cast<std::size_t>(spline.degree) + 1)
    fail(entity, fmt::format("of {} knots", spline.knots.size()), "degree + 1 more than control points");
  for (std::size_t i = 0; i < x.size(); ++i) spline.points.push_back(placement.at({x[i], y[i]}));
  spline.weights = entity.numbers(41);
  if (spline.weights.empty()) spline.weights.assign(x.size(), 1.0);
  if (spline.weights.size() != x.size())
    fail(entity, fmt::format("of {} weights", spline.weights.size()), "one a point");
  return spline;
}

void add_spline(const DxfEntity& entity, const DxfPlacement& placement, Pencil& pencil) {
  const BSpline spline = spline_of(entity, placement);
  if (!std::ranges::is_sorted(spline.knots)) fail(entity, "of knots that decrease", "knots in ascending order");
  if (std::ranges::any_of(spline.weights, [](double weight) { return !(weight > 0); }))
    fail(entity, "of a weight that is not above 0", "weights above 0");
  const std::vector<DrawnCurve> spans = spans_of(spline);
  if (spans.empty()) fail(entity, "of knots that are all the same", "knots that increase");
  DrawnLine line = line_of(entity, placement);
  line.start = spans.front().at(spans.front().from);
  for (const DrawnCurve& span : spans)
    line.pieces.push_back({span.at(span.to), std::make_shared<const DrawnCurve>(span)});
  Vec2& end = line.pieces.back().end;
  constexpr double round_off = 1e-12;  // of the size, between the ends of a closed spline
  if ((end - line.start).norm() <= round_off * spans.front().size) end = line.start;
  pencil.add(std::move(line));
}

}  // namespace

std::string layer_of(const DxfEntity& entity, const DxfPlacement& placement) {
  const std::string layer = entity.text(8, "0");
  if (layer == "0") return placement.layer;
  const std::string in_full = entity.extended(dxf_layer_key);
  return !in_full.empty() && dxf_name(in_full) == layer ? in_full : layer;
}

Mat2 seen_from_above(const DxfEntity& entity) {
  const double up = entity.number(230, 1);
  constexpr double tilt = 1e-9;
  if (std::abs(entity.number(210)) > tilt || std::abs(entity.number(220)) > tilt || up == 0)
    fail(entity, "drawn in a plane that is not that of x and y", "an extrusion of (0, 0, 1) or (0, 0, -1)");
  return Vec2(up > 0 ? 1.0 : -1.0, 1).asDiagonal();
}

std::size_t draw_shape(std::span<const DxfEntity> entities, const DxfPlacement& placement, Pencil& pencil) {
  const DxfEntity& entity = entities.front();
  const std::string_view type = entity.type();
  if (type == "POLYLINE") return add_old_polyline(entities, placement, pencil);
  if (type == "LINE")
    add_line(entity, placement, pencil);
  else if (type == "POINT")
    add_point(entity, placement, pencil);
  else if (type == "CIRCLE" || type == "ARC")
    add_circle(entity, placement, pencil);
  else if (type == "ELLIPSE")
    add_ellipse(entity, placement, pencil);
  else if (type == "LWPOLYLINE")
    return add_light_polyline(entity, placement, pencil) ? 1 : 0;
  else if (type == "SPLINE")
    add_spline(entity, placement, pencil);
  else
    return 0;
  return 1;
}

}  // namespace dda
