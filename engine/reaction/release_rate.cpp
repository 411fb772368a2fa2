#include "engine/reaction/release_rate.h"

#include <span>

#include "engine/model/energy_release.h"
#include "engine/reaction/opening_wall.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

ReleaseRate rate_of(std::size_t stage, const EnergyRelease& release, const Model& model) {
  const std::vector<int>& removed = model.stages[stage].removal.blocks;
  ReleaseRate rate;
  rate.stage = stage;
  rate.released = release.by_fate();
  for (const int block : removed) rate.area += model.blocks[static_cast<std::size_t>(block)].moments.area;
  rate.wall = wall_of(removed, model.absent_in(stage), model).length;
  return rate;
}

}  // namespace

std::optional<double> ReleaseRate::per_wall() const { return wall > 0 ? std::optional(released / wall) : std::nullopt; }

std::vector<ReleaseRate> release_rates(const Simulation& simulation) {
  const Model& model = simulation.model();
  const std::span<const EnergyLedger> ends = energy_at_ends_of_stages(simulation);
  std::vector<ReleaseRate> rates;
  for (std::size_t i = 1; i < ends.size(); ++i)  // the first stage takes nothing out
    if (!model.stages[i].removal.blocks.empty())
      rates.push_back(rate_of(i, energy_release(ends[i - 1], ends[i]), model));
  return rates;
}

}  // namespace dda
