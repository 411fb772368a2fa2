#include "engine/simulation/depth_given_back.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "engine/contact/inherited_state.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/shared_ground.h"

namespace dda {
namespace {

// This share of the smaller block's size is given back at once: contacts then press as in a step that goes as far.
constexpr double share_at_once = 5e-3;

// What is less than this share of the smaller block's size is left, as many contacts have it from round-off.
constexpr double least_share = 1e-4;

double smaller_size(const Model& model, const InterfaceElement& element) {
  const auto area_of = [&](int block) { return model.blocks[static_cast<std::size_t>(block)].moments.area; };
  return std::sqrt(std::min(area_of(element.block_a), area_of(element.block_b)));
}

// Vertices whose contacts were forgiven a depth worth a step: their places among all.
std::vector<std::size_t> forgiven_contacts(const BlockSystem& s) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < s.contacts.states.size(); ++i) {
    const double seat = s.contacts.states[i].seat[0];
    if (seat >= 0 || s.contacts.interfaces[i].length > 0) continue;
    if (seat <= -least_share * smaller_size(s.model, s.contacts.elements.own()[i])) places.push_back(i);
  }
  return places;
}

void give_back(double most, const InterfaceElement& element, InterfaceState& state) {
  const double distance = state.gap(0) + state.held_open(0);
  state.seat[0] += std::min(most, -state.seat[0]);
  measure(element, distance, state);
}

}  // namespace

bool give_back_depths(BlockSystem& s) {
  const std::vector<std::size_t> forgiven = forgiven_contacts(s);
  if (forgiven.empty()) return false;  // outlines need not be compared
  std::set<std::pair<int, int>> pairs;
  for (const SharedGround& each : shared_ground(s)) pairs.insert(std::minmax(each.block_a, each.block_b));
  for (const CameInOver& each : s.excavated.came_in_over)
    if (each.share > told_share) pairs.erase({each.block_a, each.block_b});
  bool any = false;
  for (const std::size_t i : forgiven) {
    const InterfaceElement& element = s.contacts.elements.own()[i];
    if (!pairs.contains(std::minmax(element.block_a, element.block_b))) continue;
    give_back(share_at_once * smaller_size(s.model, element), element, s.contacts.states[i]);
    any = true;
  }
  if (!any) return false;
  s.audit.geometry_followed(s.stored_energy_now());
  s.sum_internal_forces(s.forces.internal_old);
  return true;
}

}  // namespace dda
