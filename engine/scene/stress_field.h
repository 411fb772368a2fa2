// The stress in the ground before anything is done to it, as the section `stress_field` gives it: a part that is the
// same everywhere, and one that grows with depth below a level surface, in each layer of the ground as its rock weighs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

class StressField {
 public:
  // `own_stress`: of each block whether it states its initial stress itself, which goes before the field.
  StressField(const Field& scene, std::vector<bool> own_stress, const Model& model);

  // Gives every block that states none, and is there in the first stage, the stress of the field at its centroid.
  void fill(Model& model) const;

  // A sentence where all blocks that the field is for lie above its surface, so that none gets what grows with depth.
  [[nodiscard]] std::optional<std::string> remark_on_surface(const Model& model) const;

  // These blocks got a stress in another way since: what lies beyond them exerts that one.
  void leave_to_themselves(const std::vector<int>& blocks);

  // What the surroundings exert on a stretch of a block, Pa: by the field in its middle, where its forces are then
  // those of a field that grows linearly along it; by the block's own stress where it states one.
  [[nodiscard]] Vec2 traction_on(const Stretch& stretch, const Model& model) const;

 private:
  [[nodiscard]] Vec3 at(const Vec2& point) const;
  [[nodiscard]] bool states_own(int block) const { return own_stress_[static_cast<std::size_t>(block)]; }

  // From the one above it, or the surface, down to `bottom`.
  struct Layer {
    double bottom;    // m, a y
    double gradient;  // Pa/m, by which vertical pressure grows with depth
    double k0;        // horizontal over vertical pressure
  };

  static std::vector<Layer> read_layers(const Field& field, const Model& model, double surface);
  [[nodiscard]] Vec3 of_depth(double y) const;

  std::vector<bool> own_stress_;
  Vec3 constant_ = Vec3::Zero();  // Pa, tension positive
  double surface_ = 0;            // m, y above which there is none of the part that grows
  std::vector<Layer> layers_;     // from above; empty: no such part
};

// xx, yy and xy, as far as they are given.
Vec3 read_stress(const Field& field);

}  // namespace dda
