#include "engine/simulation/run_so_far.h"

#include "engine/simulation/block_system.h"
#include "engine/simulation/stage_end.h"

namespace dda {

std::size_t stages_done(const Simulation& simulation) { return simulation.system().clock.stage; }

const LiningSet& linings_of(const Simulation& simulation) { return simulation.system().reinforcement.linings; }

std::int64_t steps_in_all_stages(const Simulation& simulation) {
  std::int64_t steps = 0;
  for (const Stage& each : simulation.model().stages) steps += each.steps();
  return steps;
}

std::span<const EnergyLedger> energy_at_ends_of_stages(const Simulation& simulation) {
  return std::span(simulation.results().energy).first(stages_done(simulation));
}

std::string unbalanced_end(const Simulation& simulation) {
  // Columns are ahead by a step, so a stage that they end out of balance is not over beside them.
  if (const Simulation* columns = simulation.free_field_columns())
    if (const std::string problem = unbalanced_end(*columns); !problem.empty())
      return "columns of the free field: " + problem;
  const StageClock& clock = simulation.system().clock;
  return clock.begun || clock.stage == 0 ? ""
                                         : problem_at_end_of(clock.stage - 1, simulation.model(), simulation.results());
}

}  // namespace dda
