// What the stages that are over have left for those who ask how they ended, and who is to be called then.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "engine/model/energy.h"
#include "engine/simulation/excess_shear.h"
#include "engine/simulation/reinforcement_in_air.h"
#include "engine/simulation/shared_ground.h"
#include "engine/simulation/unbalanced_block.h"
#include "engine/simulation/water_apart.h"

namespace dda {

struct StageResults {
  std::vector<double> out_of_balance;  // at the end of every stage; NaN for stages that are not static or not over
  std::vector<EnergyLedger> energy;    // at the end of every stage that is over
  // Blocks that had no equilibrium in static stages that asked for it, because nothing holds them. They were held where
  // they were for the rest of the stage, so that the others could settle, and are free again after it.
  std::vector<UnbalancedBlock> loose;
  // Blocks that were out of balance at the end of static stages by more than these ask for, the worst of each first.
  std::vector<UnbalancedBlock> unbalanced;
  std::vector<ExcessShear> excess;  // by joint; of a stage of unlimited strength before what is too much slides

  std::vector<SharedGroundOfStage> shared_ground;  // of static stages that left blocks in each other

  std::vector<ReinforcementInAir> in_air;  // bolts and linings that stages put in where blocks had parted

  std::vector<WaterApart> water_apart;  // of stages that ended with water in joints whose blocks had left

  explicit StageResults(std::size_t stages = 0)
      : out_of_balance(stages, std::numeric_limits<double>::quiet_NaN()), energy(stages) {}

  // Results of the first `stages` stages are those of the run before.
  void go_on_from(const StageResults& before, std::size_t stages) {
    std::copy_n(before.out_of_balance.begin(), stages, out_of_balance.begin());
    std::copy_n(before.energy.begin(), stages, energy.begin());
    loose = before.loose;
    unbalanced = before.unbalanced;
    excess = before.excess;
    shared_ground = before.shared_ground;
    in_air = before.in_air;
    water_apart = before.water_apart;
  }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [out_of_balance, energy, loose, unbalanced, excess, shared_ground, in_air, water_apart] = self;
    archive(loose, unbalanced, excess, shared_ground, in_air, water_apart);
    archive.each(out_of_balance);
    archive.each(energy);
  }
};

// Who is called at the end of stages; nobody where left empty.
struct StageWatch {
  // At the end of every stage, whatever came of it: supports that end with it are still there, and the next stage has
  // not taken velocities or removed blocks.
  std::function<void()> at_end;
  // Between two stages, and after the last one: what ends with the stage has ended, and nothing of the next has begun.
  // Not after a stage that should have come to equilibrium and has not.
  std::function<void()> between;
};

}  // namespace dda
