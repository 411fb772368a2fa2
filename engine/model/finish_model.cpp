#include <utility>

#include "dda/core/error.h"
#include "dda/geometry/box.h"
#include "dda/model/check_parts.h"
#include "dda/model/model.h"

namespace dda {
namespace {

// Coordinates carry a round-off of 1e-16 of the extent; those that were computed on the way a little more.
constexpr double tolerance_of_extent = 1e-9;

double extent(const Model& model) {
  Box box;
  for (const Block& block : model.blocks) {
    const Box own = bounding_box(block.shape);
    box = expanded(expanded(box, own.lower), own.upper);
  }
  return (box.upper - box.lower).norm();
}

void fill_geometry(Model& model) {
  for (Block& block : model.blocks) {
    block.shape = normalized(std::move(block.shape));
    block.moments = area_moments(block.shape);
  }
  model.length_tolerance = tolerance_of_extent * extent(model);
}

void check_gravity(const Model& model) {
  if (!model.gravity.allFinite()) throw InputError("", "gravity", "not finite", "two finite numbers");
}

}  // namespace

void finish_model(Model& model) {
  using namespace model_checks;
  check_materials(model);
  check_blocks(model);
  if (model.joints.empty()) model.joints.emplace_back().name = "default";
  check_joints(model);
  check_gravity(model);
  fill_geometry(model);
  check_overlaps(model);
  check_loads(model);
  check_supports(model);
  check_viscous_edges(model);
  check_held_blocks(model);
  check_bolts(model);
  check_measurements(model);
  check_stages(model);
}

}  // namespace dda
