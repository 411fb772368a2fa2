#include "verification/cases/limit_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/simulation/simulation.h"
#include "verification/cases/contact_rig.h"

namespace verify {

void hold_firmly(dda::Model& model, int block, const dda::Vec2& displacement, const dda::TimeFunction& history) {
  const double stiffness = 1000 * model.materials.front().young;
  for (const dda::Vec2& corner : model.blocks[static_cast<std::size_t>(block)].shape.outer)
    model.supports.push_back({block, corner, true, true, stiffness, displacement, history});
}

void let_stand(dda::Model& model, double step, int steps) {
  dda::Stage load = moving_stage(dda::static_integrator(), step, 20 * step);
  load.name = "load";
  load.unlimited_strength = true;
  dda::Stage stand = moving_stage(dda::static_integrator(), step, steps * step);
  stand.name = "stand";
  stand.equilibrium = 1e-9;
  model.stages = {load, stand};
}

bool stands(dda::Model model, double far, Outcome& outcome) {
  dda::finish_model(model);
  dda::Simulation simulation(std::move(model));
  const auto has_moved_far = [&] {
    return std::any_of(simulation.state().displacement.begin(), simulation.state().displacement.end(),
                       [far](const dda::Vec6& u) { return u.head<2>().norm() > far; });
  };
  dda::Status status = dda::Status::ok;
  while (!simulation.finished() && status == dda::Status::ok && !has_moved_far()) status = simulation.step();
  outcome.counters += simulation.counters();
  // A mechanism has no static answer: steps may end without one too. What stands and did not settle would be counted as
  // fallen, and the limit found be off.
  const bool falls = status == dda::Status::not_in_equilibrium || status == dda::Status::not_converged;
  if (status != dda::Status::ok && !falls)
    throw std::runtime_error(fmt::format("\"{}\" stopped at t = {:g} s: {}", simulation.model().title,
                                         simulation.state().time, simulation.message()));
  return status == dda::Status::ok && !has_moved_far();
}

Bracket bisect(Bracket bracket, double width, const std::function<bool(double)>& stands_at) {
  if (stands_at(bracket.falls) || !stands_at(bracket.stands))
    throw std::runtime_error(fmt::format("{} falls and {} stands: it is not so", bracket.falls, bracket.stands));
  while (std::abs(bracket.stands - bracket.falls) > width) {
    const double middle = bracket.middle();
    (stands_at(middle) ? bracket.stands : bracket.falls) = middle;
  }
  return bracket;
}

Expectation bracketed(const Quantity& quantity, const Bracket& bracket, double reference, const std::string& source) {
  const double a = relative_error(bracket.falls, reference);
  const double b = relative_error(bracket.stands, reference);
  return quantity.is(bracket.middle()).against(reference, source).off_by(std::abs(a) > std::abs(b) ? a : b);
}

}  // namespace verify
