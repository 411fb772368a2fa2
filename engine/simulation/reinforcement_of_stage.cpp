#include "engine/simulation/reinforcement_of_stage.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/simulation/block_system.h"
#include "engine/simulation/excavation.h"
#include "engine/simulation/general_step.h"

namespace dda {
namespace {

// Gives up what it exerted, at once or as a load that fades. What it had stored goes with who takes it out.
template <typename Set, typename Item>
void take_out_those_over(const std::vector<Item>& items, Released what, Set& set, BlockSystem& s) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].withdrawal.is_at_start_of(s.clock.stage)) continue;
    Eigen::VectorXd exerted = Eigen::VectorXd::Zero(s.forces.internal_old.size());
    set.take_out(i, s.model, exerted);
    s.forces.internal_old -= exerted;
    if (!items[i].withdrawal.relaxation) continue;
    s.held.clear(exerted);
    const State geometry = s.geometry_moves() ? s.state : initial_state(s.model);
    s.excavated.released.keep(what, i, s.clock.start, -exerted, geometry.deformation);
    s.loads_at(s.state.time, s.forces.load_old);
  }
}

void put_in_bolts(const GeneralStep& general, BlockSystem& s) {
  const int stage = static_cast<int>(s.clock.stage);
  if (stage == 0 || std::ranges::count(s.model.bolts, stage, &Bolt::first_stage) == 0) return;
  const double stored = s.reinforcement.bolts.stored_energy();
  const State geometry = s.geometry_moves() ? general.acting() : initial_state(s.model);
  s.reinforcement.bolts.put_in_those_of(s.clock.stage, s.model, s.state, geometry, s.forces.internal_old);
  s.audit.supports_exchanged(0, s.reinforcement.bolts.stored_energy() - stored);
}

void spray_linings(const GeneralStep& general, BlockSystem& s) {
  const int stage = static_cast<int>(s.clock.stage);
  if (stage == 0 || std::ranges::count(s.model.linings, stage, &Lining::first_stage) == 0) return;
  const State geometry = s.geometry_moves() ? general.acting() : initial_state(s.model);
  s.reinforcement.linings.put_in_those_of(s.clock.stage, s.model, s.state, geometry);
}

}  // namespace

void take_out_reinforcement(BlockSystem& s) {
  const double bolts = s.reinforcement.bolts.stored_energy(), linings = s.reinforcement.linings.stored_energy();
  take_out_those_over(s.model.bolts, Released::bolt, s.reinforcement.bolts, s);
  take_out_those_over(s.model.linings, Released::lining, s.reinforcement.linings, s);
  s.audit.supports_exchanged(0, s.reinforcement.bolts.stored_energy() - bolts,
                             s.reinforcement.linings.stored_energy() - linings);
}

void put_in_reinforcement(const GeneralStep& general, BlockSystem& s) {
  put_in_bolts(general, s);
  spray_linings(general, s);
}

}  // namespace dda
