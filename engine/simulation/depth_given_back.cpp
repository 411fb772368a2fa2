#include "engine/simulation/depth_given_back.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "engine/simulation/block_system.h"
#include "engine/simulation/shared_ground.h"

namespace dda {
namespace {

// This share of the smaller block's size is given back at once: contacts then press as in a step that goes as far.
constexpr double share_at_once = 5e-3;

// What is less than this share of the smaller block's size is left, as many contacts have it from round-off.
constexpr double least_share = 1e-4;

// Returns whether the contact was forgiven a depth worth a step, of which it then has `most` (m) less.
bool give_back(double most, double least, const InterfaceElement& element, InterfaceState& state) {
  if (state.seat[0] > -least) return false;
  const double part = std::min(most, -state.seat[0]);
  state.seat[0] += part;
  state.gap(0) -= part;
  state.force(0) = element.stiffness(0) * std::min(0.0, state.gap(0));
  return true;
}

}  // namespace

bool give_back_depths(BlockSystem& s) {
  const std::vector<SharedGround> shared = shared_ground(s);
  if (shared.empty()) return false;
  std::map<std::pair<int, int>, double> size_of_pair;
  for (const SharedGround& each : shared)
    size_of_pair[std::minmax(each.block_a, each.block_b)] = each.depth / each.share;
  bool any = false;
  for (std::size_t i = 0; i < s.contacts.elements.size(); ++i) {
    const InterfaceElement& element = s.contacts.elements.own()[i];
    const auto size = size_of_pair.find(std::minmax(element.block_a, element.block_b));
    if (size == size_of_pair.end() || s.contacts.interfaces[i].length > 0) continue;
    const bool given =
        give_back(share_at_once * size->second, least_share * size->second, element, s.contacts.states[i]);
    any = given || any;
  }
  if (!any) return false;
  s.audit.geometry_followed(s.stored_energy_now());
  s.sum_internal_forces(s.forces.internal_old);
  return true;
}

}  // namespace dda
