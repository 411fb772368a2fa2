#include <fmt/format.h>

#include <set>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/tolerance.h"

namespace dda::model_checks {
namespace {

bool is_traction(Quantity quantity) {
  return quantity == Quantity::traction_normal || quantity == Quantity::traction_shear;
}

bool is_of_bolt(Quantity quantity) {
  return quantity == Quantity::bolt_force || quantity == Quantity::bolt_shear || quantity == Quantity::bolt_elongation;
}

void check_measurement(const Model& model, const Item& item, const Measurement& measurement) {
  item.index("block", measurement.block, model.blocks.size());
  item.finite("point", measurement.point);
  if (is_traction(measurement.quantity)) {
    item.index("other block", measurement.other_block, model.blocks.size());
    if (measurement.other_block == measurement.block) item.fail("other block", "the block itself", "two blocks");
  }
  if (is_of_bolt(measurement.quantity)) {
    item.index("bolt", measurement.bolt, model.bolts.size());
    const Bolt& bolt = model.bolts[static_cast<std::size_t>(measurement.bolt)];
    if (measurement.link != -1) item.index("link", measurement.link, bolt.links.size());
    return;
  }
  const Block& block = model.blocks[static_cast<std::size_t>(measurement.block)];
  const bool at_centroid = (measurement.point - block.moments.centroid).norm() <= point_tolerance(model);
  if (at_centroid) return;  // which may lie in a hole; the block's displacement is defined there all the same
  if (locate(block.shape, measurement.point, point_tolerance(model)) != Location::outside) return;
  item.fail("point", fmt::format("({}, {}) m", measurement.point.x(), measurement.point.y()), "a point of its block");
}

void check_integrator(const Item& item, const Integrator& integrator) {
  item.positive("integrator beta", integrator.beta);
  item.within("integrator gamma", integrator.gamma, 0, 2);
  item.within("integrator alpha_m", integrator.alpha_m, -1, 0.5);
  item.within("integrator alpha_f", integrator.alpha_f, 0, 0.5);
}

void check_stage(const Item& item, const Stage& stage) {
  constexpr double most_steps = 1e12;  // far beyond what a run can do, far below where step counts lose exactness
  if (stage.integrator.is_static && stage.paces_itself()) {
    item.not_negative("duration", stage.duration);
    item.positive("equilibrium", stage.equilibrium);  // what ends it
  } else {
    item.positive("dt", stage.dt);
    item.positive("duration", stage.duration);
    item.within("duration in steps", stage.duration / stage.dt, 0.5, most_steps);
  }
  check_integrator(item, stage.integrator);
  item.within("velocity factor", stage.velocity_factor, 0, 1);
  item.not_negative("damping rate", stage.damping_rate);
  item.within("equilibrium", stage.equilibrium, 0, 1);
  item.not_negative("strain inertia", stage.strain_inertia);
  item.positive("max open-close iterations", stage.max_open_close_iterations);
  item.within("max step reductions", stage.max_step_reductions, 0, 60);
}

}  // namespace

void check_measurements(const Model& model) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < model.measurements.size(); ++i) {
    const Measurement& measurement = model.measurements[i];
    const Item item("measurements", i, measurement.name);
    check_measurement(model, item, measurement);
    if (!names.insert(measurement.name).second) item.fail("name", "used before", "a name of its own");
  }
}

void check_stages(const Model& model) {
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Item item("stages", i, model.stages[i].name);
    check_stage(item, model.stages[i]);
    if (model.stages[i].paces_itself() && !model.free_field_sides.empty())
      item.fail("dt", "left out", "a time step: beside free-field sides columns are stepped along");
  }
}

}  // namespace dda::model_checks
