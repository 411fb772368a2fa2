#include "verification/thesis/bar_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "engine/builder/generators.h"

namespace verify {
namespace {

dda::EdgeLoad left_face_load(const ThesisBar& bar) {
  dda::EdgeLoad load;
  load.block = 0;
  load.from = {0, bar.height};
  load.to = {0, 0};
  load.traction = {bar.incident_stress(), 0};
  load.history = dda::SineCycles{bar.load_frequency, 1, 0};
  return load;
}

dda::Measurement measurement(const ThesisBar& bar, const SchemeSettings& scheme, double block_length) {
  const int right = block_right_of_point(bar, block_length);
  dda::Measurement at_point;
  at_point.name = "sigma_x";
  at_point.quantity = scheme.quantity;
  at_point.block = right;
  if (scheme.quantity == dda::Quantity::traction_normal) at_point.other_block = right - 1;
  at_point.point = {bar.measuring_point, bar.height / 2};
  return at_point;
}

}  // namespace

int block_right_of_point(const ThesisBar& bar, double block_length) {
  const double blocks = bar.measuring_point / block_length;
  if (std::abs(blocks - std::round(blocks)) > 1e-9)
    throw std::invalid_argument(fmt::format("blocks of {} m have no joint at {} m", block_length, bar.measuring_point));
  return static_cast<int>(std::lround(blocks));
}

double measured_place(const ThesisBar& bar, const SchemeSettings& scheme, double block_length) {
  return bar.measuring_point + (scheme.quantity == dda::Quantity::stress_xx ? block_length / 2 : 0);
}

dda::Model bar_scene(const ThesisBar& bar, const SchemeSettings& scheme, const BarRun& run) {
  dda::Model model;
  model.title = fmt::format("bar, {}, dt = {:g} s, blocks of {:g} m", scheme.name, run.dt, run.block_length);
  model.materials.push_back({"rock", bar.density, bar.young, bar.poisson, dda::PlaneState::stress});
  model.joints.push_back(scheme.joint);
  dda::BarSpec spec;
  spec.length = run.bar_length;
  spec.height = bar.height;
  spec.block_length = run.block_length;
  dda::append_bar(model, spec);
  model.edge_loads.push_back(left_face_load(bar));
  model.measurements.push_back(measurement(bar, scheme, run.block_length));
  model.stages.push_back(scheme.stage);
  model.stages.back().dt = run.dt;
  model.stages.back().duration = run.duration;
  dda::finish_model(model);
  return model;
}

}  // namespace verify
