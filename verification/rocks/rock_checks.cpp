#include "verification/rocks/rock_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/contact/closure.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/overlap.h"
#include "engine/model/current_outline.h"

namespace verify {
namespace {

using dda::InterfaceState;
using dda::Simulation;
using dda::Vec2;
using dda::Vec4;

// Twice what a run calls deep is a hundredth; slabs are seen from five of these on.
constexpr double deep = 2e-3;  // of the smaller block's size

double size_of(const dda::Model& model, std::size_t block) { return std::sqrt(model.blocks[block].moments.area); }

bool is_there(const Simulation& simulation, std::size_t block) {
  return simulation.absent().empty() || !simulation.absent()[block];
}

// How far the springs of a contact give way, m; those of a projected stretch within blocks that give way as well. Its
// bed gives way most at an end, beyond the points at which gaps are held.
double pressed_in(const dda::InterfaceElement& element, const InterfaceState& state) {
  if (element.law == dda::InterfaceLaw::projected) return dda::deepest_end(element.lever, {state.gap(0), state.gap(2)});
  return dda::penetration_depth(element, state.gap, {});
}

// The deepest of these for each pair of blocks.
std::map<std::pair<int, int>, double> pressed_in(const dda::ContactSet& contacts) {
  std::map<std::pair<int, int>, double> depth;
  for (std::size_t k = 0; k < contacts.elements.size(); ++k) {
    double& deepest = depth[std::minmax(contacts.elements[k].block_a, contacts.elements[k].block_b)];
    deepest = std::max(deepest, pressed_in(contacts.elements[k], contacts.states[k]));
  }
  return depth;
}

// Pairs of blocks that occupy the same ground by more than springs give way.
Check overlaps(const Simulation& simulation) {
  const dda::Model& model = simulation.model();
  const std::vector<dda::Polygon> outlines = dda::current_outlines(model, simulation.state());
  std::vector<dda::Box> boxes(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (is_there(simulation, i))
      for (const Vec2& corner : outlines[i].outer) boxes[i] = dda::expanded(boxes[i], corner);
  const auto give = pressed_in(simulation.contacts());
  double count = 0;
  for (const auto& [a, b] : dda::overlapping_pairs(boxes)) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    if (model.is_held(a) && model.is_held(b)) continue;
    const auto springs = give.find({a, b});
    const double tolerance =
        deep * std::min(size_of(model, i), size_of(model, j)) + (springs == give.end() ? 0 : springs->second);
    if (dda::interiors_overlap(outlines[i], outlines[j], tolerance)) ++count;
  }
  return {"pairs of blocks in each other", count, 0};
}

// What held walls and loose blocks, which are held as well while the others settle, carry of the others' weight.
Check weight_carried(const Simulation& simulation) {
  const dda::Model& model = simulation.model();
  std::vector<bool> holds(model.blocks.size());
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i] = model.is_held(static_cast<int>(i));
  for (const dda::UnbalancedBlock& loose : simulation.results().loose)
    holds[static_cast<std::size_t>(loose.block)] = true;
  Vec2 carried = Vec2::Zero(), weight = Vec2::Zero();
  for (std::size_t i = 0; i < holds.size(); ++i)
    if (!holds[i]) weight += model.mass_of(static_cast<int>(i)) * model.gravity;
  const dda::ContactSet& contacts = simulation.contacts();
  for (std::size_t k = 0; k < contacts.elements.size(); ++k) {
    const dda::InterfaceElement& element = contacts.elements[k];
    const Vec4 force = contacts.states[k].force;
    if (holds[static_cast<std::size_t>(element.block_a)]) carried -= (element.rows_a.transpose() * force).head<2>();
    if (holds[static_cast<std::size_t>(element.block_b)]) carried -= (element.rows_b.transpose() * force).head<2>();
  }
  return {"weight that nothing carries", (carried - weight).norm() / weight.norm(), 1e-6};
}

double strength(const dda::EndStrength& end, const InterfaceState& state, std::size_t which, double normal) {
  if (!state.broken[which] && !end.is_dry()) return end.cohesion - end.friction * normal;
  return end.capacity(normal, state.residual[which]);
}

// The most that a stretch can be closed under its forces, of its length: 3/2 of the way from their place to the nearer
// edge, in half lengths, as under a block that lies on a face without tension. Where less than `spread` is closed the
// bed is no such face.
double most_closed(const dda::InterfaceElement& element, const Vec4& force) {
  const double place = element.lever * std::abs(force(2) - force(0)) / std::abs(force(0) + force(2));
  return std::min(1.0, std::max(1.5 * (1 - place), element.spread));
}

// How far a broken stretch is beyond its strength: its ends press together, so all of its shear stands against all of
// its normal force, and what cohesion it has stands where it is closed.
double beyond_of_whole(const dda::InterfaceElement& element, const dda::EndStrength& end, const InterfaceState& state) {
  if (!state.broken[0]) return 0;
  const double normal = state.force(0) + state.force(2), shear = std::abs(state.force(1) + state.force(3));
  if (normal >= 0) return shear;
  const double cohesion = 2 * end.cohesion_now(state.residual[0]) * most_closed(element, state.force);
  return shear - cohesion + end.friction_now(state.residual[0]) * normal;
}

// How far a contact of springs is beyond its strength, at the end that is farther beyond.
double beyond_of_ends(const dda::EndStrength& end, const InterfaceState& state) {
  double beyond = 0;
  for (std::size_t which = 0; which < 2; ++which) {
    const auto row = static_cast<Eigen::Index>(2 * which);
    beyond = std::max(beyond, std::abs(state.force(row + 1)) - strength(end, state, which, state.force(row)));
  }
  return beyond;
}

// The most that shear is beyond its strength. What balance leaves is 1e-8 of a force; the shear of a projected stretch
// also follows from where its blocks were found after the step that balanced it, which has moved them by a millionth.
Check beyond_strength(const Simulation& simulation) {
  const dda::ContactSet& contacts = simulation.contacts();
  double largest = 0, beyond = 0;
  bool measured = false;
  for (std::size_t k = 0; k < contacts.states.size(); ++k) {
    const dda::InterfaceLaw law = contacts.elements[k].law;
    if (law != dda::InterfaceLaw::classical && law != dda::InterfaceLaw::projected)
      continue;  // have no ends that slide
    const InterfaceState& state = contacts.states[k];
    measured = measured || law == dda::InterfaceLaw::projected;
    largest = std::max(largest, state.force.cwiseAbs().maxCoeff());
    beyond = std::max(beyond, law == dda::InterfaceLaw::projected
                                  ? beyond_of_whole(contacts.elements[k], contacts.strengths[k], state)
                                  : beyond_of_ends(contacts.strengths[k], state));
  }
  return {"shear beyond strength, of the largest force", largest > 0 ? beyond / largest : 0, measured ? 1e-6 : 1e-8};
}

// The fastest block, judged by the speed that accelerations could have given it in the time.
Check fastest(const Simulation& simulation, double acceleration, double motion) {
  double speed = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i)
    if (is_there(simulation, i)) speed = std::max(speed, simulation.state().velocity[i].head<2>().norm());
  return {"fastest block, of what gravity and walls give", speed / (acceleration * motion), 1.5};
}

}  // namespace

std::vector<Check> settled_checks(const Simulation& simulation) {
  return {overlaps(simulation), weight_carried(simulation), beyond_strength(simulation)};
}

std::vector<Check> moved_checks(const Simulation& simulation, double motion) {
  double acceleration = simulation.model().gravity.norm();
  for (const dda::HeldBlock& held : simulation.model().held_blocks) acceleration += held.amplitude.norm();
  return {overlaps(simulation),
          fastest(simulation, acceleration, motion),
          {"ledger of energies", std::abs(simulation.energy().relative_residual()), 1e-9}};
}

}  // namespace verify
