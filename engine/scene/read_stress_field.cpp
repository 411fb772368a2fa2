#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/scene/places.h"
#include "engine/scene/stress_field.h"

namespace dda {
namespace {

// By which vertical pressure grows with depth, Pa/m.
double read_gradient(const Field& field, const Model& model) {
  if (field.has("gradient")) {
    refuse(field, {"density"}, "beside gradient");
    return field.at("gradient").positive(Dimension::stiffness_per_area);
  }
  const double gravity = -model.gravity.y();
  const auto density = field.find("density");
  if (!density) throw InputError("", field.path(), "without gradient and density", "one of them beside surface");
  if (!(gravity > 0)) density->fail("gradient instead, as the scene has no gravity that points down");
  return gravity * density->positive(Dimension::mass_density);
}

}  // namespace

Vec3 read_stress(const Field& field) {
  const auto stress = [](const Field& f) { return f.quantity(Dimension::stress); };
  return {value_or(field, "xx", 0.0, stress), value_or(field, "yy", 0.0, stress), value_or(field, "xy", 0.0, stress)};
}

StressField::StressField(const Field& scene, std::vector<bool> own_stress, const Model& model)
    : own_stress_(std::move(own_stress)) {
  const auto field = scene.find("stress_field");
  if (!field) return;
  constant_ = read_stress(*field);
  const auto surface = field->find("surface");
  if (!surface) {
    refuse(*field, {"gradient", "density", "k0"}, "without surface, from which depth is counted");
    return;
  }
  surface_ = surface->quantity(Dimension::length);
  const double gradient = read_gradient(*field, model);
  const double k0 =
      value_or(*field, "k0", 1.0, [](const Field& f) { return f.not_negative(Dimension::dimensionless); });
  slope_ = gradient * Vec3(k0, 1, 0);
}

Vec3 StressField::at(const Vec2& point) const { return constant_ + std::min(0.0, point.y() - surface_) * slope_; }

void StressField::fill(Model& model) const {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (!own_stress_[i]) model.blocks[i].initial_stress = at(model.blocks[i].moments.centroid);
}

void StressField::leave_to_themselves(const std::vector<int>& blocks) {
  for (const int block : blocks) own_stress_[static_cast<std::size_t>(block)] = true;
}

Vec2 StressField::traction_on(const Stretch& stretch, const Model& model) const {
  const Vec3 stress = states_own(stretch.block) ? model.blocks[static_cast<std::size_t>(stretch.block)].initial_stress
                                                : at((stretch.from + stretch.to) / 2);
  return dda::traction_on(stress, -stretch.inward);
}

}  // namespace dda
