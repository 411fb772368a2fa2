#include "engine/advice/near_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <variant>

#include "engine/advice/chain_path.h"
#include "engine/advice/closed_joints.h"
#include "engine/advice/on_the_way.h"
#include "engine/advice/reach.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;  // of lengths, over those of the block; of cosines
constexpr double most_seconds = 1;  // of CPU time that steps may take
constexpr double nearly = 0.97;     // as much alike: delays are looked at in a row, of which none is on a summit

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Rollers hold what is across the wave's motion and leave it its motion.
bool is_roller(const PointSupport& support, const Vec2& particles) {
  if (!is_still(support) || support.partner || support.last_stage >= 0) return false;
  if (!support.direction.isZero(0)) return std::abs(support.direction.dot(particles)) < tolerance;
  return (!support.holds_x || std::abs(particles.x()) < tolerance) &&
         (!support.holds_y || std::abs(particles.y()) < tolerance);
}

// As waves are foretold: closed, stuck, and of the law that acts. (The projected one takes off blocks what it carries,
// and without that they would send waves at another speed.)
void close(JointMaterial& joint, const Stage& stage) {
  if (is_springs(joint, stage.kinematics)) joint.law = InterfaceLaw::classical;
  joint.bonded = true;
  joint.contact_damping = 0;
}

bool has_several_stages_parts(const Model& model) {
  return !model.bolts.empty() || !model.linings.empty() || !model.free_field_sides.empty() || model.removes_blocks() ||
         model.adds_blocks() || changes_materials(model) || changes_joints(model);
}

template <typename Load>
void keep_waves(std::vector<Load>& loads, std::size_t stage) {
  std::erase_if(loads, [&](const Load& load) {
    return std::holds_alternative<Constant>(load.history) || !load.stages.has(stage);
  });
  for (Load& load : loads) load.stages = {};
}

}  // namespace

BetweenSides NearSides::count(const HistoryErrors& history, const MeshPlace& place, double window,
                              const ReadTrace& read) const {
  const std::string met = met_inside(place, window);
  if (!are_felt(place, window) && met.empty()) return {history, ""};
  const double cost = course_.step_cost * (load_.history.start + window) / stage_.dt;
  const auto trace = cost > most_seconds ? std::nullopt : stepped(place, window);
  if (trace) {
    const auto readings = read(*trace);
    if (!readings) return {history, "its sides are near, and what comes resembles nothing that should"};
    if (readings->elsewhere > nearly * readings->likeness)
      return {history, "its sides are near, and another part of what comes resembles it as much as the first"};
    return {history.with_sides(*readings), ""};
  }
  if (!met.empty()) return {history, met};
  // What rollers change of a wave is of the order of what blocks do, and of springs across a P wave of Poisson's ratio
  // squared.
  const bool hardly_matter = are_rollers(place) && (place.kind == WaveKind::p || !has_springs());
  if (distance(place) >= place.distance || hardly_matter) return {history, ""};
  return {history, fmt::format("its sides are {:.3g} m from the way, nearer than the {:.3g} m that it runs, and change "
                               "it there",
                               distance(place), place.distance)};
}

// What a wave meets between the sides in time to be seen: steps count it as well.
std::string NearSides::met_inside(const MeshPlace& place, double window) const {
  const Vec2 particles = polarization(place.kind, place.direction), across = left_of(place.direction);
  const Reach sides = reach_of(model_, across);
  const auto is_inside = [&](const ActingPlace& at_place) {
    const double slack = tolerance * (sides.length());
    const double middle = across.dot(at_place.face.start + at_place.face.end) / 2;
    return at_place.all_of_it || (middle > sides.low + slack && middle < sides.high - slack);
  };
  std::vector<Hindrance> hindrances = free_faces_inside(model_, drawn_, place.direction);
  for (Hindrance& each : holding_or_absorbing(model_, course_.index,
                                              {place.direction, particles, 1 / load_.history.period, sides.length()}))
    if (each.share > hardly_held && each.place.block != load_.block && is_inside(each.place))
      hindrances.push_back(std::move(each));
  for (const Hindrance& each : hindrances)
    if (way_over(model_, each.place, place.direction, start_along(place), load_.looked_at) < fastest() * window)
      return each.clause;
  return "";
}

double NearSides::distance(const MeshPlace& place) const {
  const Vec2 across = left_of(place.direction);
  const Reach sides = reach_of(model_, across);
  const double here = across.dot(load_.looked_at);
  return std::max(0.0, std::min(here - sides.low, sides.high - here));
}

bool NearSides::are_felt(const MeshPlace& place, double window) const {
  return std::hypot(place.distance, distance(place)) < fastest() * window;
}

double NearSides::fastest() const {
  double fastest = 0;
  for (const Block& block : model_.blocks)
    fastest = std::max(fastest, p_wave_speed(model_.materials[at(block.material)]));
  return fastest;
}

bool NearSides::has_springs() const { return one_gives_way_closed(model_.joints, stage_.kinematics); }

// All along both sides.
bool NearSides::are_rollers(const MeshPlace& place) const {
  const Vec2 across = left_of(place.direction);
  const Vec2 particles = polarization(place.kind, place.direction);
  std::set<std::pair<int, bool>> rolling;  // block and side
  for (const PointSupport& support : model_.supports) {
    if (!is_roller(support, particles)) continue;
    const double side = across.dot(support.point - model_.blocks[at(support.block)].moments.centroid);
    rolling.emplace(support.block, side > 0);
  }
  const Reach sides = reach_of(model_, across);
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    if (model_.is_held(static_cast<int>(i))) continue;
    const Reach block = reach_of(model_.blocks[i], across);
    const double slack = tolerance * (block.high - block.low);
    if (block.low < sides.low + slack && !rolling.contains({static_cast<int>(i), false})) return false;
    if (block.high > sides.high - slack && !rolling.contains({static_cast<int>(i), true})) return false;
  }
  return true;
}

// Where the way begins: the face of the block that is driven, or behind it where it is driven as a whole.
double NearSides::start_along(const MeshPlace& place) const {
  const Reach block = reach_of(model_.blocks[at(load_.block)], place.direction);
  return model_.is_held(load_.block) ? block.high : block.low;
}

// The joint across the wave at the place that is nearest to where the wave is looked at.
std::optional<std::size_t> NearSides::interface_at(const MeshPlace& place) const {
  const double wanted = start_along(place) + place.distance;
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < drawn_.interfaces.size(); ++i) {
    const Interface& interface = drawn_.interfaces[i];
    if (interface.length == 0 || std::abs(interface.normal.dot(place.direction)) < 1 - tolerance) continue;
    const Vec2 middle = (interface.from + interface.to) / 2;
    if (std::abs(place.direction.dot(middle) - wanted) > 1e-3 * interface.length) continue;
    const double beside = std::abs(left_of(place.direction).dot(middle - load_.looked_at));
    if (beside >= least) continue;
    least = beside;
    nearest = i;
  }
  return nearest;
}

// The scene as far as the wave goes: what is at rest stays out of it.
std::optional<Model> NearSides::closed_scene(double duration) const {
  for (std::size_t i = 0; i < course_.index; ++i)
    if (model_.stages[i].duration > 0) return std::nullopt;
  if (has_several_stages_parts(model_)) return std::nullopt;
  Model scene = model_;
  scene.gravity.setZero();
  scene.measurements.clear();
  scene.peaks.reset();
  for (JointMaterial& joint : scene.joints) close(joint, stage_);
  for (Block& block : scene.blocks) {
    block.initial_stress.setZero();
    block.initial_velocity.setZero();
    block.initial_spin = 0;
    block.initial_strain_rate.setZero();
  }
  keep_waves(scene.point_loads, course_.index);
  keep_waves(scene.edge_loads, course_.index);
  const auto index = static_cast<int>(course_.index);
  std::erase_if(scene.supports,
                [&](const PointSupport& each) { return each.last_stage >= 0 && each.last_stage < index; });
  for (PointSupport& support : scene.supports) support.last_stage = -1;
  std::erase_if(scene.viscous_edges, [&](const ViscousEdge& each) { return each.first_stage > index; });
  for (ViscousEdge& edge : scene.viscous_edges) edge.first_stage = 0;
  scene.stages = {stage_};
  scene.stages.front().kinematics = Kinematics::small;
  scene.stages.front().duration = duration;
  return scene;
}

std::optional<std::vector<double>> NearSides::stepped(const MeshPlace& place, double window) const {
  const auto index = interface_at(place);
  const auto before = static_cast<std::int64_t>(std::llround(load_.history.start / stage_.dt));
  const auto steps = static_cast<std::int64_t>(std::floor(window / stage_.dt + tolerance));
  auto scene = closed_scene(static_cast<double>(before + steps) * stage_.dt);
  if (!scene || !index) return std::nullopt;
  Simulation simulation(std::move(*scene));
  const Interface& interface = simulation.contacts().interfaces[*index];
  const Vec2 particles = polarization(place.kind, place.direction);
  const Vec2& normal = interface.normal;
  const double sign = normal.dot(place.direction) > 0 ? -1 : 1;  // of the force on the block behind the joint
  const Vec2 weights = sign / place.unit * Vec2(particles.dot(normal), particles.dot(left_of(normal)));
  std::vector<double> trace;
  if (before == 0) trace.push_back(0);
  for (std::int64_t step = 1; step <= before + steps; ++step) {
    if (simulation.step() != Status::ok) return std::nullopt;
    if (step < before) continue;
    trace.push_back(
        weights.dot(mean_traction(simulation.model(), interface, simulation.contacts().elements.but_for_blocks(*index),
                                  simulation.interface_state(*index))));
  }
  return trace;
}

}  // namespace dda
