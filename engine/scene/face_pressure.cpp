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
  surface_ = surface->quantity(Dimension::length);
  gradient_ = field.at("gradient").positive(Dimension::stiffness_per_area);
  bends_ = {surface_};
}

void FacePressure::read_table(const Field& rows) {
  for (const Field& row : rows.items()) {
    const Vec2 pair = row.vector(Dimension::length, Dimension::stress);
    if (!bends_.empty() && pair.x() <= bends_.back()) row.fail("a greater height than that of the row before");
    bends_.push_back(pair.x());
    table_.times.push_back(pair.x());
    table_.values.push_back(pair.y());
  }
}

double FacePressure::at(double height) const {
  if (!table_.times.empty()) return evaluate(TimeFunction(table_), height);
  return uniform_ + gradient_ * std::max(0.0, surface_ - height);
}

std::vector<PressedPart> FacePressure::on(const Stretch& stretch) const {
  const double rise = stretch.to.y() - stretch.from.y();
  const auto [low, high] = std::minmax(stretch.from.y(), stretch.to.y());
  if (!table_.times.empty() && (low < bends_.front() || high > bends_.back()))
    field_.at("table").fail(fmt::format("from {:.6g} to {:.6g} m beside a face from {:.6g} to {:.6g} m", bends_.front(),
                                        bends_.back(), low, high),
                            "heights that reach past all faces on which it acts");
  std::vector<double> shares = {0, 1};  // of the way from its start to its end
  for (const double bend : bends_)
    if (bend > low && bend < high) shares.push_back((bend - stretch.from.y()) / rise);
  std::ranges::sort(shares);
  std::vector<PressedPart> parts;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const auto place = [&](double share) -> Vec2 { return stretch.from + share * (stretch.to - stretch.from); };
    const Vec2 from = place(shares[i - 1]), to = i + 1 == shares.size() ? stretch.to : place(shares[i]);
    const PressedPart part{from, to, at(from.y()), at(to.y())};
    const bool is_pressed = bends_.empty() || part.at_from != 0 || part.at_to != 0;
    if (from != to && is_pressed) parts.push_back(part);
  }
  return parts;
}

}  // namespace dda
