#include <fmt/format.h>

#include "engine/app/run_verdict.h"
#include "engine/app/run_warnings.h"
#include "engine/core/place_in_words.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

// Share of the smaller block's size from which on a contact is no contact: its vertex is nearer to another edge.
constexpr double ruinous_penetration = 0.1;

std::string name_of(const Simulation& simulation, int block) {
  return simulation.model().blocks[static_cast<std::size_t>(block)].name;
}

RunVerdict judge_passing(const Simulation& simulation) {
  const DepthInThickness& deepest = simulation.deepest_penetration().in_thickness;
  if (!(deepest.share > passing_share)) return {};
  return {Status::inaccurate,
          fmt::format("block \"{}\" was {:.3g} m deep in \"{}\" at {} and {:.6g} s, {:.3g} % of what is "
                      "there of it, and may have gone through; take a smaller dt, stiffer joints, or a thicker block",
                      name_of(simulation, deepest.inner), deepest.depth, name_of(simulation, deepest.thinner),
                      place_in_words(deepest.place), deepest.time, 100 * deepest.share)};
}

}  // namespace

// What blocks went through on the way is a warning (run_warnings.h) unless it was more than half of what is there; what
// they end in is the result.
RunVerdict judge_penetration(const Simulation& simulation) {
  if (!simulation.plan().contacts_can_change) return {};
  Penetration now;
  note_penetrations(simulation.model(), simulation.contacts(), simulation.system().terms, simulation.state(), now);
  if (now.share >= ruinous_penetration)
    return {Status::inaccurate,
            fmt::format("blocks \"{}\" and \"{}\" end {:.3g} m deep in each other, {:.2g} % of the smaller one, where "
                        "contacts mean nothing; {}, or share a long motion among more steps or stages",
                        name_of(simulation, now.block_a), name_of(simulation, now.block_b), now.depth, 100 * now.share,
                        remedy_of_depth(simulation.model(), now.block_a, now.block_b))};
  return judge_passing(simulation);
}

}  // namespace dda
