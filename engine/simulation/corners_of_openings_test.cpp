// Openings in stressed rock whose corners lie where joints cross come in as much in finite kinematics as in small: the
// blocks across a crossing lie in each other there by what strains make of them, which is no contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/simulation/lot.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr int scenes = 60;

// Blocks in columns and rows under a uniform stress, of which some in the middle are taken out at once.
class Opening {
 public:
  Opening(Lot& lot, const Stage& stage) {
    width_ = lot.power(-0.5, 0.7);
    height_ = width_ * lot.between(0.6, 1.7);
    angle_ = lot.one_of(0, 1) == 0 ? 0 : lot.between(-3, 3);
    const int wide = lot.one_of(1, 3), high = lot.one_of(1, 3);
    columns_ = wide + 2 * lot.one_of(2, 3);
    rows_ = high + 2 * lot.one_of(2, 3);
    Material material = rock_of(lot.power(9, 10.5));
    material.poisson = lot.between(0, 0.35);
    model.materials = {material};
    model.joints = {joint_by_lot(lot)};
    const double vertical = -material.young * lot.power(-3.5, -2.7);
    const Vec3 stress = turned(vertical * lot.between(0.6, 1.5), vertical);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) add_block(column, row, stress);
    model.supports = {{0, place(0, 0), true, true, 1e3 * material.young, Vec2::Zero(), {}},
                      {columns_ - 1, place(columns_, 0), true, true, 0.1 * material.young, Vec2::Zero(), {}}};
    model.stages = {stage, stage};
    const int left = (columns_ - wide) / 2, below = (rows_ - high) / 2;
    for (int row = below; row < below + high; ++row)
      for (int column = left; column < left + wide; ++column)
        model.stages[1].removal.blocks.push_back(row * columns_ + column);
  }

  Model model;

 private:
  static JointMaterial joint_by_lot(Lot& lot) {
    JointMaterial joint = dry_projected(lot.between(1.2, 2));
    const int kind = lot.one_of(0, 2);
    if (kind == 0) return joint;
    if (kind == 1) joint.law = InterfaceLaw::consistent;
    joint.cohesion = joint.tensile_strength = 1e12;
    return joint;
  }

  [[nodiscard]] Vec2 place(int column, int row) const {
    const double x = column * width_, y = row * height_;
    return {std::cos(angle_) * x - std::sin(angle_) * y, std::sin(angle_) * x + std::cos(angle_) * y};
  }

  [[nodiscard]] Vec3 turned(double along, double across) const {
    const double c = std::cos(angle_), s = std::sin(angle_);
    return {along * c * c + across * s * s, along * s * s + across * c * c, (along - across) * s * c};
  }

  void add_block(int column, int row, const Vec3& stress) {
    Block& block = model.blocks.emplace_back();
    const int number = static_cast<int>(model.blocks.size()) - 1;
    block.shape.outer = {place(column, row), place(column + 1, row), place(column + 1, row + 1),
                         place(column, row + 1)};
    block.initial_stress = stress;
    for (std::size_t edge = 0; edge < 4; ++edge) {
      const bool outside = (edge == 0 && row == 0) || (edge == 1 && column == columns_ - 1) ||
                           (edge == 2 && row == rows_ - 1) || (edge == 3 && column == 0);
      if (!outside) continue;
      const Vec2 from = block.shape.outer[edge], to = block.shape.outer[(edge + 1) % 4];
      const Vec2 out = Vec2((to - from).y(), -(to - from).x()).normalized();
      const Vec2 traction(stress(0) * out.x() + stress(2) * out.y(), stress(2) * out.x() + stress(1) * out.y());
      model.edge_loads.push_back({number, from, to, traction, Constant{}});
    }
  }

  double width_ = 1, height_ = 1, angle_ = 0;  // m, rad
  int columns_ = 0, rows_ = 0;
};

std::vector<Vec2> displacements(int seed, const Stage& stage, int stages = 2) {
  Lot lot(seed);
  Model model = Opening(lot, stage).model;
  while (static_cast<int>(model.stages.size()) < stages) model.stages.push_back(stage);
  return displacements_of(std::move(model));
}

// Strains are some thousandths, by which what is of second order differs. Locked corners make 10 to 60 %.
TEST(CornersOfOpenings, ComeInAsInSmallKinematics) {
  for (int seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE(seed);
    Stage stage = settling_stage(1e-6);
    const std::vector<Vec2> finite = displacements(seed, stage);
    stage.kinematics = Kinematics::small;
    expect_alike(displacements(seed, stage), finite, 0.02);
  }
}

// What has come to rest is so where it lies, and not where it lay before its last step: nothing goes on in a stage in
// which nothing happens, but for what a last step of a hundred-thousandth of a block leaves.
TEST(CornersOfOpenings, HaveComeToRestWhereBlocksLie) {
  for (int seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE(seed);
    const Stage stage = settling_stage(1e-9);
    expect_alike(displacements(seed, stage), displacements(seed, stage, 3), 1e-4);
  }
}

}  // namespace
}  // namespace dda
