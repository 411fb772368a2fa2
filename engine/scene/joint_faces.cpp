#include "engine/scene/joint_faces.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/contact/interface.h"
#include "engine/scene/places.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// One flag a joint of the model: whether `edge` means it.
std::vector<bool> meant_joints(const Field& edge, const Model& model) {
  if (edge.is_text()) return std::vector<bool>(model.joints.size(), true);
  refuse(edge, {"from", "to", "cavity", "opening"}, "beside joints");
  std::vector<bool> meant(model.joints.size(), false);
  for (const Field& name : edge.at("joints").items()) meant[at(read_joint_reference(name, model))] = true;
  return meant;
}

// Which blocks are away in each stage.
class Presence {
 public:
  explicit Presence(const Model& model) {
    for (std::size_t stage = 0; stage < model.stages.size(); ++stage) absent_.push_back(model.absent_in(stage));
  }

  // The part of `stages` in which both blocks are there, the first time. (On blocks that come back no load can act.)
  [[nodiscard]] std::optional<StageSpan> of_both(int a, int b, const StageSpan& stages) const {
    std::size_t come = 0;
    while (come < absent_.size() && !(has(a, come) && has(b, come))) ++come;
    std::size_t gone = come;
    while (gone < absent_.size() && has(a, gone) && has(b, gone)) ++gone;
    StageSpan span{std::max(stages.first, static_cast<int>(come)), stages.last};
    if (gone < absent_.size() && !stages.is_over_in(gone)) span.last = static_cast<int>(gone) - 1;
    if (at(span.first) >= gone || stages.is_over_in(at(span.first))) return {};
    return span;
  }

 private:
  [[nodiscard]] bool has(int block, std::size_t stage) const {
    return absent_[stage].empty() || !absent_[stage][at(block)];
  }

  std::vector<std::vector<bool>> absent_;
};

}  // namespace

std::vector<PressedFace> faces_of_joints(const Field& edge, const StageSpan& stages, const Model& model) {
  const std::vector<bool> meant = meant_joints(edge, model);
  const Presence presence(model);
  std::vector<PressedFace> faces;
  for (const Interface& joint : find_interfaces(model)) {
    if (joint.from == joint.to || !meant[at(joint.joint)]) continue;  // a vertex on an edge has no face
    if (model.joints[at(joint.joint)].bonded) continue;               // cannot open: no water in it moves anything
    const std::optional<StageSpan> span = presence.of_both(joint.block_a, joint.block_b, stages);
    if (!span) continue;
    faces.push_back({{joint.block_a, joint.from, joint.to, -joint.normal}, *span});
    faces.push_back({{joint.block_b, joint.to, joint.from, joint.normal}, *span});
  }
  if (faces.empty()) edge.fail("joints along which blocks touch in these stages, and which can open");
  return faces;
}

}  // namespace dda
