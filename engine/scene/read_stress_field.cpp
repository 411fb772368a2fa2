#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/places.h"
#include "engine/scene/stress_field.h"

namespace dda {
namespace {

double read_k0(const Field& field) {
  return value_or(field, "k0", 1.0, [](const Field& f) { return f.not_negative(Dimension::dimensionless); });
}

double weight_of(double density, const Field& field, const Model& model) {
  if (!(model.gravity.y() < 0)) field.fail("gradient instead, as the scene has no gravity that points down");
  return -model.gravity.y() * density;
}

double density_of_material(const Field& field, const Model& model) {
  const std::string name = field.name();
  const auto found = std::ranges::find(model.materials, name, &Material::name);
  if (found == model.materials.end()) field.fail("the name of a material of the scene");
  return found->density;
}

// By which vertical pressure grows with depth, Pa/m.
double read_gradient(const Field& field, const Model& model) {
  const auto gradient = field.find("gradient");
  const auto density = field.find("density");
  const auto material = field.find("material");
  if (gradient) refuse(field, {"density", "material"}, "beside gradient");
  if (density) refuse(field, {"material"}, "beside density");
  if (gradient) return gradient->positive(Dimension::stiffness_per_area);
  if (density) return weight_of(density->positive(Dimension::mass_density), *density, model);
  if (material) return weight_of(density_of_material(*material, model), *material, model);
  throw InputError("", field.path(), "without gradient and density", "one of them beside surface");
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
    refuse(*field, {"gradient", "density", "k0", "layers"}, "without surface, from which depth is counted");
    return;
  }
  surface_ = surface->quantity(Dimension::length);
  if (field->has("layers")) {
    refuse(*field, {"gradient", "density", "k0"}, "beside layers, each of which has its own");
    layers_ = read_layers(field->at("layers"), model, surface_);
  } else {
    layers_ = {{-std::numeric_limits<double>::infinity(), read_gradient(*field, model), read_k0(*field)}};
  }
}

std::vector<StressField::Layer> StressField::read_layers(const Field& field, const Model& model, double surface) {
  std::vector<Layer> layers;
  const std::vector<Field> entries = field.items();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Field& entry = entries[i];
    const auto bottom = entry.find("down_to");
    const bool is_last = i + 1 == entries.size();
    if (!bottom && !is_last) entry.fail("without down_to", "one: only the last layer has no end");
    if (bottom && is_last) bottom->fail("none in the last layer, which goes on below all others");
    const double above = layers.empty() ? surface : layers.back().bottom;
    const double y = bottom ? bottom->quantity(Dimension::length) : -std::numeric_limits<double>::infinity();
    if (y >= above) bottom->fail(fmt::format("below {:g} m, where the layer begins", above));
    layers.push_back({y, read_gradient(entry, model), read_k0(entry)});
  }
  return layers;
}

// The weight of what lies above, and of it the share that the layer there has sideways.
Vec3 StressField::of_depth(double y) const {
  const auto own = std::ranges::find_if(layers_, [y](const Layer& layer) { return y >= layer.bottom; });
  Vec3 stress = Vec3::Zero();
  double top = surface_;
  for (auto layer = layers_.begin(); layer != layers_.end() && top > y; ++layer) {
    stress += (std::max(y, layer->bottom) - top) * (layer->gradient * Vec3(own->k0, 1, 0));
    top = layer->bottom;
  }
  return stress;
}

Vec3 StressField::at(const Vec2& point) const { return constant_ + of_depth(point.y()); }

void StressField::fill(Model& model) const {
  const std::vector<bool> absent = model.absent_in(0);  // what comes in later brings no stress along
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (!own_stress_[i] && (absent.empty() || !absent[i]))
      model.blocks[i].initial_stress = at(model.blocks[i].moments.centroid);
}

std::optional<std::string> StressField::remark_on_surface(const Model& model) const {
  if (layers_.empty()) return std::nullopt;
  bool is_for_any = false;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (own_stress_[i]) continue;
    if (model.blocks[i].moments.centroid.y() < surface_) return std::nullopt;
    is_for_any = true;
  }
  if (!is_for_any) return std::nullopt;
  return fmt::format(
      "stress_field: its surface, at y = {:g} m, lies below the middles of all blocks, so none has a "
      "pressure that grows with depth",
      surface_);
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
