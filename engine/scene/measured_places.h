// Where a measurement of a scene is taken: at a point, of a bolt, of a lining, of what is held, between blocks, across
// a line.
#pragma once

#include <optional>

#include "engine/builder/ground_plan.h"
#include "engine/builder/names.h"
#include "engine/model/model.h"
#include "engine/scene/block_sets.h"
#include "engine/scene/field.h"

namespace dda {

class MeasuredPlaces {
 public:
  // The arguments must outlive it.
  MeasuredPlaces(const GroundPlan& plan, const BlockSets& sets, const Model& model);

  // Fills all of `measurement` but its name and quantity, which must be set.
  void read(const Field& field, Measurement& measurement) const;

 private:
  void place_in_block(const Field& field, Measurement& measurement) const;
  void place_on_joint(const Field& field, Measurement& measurement) const;
  void place_on_bolt(const Field& field, Measurement& measurement) const;
  void place_on_lining(const Field& field, Measurement& measurement) const;
  void place_at_supports(const Field& field, Measurement& measurement) const;
  void place_between(const Field& field, Measurement& measurement) const;
  void place_along_joints(const Field& field, Measurement& measurement) const;
  void place_across_line(const Field& field, Measurement& measurement) const;
  [[nodiscard]] int block_at_point(const Field& field, const Vec2& point) const;
  void take_held(const std::optional<Field>& name, Measurement& measurement) const;

  const GroundPlan& plan_;
  const BlockSets& sets_;
  const Model& model_;
  Names bolts_, linings_, joints_;
};

}  // namespace dda
