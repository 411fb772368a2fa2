#include "verification/cases/contact_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

dda::Model finished(dda::Model model) {
  dda::finish_model(model);
  return model;
}

}  // namespace

int add_box(dda::Model& model, double left, double bottom, double right, double top) {
  model.blocks.emplace_back().shape.outer = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  return static_cast<int>(model.blocks.size()) - 1;
}

dda::JointMaterial dry_joint(double friction_angle) {
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.friction_angle = friction_angle;
  return joint;
}

void hold_corners(dda::Model& model, int block, const dda::Vec2& displacement, const dda::TimeFunction& history) {
  for (const dda::Vec2& corner : model.blocks[static_cast<std::size_t>(block)].shape.outer)
    model.supports.push_back({block, corner, true, true, 5e11, displacement, history});
}

dda::Stage settling_stage() {
  dda::Stage stage = moving_stage(dda::static_integrator(), settling_time / 10, settling_time);
  stage.name = "settle";
  stage.unlimited_strength = true;
  return stage;
}

dda::Stage moving_stage(const dda::Integrator& integrator, double dt, double duration) {
  dda::Stage stage;
  stage.dt = dt;
  stage.duration = duration;
  stage.integrator = integrator;
  stage.solver = dda::SolverRequest::cholesky;  // to round-off
  return stage;
}

WatchedRun::WatchedRun(dda::Model model) : simulation_(finished(std::move(model))) {}

void WatchedRun::step() {
  advance(simulation_, 1);
  largest_residual_ = std::max(largest_residual_, std::abs(simulation_.energy().residual()));
}

void WatchedRun::run_to(double time) {
  // A share far above round-off of the time and far below a step.
  while (!simulation_.finished() && state().time < time * (1 - 1e-12)) step();
}

void WatchedRun::run_to_end() {
  while (!simulation_.finished()) step();
}

double WatchedRun::energy_residual() const {
  const double scale = simulation_.energy().scale();
  return scale > 0 ? largest_residual_ / scale : largest_residual_;
}

Assertion energy_assertion(const std::string& run, double residual) {
  return expect("largest energy residual over the largest term, " + run, "-")
      .is(residual)
      .against(0,
               "external work = change of kinetic, strain and contact energy + friction + numerical (error absolute)")
      .absolutely()
      .within(1e-8, "target of the project; the balance holds in exact arithmetic");
}

}  // namespace verify
