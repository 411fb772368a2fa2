#include "engine/advice/far_coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/model/extent.h"

namespace dda {
namespace {

double farthest_coordinate(const Box& box) {
  return std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
}

// m, between a coordinate of this size and the next one.
double grid_at(double coordinate) { return std::numeric_limits<double>::epsilon() * coordinate; }

// Whether gaps of contacts follow from places of blocks.
bool has_moving_contacts(const Model& model) {
  const auto moves = [](const Stage& stage) { return stage.kinematics == Kinematics::finite; };
  const auto can_open = [](const JointMaterial& joint) { return !joint.bonded; };
  return std::ranges::any_of(model.stages, moves) && std::ranges::any_of(model.joints, can_open);
}

// Pa, of what presses on joints.
double stress_scale(const Model& model) {
  const Box box = bounding_box(model);
  double densest = 0;
  for (const Material& material : model.materials) densest = std::max(densest, material.density);
  double stress = densest * model.gravity.cwiseAbs().dot(box.upper - box.lower) / 2;
  for (const Block& block : model.blocks) stress = std::max(stress, block.initial_stress.cwiseAbs().maxCoeff());
  for (const EdgeLoad& load : model.edge_loads) stress = std::max(stress, load.traction.norm());
  return stress;
}

// m per Pa, by which the joints of the scene close; their median.
double closure_by_stress(const ContactSet& contacts) {
  std::vector<double> closures;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const double stiffness = contacts.elements.but_for_blocks(i).stiffness(0);
    if (stiffness > 0 && contacts.interfaces[i].share > 0) closures.push_back(contacts.interfaces[i].share / stiffness);
  }
  if (closures.empty()) return 0;
  const auto middle = closures.begin() + static_cast<std::ptrdiff_t>(closures.size() / 2);
  std::ranges::nth_element(closures, middle);
  return *middle;
}

// The middle of the scene in round numbers: what is left of it is no larger than the scene.
double round_shift(double lower, double upper) {
  const double size = std::max(upper - lower, 1e-9 * std::abs(upper));
  const double unit = std::pow(10.0, std::floor(std::log10(size)));
  const double shift = std::round((lower + upper) / 2 / unit) * unit;
  return std::abs(shift) > 2 * size ? shift : 0;
}

}  // namespace

double coarseness_of_places(const Model& model, const ContactSet& contacts) {
  if (!has_moving_contacts(model)) return 0;
  const double closure = stress_scale(model) * closure_by_stress(contacts);
  return closure > 0 ? grid_at(farthest_coordinate(bounding_box(model))) / closure : 0;
}

std::vector<std::string> far_coordinates(const Model& model, const ContactSet& contacts) {
  const double coarseness = coarseness_of_places(model, contacts);
  if (coarseness <= tolerated_coarseness) return {};
  const Box box = bounding_box(model);
  const double farthest = farthest_coordinate(box);
  const Vec2 shift(round_shift(box.lower.x(), box.upper.x()), round_shift(box.lower.y(), box.upper.y()));
  if (shift.isZero(0)) return {};
  return {
      fmt::format("coordinates of up to {:.3g} m are held to {:.1g} m, which is {:.2g} of what joints close by: "
                  "contact forces lose "
                  "digits; take {:.15g} off every x and {:.15g} off every y",
                  farthest, grid_at(farthest), coarseness, shift.x(), shift.y())};
}

}  // namespace dda
