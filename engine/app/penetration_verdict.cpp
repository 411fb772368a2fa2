#include <fmt/format.h>

#include "engine/app/run_verdict.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

// Share of the smaller block's size from which on a contact is no contact: its vertex is nearer to another edge.
constexpr double ruinous_penetration = 0.1;

}  // namespace

// What blocks went through on the way is a warning (run_warnings.h); what they end in is the result.
RunVerdict judge_penetration(const Simulation& simulation) {
  if (!simulation.plan().contacts_can_change) return {};
  Penetration now;
  note_penetrations(simulation.contacts(), simulation.system().terms, simulation.state().time, now);
  if (!(now.share >= ruinous_penetration)) return {};
  const auto name = [&](int block) { return simulation.model().blocks[static_cast<std::size_t>(block)].name; };
  return {Status::inaccurate,
          fmt::format("blocks \"{}\" and \"{}\" end {:.3g} m deep in each other, {:.2g} % of the smaller one, where "
                      "contacts mean nothing; take stiffer joints or a smaller dt, or share a long motion among more "
                      "steps or stages",
                      name(now.block_a), name(now.block_b), now.depth, 100 * now.share)};
}

}  // namespace dda
