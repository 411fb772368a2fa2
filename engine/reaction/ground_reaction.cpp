#include "engine/reaction/ground_reaction.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"
#include "engine/model/tolerance.h"
#include "engine/reaction/unloading.h"
#include "engine/simulation/loads_in_joints.h"
#include "engine/simulation/measured_forces.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

// The moment from which every share begins.
struct Settled {
  State state;
  std::vector<std::byte> snapshot;
  double pressure = 0;  // Pa, as ReactionCurve::pressure
  Status status = Status::ok;
  std::string message;
  std::vector<UnbalancedBlock> loose;  // of all stages so far, and at a share of 1
};

// Which blocks are not there before the last stage, or are taken out by it.
std::vector<bool> no_longer_there(const Model& model) {
  std::vector<bool> away = model.absent_in(model.stages.size() - 2);
  away.resize(model.blocks.size(), false);
  for (const int block : model.stages.back().removal.blocks) away[static_cast<std::size_t>(block)] = true;
  return away;
}

// What the water in the joints between the opening and what stays presses on its wall with, N per m of thickness.
double force_of_water(const Simulation& simulation, const OpeningWall& wall) {
  const Model& model = simulation.model();
  const std::vector<bool> goes = loads_that_go_with_blocks(model.stages.size() - 1, model);
  double force = 0;
  for (std::size_t i = 0; i < goes.size(); ++i) {
    const EdgeLoad& load = model.edge_loads[i];
    if (!goes[i]) continue;
    const double now = evaluate(load.history, simulation.state().time);
    for (const WallFace& face : wall.faces)
      if (face.block == load.block &&
          distance({face.from, face.to}, (load.from + load.to) / 2) <= point_tolerance(model))
        force -= now * load.traction.dot(face.inward) * (load.to - load.from).norm();
  }
  return force;
}

// The mean normal stress that the opening exerts on what stays, over its wall, Pa, positive in compression.
double mean_pressure(const Simulation& simulation, const std::vector<int>& opening, const OpeningWall& wall) {
  const std::vector<bool> away = no_longer_there(simulation.model());
  Measurement force;
  force.quantity = Quantity::contact_force;
  force.others = opening;
  std::ranges::sort(force.others);
  for (std::size_t i = 0; i < away.size(); ++i)
    if (!away[i]) force.blocks.push_back(static_cast<int>(i));
  constexpr Eigen::Index normal = 2;
  const double carried = -contact_force(simulation.system(), force, make_cut(simulation.system(), force))(normal);
  return (carried + force_of_water(simulation, wall)) / wall.length;
}

// Runs all stages but the last.
Settled settle(const Model& model, const std::vector<int>& opening, const OpeningWall& wall) {
  Settled settled;
  Simulation simulation(model);
  const std::size_t before = model.stages.size() - 1;
  const auto keep = [&] {
    if (stages_done(simulation) != before) return;
    settled.state = simulation.state();
    settled.snapshot = save(simulation);
    settled.pressure = mean_pressure(simulation, opening, wall);
  };
  simulation.watch().between = keep;
  while (settled.status == Status::ok && stages_done(simulation) < before) settled.status = simulation.step();
  settled.message = simulation.message();
  settled.loose = simulation.results().loose;
  return settled;
}

bool has(const std::vector<UnbalancedBlock>& blocks, int block) {
  return std::ranges::find(blocks, block, &UnbalancedBlock::block) != blocks.end();
}

// Returns the blocks that came loose in the last stage, without those that nothing held before.
std::vector<UnbalancedBlock> newly_loose(const Simulation& simulation, const Settled& settled) {
  const int last = static_cast<int>(simulation.model().stages.size()) - 1;
  std::vector<UnbalancedBlock> loose = simulation.results().loose;
  std::erase_if(loose, [&](const auto& each) { return each.stage != last || has(settled.loose, each.block); });
  return loose;
}

// True where the end of the run lacks nothing but a hold on blocks that are loose there.
bool is_balanced_but_for_loose_blocks(const Simulation& simulation) {
  return simulation.results().out_of_balance.back() <= simulation.model().stages.back().equilibrium;
}

// True where the end of the run lacks nothing but a hold on blocks that had none in situ.
bool settles_but_for_old_loose_blocks(const Simulation& simulation, const ReactionPoint& point) {
  return point.status == Status::not_in_equilibrium && point.loose.empty() &&
         is_balanced_but_for_loose_blocks(simulation);
}

ReactionPoint point_at(double share, Model model, const Settled& settled, const OpeningWall& wall) {
  model.stages.back().removal.relaxation = fading_to(share);
  Simulation simulation(std::move(model));
  restore(simulation, settled.state, settled.snapshot);
  ReactionPoint point;
  point.share = share;
  while (point.settles() && !simulation.finished()) point.status = simulation.step();
  point.motion = motion_of(wall, simulation.model(), settled.state, simulation.state());
  point.loose = newly_loose(simulation, settled);
  if (settles_but_for_old_loose_blocks(simulation, point)) point.status = Status::ok;
  if (!point.settles()) point.reason = simulation.message();
  return point;
}

// The blocks that come loose while all of what the opening exerted is still there. Asked of every curve, whichever
// shares it has, since points do not depend on each other.
std::vector<UnbalancedBlock> loose_at_full_share(Model model, const Settled& settled) {
  model.stages.back().removal.relaxation = fading_to(1);
  Simulation simulation(std::move(model));
  restore(simulation, settled.state, settled.snapshot);
  Status status = Status::ok;
  while (status == Status::ok && !simulation.finished()) status = simulation.step();
  if (status != Status::not_in_equilibrium || !is_balanced_but_for_loose_blocks(simulation)) return {};
  return newly_loose(simulation, settled);
}

// What is left out of balance in situ is there in every point, whose largest force, of which it is a share, is another.
Model settled_well(Model model) {
  for (std::size_t i = 0; i + 1 < model.stages.size(); ++i) model.stages[i].equilibrium /= 2;
  return model;
}

std::vector<int> numbers_of(const std::vector<UnbalancedBlock>& blocks) {
  std::vector<int> numbers;
  for (const UnbalancedBlock& block : blocks) numbers.push_back(block.block);
  return numbers;
}

}  // namespace

ReactionCurve ground_reaction(const Model& model, const ReactionQuestion& question,
                              const std::function<void(const ReactionPoint&)>& progress) {
  const Unloading unloading = unloading_of(model, question.opening);
  const Model scene = settled_well(unloading.model);
  ReactionCurve curve;
  curve.left_out = unloading.left_out;
  curve.removed_with_it = unloading.removed_with_it;
  curve.wall = wall_of(question.opening, no_longer_there(scene), scene);
  if (curve.wall.faces.empty())
    throw InputError("", "the opening", "without faces along blocks that stay", "one that the rock touches");
  Settled settled = settle(scene, question.opening, curve.wall);
  curve.in_situ = settled.status;
  curve.message = settled.message;
  curve.pressure = settled.pressure;
  curve.loose_in_situ = settled.loose;
  if (settled.status == Status::ok) curve.loose_at_full_share = loose_at_full_share(scene, settled);
  std::ranges::copy(curve.loose_at_full_share, std::back_inserter(settled.loose));
  const OpeningWall watched = without(numbers_of(curve.loose_at_full_share), curve.wall);
  for (const double share : question.shares) {
    if (settled.status != Status::ok || (!curve.points.empty() && !curve.points.back().settles())) break;
    curve.points.push_back(point_at(share, scene, settled, watched));
    if (progress) progress(curve.points.back());
  }
  return curve;
}

}  // namespace dda
