#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/app/run_verdict.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/gain_at_start.h"

namespace dda {
namespace {

// Share of the largest energy that may come from nowhere before a run is reported as doubtful, and from which on it has
// failed. Round-off and geometry that is followed step by step stay far below it (1e-6 in the examples).
constexpr double tolerated_gain = 1e-3;
constexpr double ruinous_gain = 1e-2;

// The same of what was there for a while and has been lost again, where contacts come and go. (Elsewhere an
// integrator's own work swings to and fro with the loads, by the square of its steps over a period.) No more than a
// warning: an impact that a step does not resolve is booked as a gain of one step and a loss of the next.
constexpr double tolerated_passing_gain = 10 * tolerated_gain;

// Share of the largest energy by which the ledger may miss. Where nothing is lost it is 1e-11; with every digit that
// springs too stiff for their blocks take from a solve it grows tenfold.
constexpr double tolerated_residual = 1e-6;

// Share of what was brought from which on it is said that steps have lost it. A load that is put on at once and comes
// to rest on springs loses half; blocks that land and stay lose all they had.
constexpr double noted_loss = 0.75;

// Those with the most kinetic energy: who was given energy from nowhere flies.
std::vector<UnbalancedBlock> liveliest_blocks(const Simulation& simulation) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  const auto kinetic = [&](int block) {
    return model.mass_of(block) * state.velocity[static_cast<std::size_t>(block)].head<2>().squaredNorm();
  };
  std::vector<int> blocks(model.blocks.size());
  std::iota(blocks.begin(), blocks.end(), 0);
  std::ranges::stable_sort(blocks, std::ranges::greater(), kinetic);
  blocks.resize(std::min<std::size_t>(3, blocks.size()));
  std::vector<UnbalancedBlock> placed;
  for (const int block : blocks) placed.push_back({0, block, current_centroid(model, state, block), {}});
  return placed;
}

double passing_gain(const Simulation& simulation) {
  const double gained = simulation.system().audit.most_gained();
  return gained > 0 ? gained / simulation.energy().scale() : 0;
}

// Whether most of what came from nowhere is what springs store that took over from a law that stores less: no dt
// changes that.
bool is_gain_of_laws(const EnergyLedger& energy) { return energy.law_changes < std::min(0.0, energy.numerical); }

std::string source_of_gain(const EnergyLedger& energy) {
  return is_gain_of_laws(energy) ? "joints that went over to springs as they slid or broke" : "time integration";
}

// What is not set already: gamma is 1 or more in the thesis' scheme and in generalized_alpha 0.
std::string remedy_against_steps(const Model& model) {
  const bool damps = std::ranges::all_of(
      model.stages, [](const Stage& stage) { return stage.integrator.is_static || stage.integrator.gamma >= 1; });
  return damps ? "a smaller dt, or damping" : "generalized_alpha 0 or thesis, or a smaller dt";
}

std::string remedy_against_gain(const Simulation& simulation) {
  if (!is_gain_of_laws(simulation.energy())) return remedy_against_steps(simulation.model());
  return "the law \"projected\" for dry joints, or stiffer springs (\"spring_over_young\", or none named): what they "
         "store with the force they take over nothing has brought, whatever the dt";
}

bool has_material_damping(const Model& model) {
  return std::ranges::any_of(model.stages, [](const Stage& stage) { return stage.material_damping.acts(); });
}

// What loads, weight and motions did in all, and what was there at the start, J per m of thickness. What a load takes
// back is off it.
double brought(const EnergyLedger& energy) {
  return std::abs(energy.external_work) + std::abs(energy.gravity_work) + energy.initial.sum();
}

// What static stages take is damping in the ledger, so this is of stages in motion.
std::string loss_of_steps(const Simulation& simulation) {
  const EnergyLedger& energy = simulation.energy();
  const double all = std::max(brought(energy), energy.scale());  // a load that goes again has brought nothing in all
  if (!(energy.numerical >= noted_loss * all) || energy.numerical < tolerated_residual * energy.scale() || all == 0)
    return "";
  const std::string cause =
      simulation.plan().contacts_can_change
          ? "what impacts lose that a step does not resolve, more of it the longer the step; where blocks bounce or "
            "go on after an impact, compare with a smaller dt"
          : "waves that a step does not resolve; take a smaller dt";
  return fmt::format("warning: time integration took {:.3g} J/m, {:.2g} % of the energy that was brought: {}",
                     energy.numerical, 100 * energy.numerical / all, cause);
}

// Dampers take energy. Where a support jumps within a step, those that are too long for the damping give it back, and
// the integrator's own losses hide that. It is measured by what loads and motions brought, as what is there may be of
// it.
std::string gift_of_dampers(const Simulation& simulation) {
  const EnergyLedger& energy = simulation.energy();
  const double given = -energy.damping;
  if (!(given > 0) || !has_material_damping(simulation.model())) return "";
  if (given < tolerated_residual * energy.scale()) return "";
  if (given < ruinous_gain * std::min(brought(energy), energy.scale())) return "";
  return fmt::format(
      "damping gave {:.3g} J/m, {:.2g} % of the largest energy, which it can only take: a velocity jumps, and dt is "
      "too "
      "long for the damping of what it excites; take a smaller dt, or let the velocity grow over some steps",
      given, 100 * given / energy.scale());
}

}  // namespace

RunVerdict judge_energy(const Simulation& simulation) {
  const EnergyLedger& energy = simulation.energy();
  const double gain = energy.gain();
  const std::string added = fmt::format("{} added {:.3g} J/m, {:.2g} % of the largest energy", source_of_gain(energy),
                                        energy.gained(), 100 * gain);
  const std::string remedy = remedy_against_gain(simulation);
  const bool is_of_start = energy.gained() <= gain_at_start(simulation.system());
  if (gain >= ruinous_gain && !is_of_start)
    return {Status::gained_energy,
            fmt::format("{}; most of the motion is that of {}; take {}", added,
                        named_with_places(simulation.model(), liveliest_blocks(simulation)), remedy)};
  if (const std::string gift = gift_of_dampers(simulation); !gift.empty()) return {Status::inaccurate, gift};
  const double residual = std::abs(energy.relative_residual());
  if (!(residual <= tolerated_residual))
    return {Status::inaccurate,
            fmt::format("the energies do not add up: {:.2g} of the largest is missing, {:g} is allowed; springs far "
                        "stiffer than their blocks, or a dt far too long for them, take the digits of a solve",
                        residual, tolerated_residual)};
  if (gain >= tolerated_gain && is_of_start)
    return {Status::ok, fmt::format("warning: {}, as its first steps do where blocks are let go on contacts that dt "
                                    "does not resolve, and lose again: velocities are not to be trusted yet; take more "
                                    "steps, or a smaller dt",
                                    added)};
  if (gain >= tolerated_gain) return {Status::ok, fmt::format("warning: {}; take {}", added, remedy)};
  const double passing = simulation.follows_contacts() ? passing_gain(simulation) : 0;
  if (passing >= tolerated_passing_gain)
    return {
        Status::ok,
        fmt::format("warning: for a while there was {:.2g} % of the largest energy more than was brought, and it was "
                    "lost again; take {}",
                    100 * passing, remedy_against_steps(simulation.model()))};
  return {Status::ok, loss_of_steps(simulation)};
}

}  // namespace dda
