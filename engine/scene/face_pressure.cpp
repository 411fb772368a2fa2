#include "engine/scene/face_pressure.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error.h"
#include "engine/scene/places.h"

namespace dda {

FacePressure::FacePressure(const Field& field) : field_(field) {
  if (!field.is_object()) {
    uniform_ = field.quantity(Dimension::stress);
    return;
  }
  if (const auto rows = field.find("table")) {
    refuse(field, {"uniform", "surface", "gradient"}, "beside table");
    read_table(*rows);
    return;
  }
  uniform_ = value_or(field, "uniform", 0.0, [](const Field& f) { return f.quantity(Dimension::stress); });
  const auto surface = field.find("surface");
  if (surface.has_value() != field.has("gradient"))
    throw InputError("", field.path(), surface ? "without gradient" : "without surface",
                     "both of them, for a pressure that grows with depth below a surface");
  if (!surface) return;
  read_surface(*surface);
  gradient_ = field.at("gradient").positive(Dimension::stiffness_per_area);
}

// One height, or straight lines between places, and as high as the first and the last beyond these.
void FacePressure::read_surface(const Field& surface) {
  if (!surface.is_array()) {
    surface_ = {{0}, {surface.quantity(Dimension::length)}};
    return;
  }
  for (const Field& row : surface.items()) {
    const Vec2 place = row.vector(Dimension::length);
    if (!surface_.times.empty() && place.x() <= surface_.times.back())
      row.fail("a place further to the right than the one before");
    surface_.times.push_back(place.x());
    surface_.values.push_back(place.y());
  }
}

void FacePressure::read_table(const Field& rows) {
  for (const Field& row : rows.items()) {
    const Vec2 pair = row.vector(Dimension::length, Dimension::stress);
    if (!table_.times.empty() && pair.x() <= table_.times.back())
      row.fail("a greater height than that of the row before");
    table_.times.push_back(pair.x());
    table_.values.push_back(pair.y());
  }
}

void FacePressure::check_reach(const Stretch& stretch) const {
  if (table_.times.empty()) return;
  const auto [low, high] = std::minmax(stretch.from.y(), stretch.to.y());
  if (low >= table_.times.front() && high <= table_.times.back()) return;
  field_.at("table").fail(fmt::format("from {:.6g} to {:.6g} m beside a face from {:.6g} to {:.6g} m",
                                      table_.times.front(), table_.times.back(), low, high),
                          "heights that reach past all faces on which it acts");
}

// Below the surface; negative above it.
double FacePressure::depth(const Vec2& place) const { return evaluate(TimeFunction(surface_), place.x()) - place.y(); }

double FacePressure::at(const Vec2& place) const {
  if (!table_.times.empty()) return evaluate(TimeFunction(table_), place.y());
  return uniform_ + (surface_.times.empty() ? 0 : gradient_ * std::max(0.0, depth(place)));
}

// Where the pressure has corners along a stretch, as shares of the way, ascending from 0 to 1.
std::vector<double> FacePressure::corners_on(const Stretch& stretch) const {
  const Vec2 way = stretch.to - stretch.from;
  std::vector<double> shares = {0, 1};
  const auto add = [&shares](double share) {
    if (share > 0 && share < 1) shares.push_back(share);
  };
  if (way.y() != 0)
    for (const double height : table_.times) add((height - stretch.from.y()) / way.y());
  if (way.x() != 0 && surface_.times.size() > 1)
    for (const double x : surface_.times) add((x - stretch.from.x()) / way.x());
  std::ranges::sort(shares);
  if (surface_.times.empty()) return shares;
  for (std::size_t i = shares.size() - 1; i > 0; --i) {  // where it comes out of the water
    const double before = depth(stretch.from + shares[i - 1] * way), after = depth(stretch.from + shares[i] * way);
    if (before * after < 0) add(shares[i - 1] + (shares[i] - shares[i - 1]) * before / (before - after));
  }
  std::ranges::sort(shares);
  return shares;
}

// Round-off may leave the end of a dry part a little below the surface.
bool FacePressure::presses(const PressedPart& part) const {
  if (!surface_.times.empty() && uniform_ == 0) return depth((part.from + part.to) / 2) > 0;
  return surface_.times.size() + table_.times.size() == 0 || part.at_from != 0 || part.at_to != 0;
}

std::vector<PressedPart> FacePressure::on(const Stretch& stretch) const {
  check_reach(stretch);
  const std::vector<double> shares = corners_on(stretch);
  std::vector<PressedPart> parts;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const auto place = [&](double share) -> Vec2 { return stretch.from + share * (stretch.to - stretch.from); };
    const Vec2 from = place(shares[i - 1]), to = i + 1 == shares.size() ? stretch.to : place(shares[i]);
    const PressedPart part{from, to, at(from), at(to)};
    if (from != to && presses(part)) parts.push_back(part);
  }
  return parts;
}

}  // namespace dda
