#include "engine/model/model.h"

#include <algorithm>
#include <cstddef>

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

template <typename Table>
bool any_later_stage_has(const Model& model, Table RockOfStage::*table) {
  for (std::size_t i = 1; i < model.stages.size(); ++i)
    if (!(model.stages[i].rock.*table).empty()) return true;
  return false;
}

}  // namespace

const Material& Model::material_of(int block) const { return materials[at(blocks[at(block)].material)]; }

const Material& Model::material_at_start(int block) const {
  // As materials_in(*this, 0), without a call: contacts ask for it in every step.
  const bool has_changed = !stages.empty() && !stages.front().rock.materials.empty();
  return (has_changed ? stages.front().rock.materials : materials)[at(blocks[at(block)].material)];
}

int Model::joint_index(int block_a, int block_b) const {
  if (joint_of_block_pair.empty()) return 0;
  const auto found = joint_of_block_pair.find({std::min(block_a, block_b), std::max(block_a, block_b)});
  return found == joint_of_block_pair.end() ? 0 : found->second;
}

const JointMaterial& Model::joint_between(int block_a, int block_b) const {
  return joints[at(joint_index(block_a, block_b))];
}

bool Model::stays_linear() const {
  return bolts.empty() && std::ranges::none_of(linings, &Lining::yields) &&
         std::ranges::all_of(joints, [](const JointMaterial& joint) { return joint.bonded; }) &&
         std::ranges::all_of(stages, [](const Stage& stage) { return stage.kinematics == Kinematics::small; });
}

Stage Model::with_acting_corrections(const Stage& stage) const {
  Stage acting = stage;
  if (stays_linear() && !stage.integrator.is_static && !changes_materials(*this) && !adds_blocks()) return acting;
  acting.correct_block_dispersion = acting.correct_time_dispersion = false;
  return acting;
}

bool Model::is_held(int block) const {
  return std::any_of(held_blocks.begin(), held_blocks.end(),
                     [block](const HeldBlock& held) { return held.block == block; });
}

bool Model::removes_blocks() const {
  return std::ranges::any_of(stages, [](const Stage& stage) { return !stage.removal.blocks.empty(); });
}

bool Model::adds_blocks() const {
  return std::ranges::any_of(stages, [](const Stage& stage) { return !stage.rock.added.empty(); });
}

std::vector<bool> Model::absent_in(std::size_t stage) const {
  std::vector<bool> absent(removes_blocks() || adds_blocks() ? blocks.size() : 0, false);
  const auto mark = [&absent](const std::vector<int>& some, bool as_absent) {
    for (const int block : some) absent[at(block)] = as_absent;
  };
  for (std::size_t i = stages.size(); i > stage + 1; --i) {  // what comes next tells what is now
    mark(stages[i - 1].removal.blocks, false);
    mark(stages[i - 1].rock.added, true);
  }
  for (std::size_t i = 0; i <= stage && i < stages.size(); ++i) {
    mark(stages[i].removal.blocks, true);
    mark(stages[i].rock.added, false);
  }
  if (std::ranges::count(absent, true) == 0) absent.clear();
  return absent;
}

double Model::mass_of(int block) const { return material_of(block).density * blocks[at(block)].moments.area; }

double Model::mass_at_start(int block) const {
  return material_at_start(block).density * blocks[at(block)].moments.area;
}

bool changes_materials(const Model& model) { return any_later_stage_has(model, &RockOfStage::materials); }
bool changes_joints(const Model& model) { return any_later_stage_has(model, &RockOfStage::joints); }

}  // namespace dda
