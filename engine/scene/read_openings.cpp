#include "engine/scene/read_openings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/cutting/opening_shapes.h"
#include "engine/scene/block_group.h"
#include "engine/scene/places.h"

namespace dda {
namespace {

constexpr double default_chord_tolerance = 0.01;  // of the radius or half the width

double length_at(const Field& field, const char* key) { return field.at(key).positive(Dimension::length); }

Vec2 place_of(const Field& field, const char* key) {
  return value_or(field, key, Vec2(Vec2::Zero()), [](const Field& f) { return f.vector(Dimension::length); });
}

// How far chords may leave the arcs of an opening of this half width.
double chord_tolerance(const Field& opening, double half_width) {
  constexpr double least = 1e-6;  // of the half width: 2,222 chords around a circle
  return value_or(
      opening, "chord_tolerance", default_chord_tolerance * half_width, [least, half_width](const Field& f) {
        const double tolerance = f.positive(Dimension::length);
        if (tolerance < least * half_width)
          f.fail(fmt::format("at least {:.3g} m, {:g} of the radius or half the width", least * half_width, least));
        return tolerance;
      });
}

Ring read_arch(const Field& opening, const Field& shape) {
  const double width = length_at(shape, "width");
  const double height = length_at(shape, "height");
  const double rise = value_or(shape, "rise", width / 2, [](const Field& f) { return f.positive(Dimension::length); });
  if (rise > width / 2) shape.at("rise").fail("at most half of the width");
  if (rise > height) shape.at("height").fail("at least the rise of the roof");
  return arch(place_of(shape, "foot"), width, height, rise, chord_tolerance(opening, width / 2));
}

Ring read_horseshoe(const Field& opening, const Field& shape) {
  const double width = length_at(shape, "width");
  const double height = length_at(shape, "height");
  if (height < width / 2 || height > most_horseshoe * width) shape.at("height").fail("0.5 to 1.36 of the width");
  return horseshoe(place_of(shape, "foot"), width, height, chord_tolerance(opening, width / 2));
}

Ring read_outline(const Field& opening, const std::string& kind) {
  const Field shape = opening.at(kind);
  if (kind == "polygon") return read_ring(shape);
  if (kind == "arch") return read_arch(opening, shape);
  if (kind == "horseshoe") return read_horseshoe(opening, shape);
  if (kind == "rectangle")
    return rectangle(place_of(shape, "foot"), length_at(shape, "width"), length_at(shape, "height"));
  const double radius = length_at(shape, "radius");
  return circle(place_of(shape, "centre"), radius, chord_tolerance(opening, radius));
}

}  // namespace

PlanOpening read_opening(const Field& field, const Model& model) {
  const std::vector<std::string> kinds{"circle", "rectangle", "arch", "horseshoe", "polygon"};
  std::vector<std::string> given;
  std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(given),
               [&](const auto& kind) { return field.has(kind); });
  if (given.size() != 1)
    throw InputError("", field.path(), given.empty() ? "without a shape" : "of several shapes",
                     "one of circle, rectangle, arch, horseshoe and polygon");
  PlanOpening opening;
  opening.name = field.at("name").name();
  opening.origin = field.path();
  opening.outline = read_outline(field, given.front());
  opening.left_out = value_or(field, "left_out", false, [](const Field& f) { return f.truth(); });
  if (const auto joint = field.find("joint"))
    opening.joint = model.joints[static_cast<std::size_t>(read_joint_reference(*joint, model))].name;
  return opening;
}

}  // namespace dda
