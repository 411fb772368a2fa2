// Dry rock whose blocks have corners that point inwards, as merged cells have, comes in as rock of the same blocks that
// nothing can part: a joint that stays closed is a stretch, wherever else its blocks could touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/simulation/lot.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

constexpr int scenes = 40;

// Fours of squares, most of them cut into three, which make an angle, and one; the four in the middle are taken out in
// the second stage. All is under a uniform stress.
class RockOfAngles {
 public:
  RockOfAngles(Lot& lot, const Stage& stage) : fours_(2 * lot.one_of(1, 3) + 1), size_(lot.power(-1, 0.5)) {
    const double young = lot.power(9.5, 11), vertical = -young * lot.power(-4.5, -3.5);
    model.materials = {rock_of(young)};
    model.materials[0].poisson = lot.between(0, 0.3);
    model.joints = {dry_projected(3)};
    model.stages = {stage, stage};
    stress_ = {vertical * lot.between(0.6, 1.5), vertical, 0};
    for (int row = 0; row < fours_; ++row)
      for (int column = 0; column < fours_; ++column) add_four(lot, column, row);
    load_outside();
  }

  Model model;

 private:
  void add_four(Lot& lot, int column, int row) {
    const bool is_middle = row == fours_ / 2 && column == fours_ / 2;
    const Vec2 corner(column, row);
    if (is_middle) model.stages[1].removal.blocks = {static_cast<int>(model.blocks.size())};
    if (is_middle || lot.is_one_in(5)) return add(corner, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    // As drawn the one is at the upper right; turned by quarters it is anywhere.
    const int quarters = lot.one_of(0, 3);
    const auto turned = [&](std::vector<Vec2> ring) {
      for (Vec2& point : ring)
        for (int i = 0; i < quarters; ++i) point = Vec2(-point.y(), point.x());
      return ring;
    };
    add(corner, turned({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    add(corner, turned({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}));
  }

  void add(const Vec2& four, const std::vector<Vec2>& around_its_middle) {
    Block& block = model.blocks.emplace_back();
    for (const Vec2& point : around_its_middle) block.shape.outer.push_back(size_ * (2 * four + Vec2(1, 1) + point));
    block.initial_stress = stress_;
  }

  void load_outside() {
    const double side = 2 * fours_ * size_;
    const auto outward = [&](const Vec2& middle) -> Vec2 {
      return {(middle.x() > 0.999 * side) - (middle.x() < 0.001 * side),
              (middle.y() > 0.999 * side) - (middle.y() < 0.001 * side)};
    };
    const double stiffness = model.materials[0].young;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const int number = static_cast<int>(i);
      const Ring& ring = model.blocks[i].shape.outer;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 from = ring[k], to = ring[(k + 1) % ring.size()], out = outward((from + to) / 2);
        if (from.norm() < 1e-6 * side)
          model.supports.push_back({number, from, true, true, stiffness, Vec2::Zero(), {}});
        if ((from - Vec2(side, 0)).norm() < 1e-6 * side)
          model.supports.push_back({number, from, false, true, stiffness, Vec2::Zero(), {}});
        if (out.isZero()) continue;
        const Vec2 traction(stress_.x() * out.x(), stress_.y() * out.y());
        model.edge_loads.push_back({number, from, to, traction, Constant{}});
      }
    }
  }

  int fours_;
  double size_;  // m, of a square
  Vec3 stress_ = Vec3::Zero();
};

// Joints at the opening gape in places where they have no strength. Springs in the place of stretches made 5 to 60 %.
TEST(InwardCorners, DryRockComesInAsRockThatNothingParts) {
  for (int seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE(seed);
    Lot lot(seed);
    Model model = RockOfAngles(lot, settling_stage(1e-8)).model;
    const std::vector<Vec2> dry = displacements_of(model);
    model.joints[0].cohesion = model.joints[0].tensile_strength = 1e12;
    expect_alike(displacements_of(model), dry, 0.03);
  }
}

}  // namespace
}  // namespace dda
