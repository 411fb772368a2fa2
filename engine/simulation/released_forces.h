// What removed blocks exerted on the others, as loads that fade: the relaxation of an excavation.
//
// The forces on the six unknowns of a block are those of dead loads f at offsets r from its centroid. They are kept as
// the sum of f and the sum of f r^T, which between them are the same six numbers and turn and stretch with the block:
// r = F r0, with its deformation F.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

// What exerted them: blocks that a stage removed, a bolt, a lining. It says how they fade.
enum class Released : std::uint8_t { blocks, bolt, lining };

class ReleasedForces {
 public:
  // From `start` (s) on `forces` (6 entries a block) act times the relaxation of what exerted them, a stage, bolt or
  // lining of that number; the deformation of each block is what it is then.
  void keep(Released what, std::size_t number, double start, const Eigen::VectorXd& forces,
            const std::vector<Mat2>& deformation);

  // Moves the points of attack with their blocks (finite kinematics).
  void update_geometry(const std::vector<Mat2>& deformation);

  void add_loads_at(const Model& model, double time, Eigen::VectorXd& force) const;

  // Whether the model has what exerted each of them: what a snapshot says may be damaged.
  [[nodiscard]] bool fit(const Model& model) const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [loads] = self;
    archive(loads);
  }

 private:
  struct Load {
    Released what = Released::blocks;
    std::size_t number = 0;
    double start = 0;  // s
    int block = 0;
    Vec2 force = Vec2::Zero();        // N
    Mat2 drawn_lever = Mat2::Zero();  // N m, of offsets as drawn
    Vec6 now = Vec6::Zero();          // on the unknowns

    template <typename Self, typename Archive>
    static void visit(Self& self, Archive& archive) {
      auto& [what, number, start, block, force, drawn_lever, now] = self;
      archive(what, number);
      archive.blocks(block);
      archive(start, force, drawn_lever, now);
    }
  };

  std::vector<Load> loads_;
};

}  // namespace dda
