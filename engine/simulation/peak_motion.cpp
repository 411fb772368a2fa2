#include "engine/simulation/peak_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/simulation/block_system.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

std::size_t stage_asked(const Simulation& simulation) {
  return static_cast<std::size_t>(simulation.model().peaks->stage);
}

void keep_largest(double value, double time, double& peak, double& peak_time) {
  if (!(value > peak)) return;
  peak = value;
  peak_time = time;
}

}  // namespace

PeakMotion::PeakMotion(const Simulation& simulation)
    : blocks_(simulation.model().blocks.size()), start_(blocks_.size(), Vec2::Zero()) {
  if (stages_done(simulation) == stage_asked(simulation)) begin(simulation);
}

void PeakMotion::after_step(const Simulation& simulation) {
  if (is_over_ || stages_done(simulation) != stage_asked(simulation)) return;
  if (has_begun_) {
    look(simulation);
  } else {
    begin(simulation);
  }
}

void PeakMotion::after_stage(const Simulation& simulation, std::size_t ended) {
  if (!has_begun_ || is_over_ || ended != stage_asked(simulation)) return;
  look(simulation);
  is_over_ = true;
}

void PeakMotion::begin(const Simulation& simulation) {
  has_begun_ = true;
  const Model& model = simulation.model();
  const std::vector<bool>& absent = simulation.absent();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const int block = static_cast<int>(i);
    blocks_[i].place = current_centroid(model, simulation.state(), block);
    blocks_[i].takes_part = (absent.empty() || !absent[i]) && !model.is_held(block);
    start_[i] = simulation.state().displacement[i].head<2>();
  }
  look(simulation);
}

void PeakMotion::look(const Simulation& simulation) {
  const BlockSystem& system = simulation.system();
  const State& state = system.state;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    BlockPeaks& block = blocks_[i];
    if (!block.takes_part) continue;
    const Vec6& velocity = state.velocity[i];
    keep_largest(velocity.head<2>().norm(), state.time, block.speed, block.speed_time);
    keep_largest(state.acceleration[i].head<2>().norm(), state.time, block.acceleration, block.acceleration_time);
    block.kinetic = velocity.dot(momentum(system.terms.inertia[i], velocity)) / 2;
  }
  if (const auto& asked = system.model.peaks->ejection) look_for_ejection(*asked, simulation);
}

// Takes the median of each component by itself, by mass, of `values` less `from`; an empty `from` counts as zero.
Vec2 PeakMotion::median(const Model& model, const std::vector<Vec6>& values, std::span<const Vec2> from) {
  Vec2 median = Vec2::Zero();
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    double total = 0;
    for (auto& [value, block] : sorted_) {
      const auto i = static_cast<std::size_t>(block);
      value = values[i](axis) - (from.empty() ? 0.0 : from[i](axis));
      total += model.mass_of(block);
    }
    std::ranges::sort(sorted_);
    double below = 0;
    for (const auto& [value, block] : sorted_) {
      below += model.mass_of(block);
      median(axis) = value;
      if (below >= total / 2) break;
    }
  }
  return median;
}

void PeakMotion::look_for_ejection(const EjectionRequest& asked, const Simulation& simulation) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  const std::vector<bool>& absent = simulation.absent();
  sorted_.clear();
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (absent.empty() || !absent[i]) sorted_.emplace_back(0.0, static_cast<int>(i));
  const Vec2 rest_moved = median(model, state.displacement, start_);
  const Vec2 rest_velocity = median(model, state.velocity, {});
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    BlockPeaks& block = blocks_[i];
    if (!block.takes_part) continue;
    block.moved = (state.displacement[i].head<2>() - start_[i] - rest_moved).norm();
    const double speed = (state.velocity[i].head<2>() - rest_velocity).norm();
    const bool is_fast = speed >= asked.speed;
    if (std::isinf(block.gone_at)) {
      block.thrown = std::max(block.thrown, speed);
      if (block.moved >= asked.distance) block.gone_at = state.time;
    }
    if (!block.is_ejected() && (is_fast || block.moved >= asked.distance)) block.ejected_at = state.time;
  }
}

}  // namespace dda
