// Bonded grids as a whole: rigid motions, uniform strain (patch test), and the smallest eigenvalue of the stiffness.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <string>

#include "engine/builder/generators.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/support.h"

namespace dda {
namespace {

constexpr double young = 3.0;

struct GridCase {
  std::string name;
  PlaneState plane;
  double poisson;
  double width;  // of a block 1 m high
  GridPattern pattern;
  double penalty = 4;
};

Model grid_of(const GridCase& given, InterfaceLaw law, int size, double angle = 0) {
  Model model = model_of(std::vector<Polygon>{}, {"rock", 1, young, given.poisson, given.plane});
  append_grid(model,
              {.columns = size, .rows = size, .block_width = given.width, .block_height = 1, .pattern = given.pattern});
  model.joints = {{.name = "bond", .law = law, .bonded = true, .penalty = given.penalty}};
  place(model, angle);
  return model;
}

Eigen::MatrixXd stiffness_matrix(const Model& model, const ContactSet& contacts) {
  const auto unknowns = static_cast<Eigen::Index>(6 * model.blocks.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const auto strains = static_cast<Eigen::Index>(6 * i) + 3;
    k.block<3, 3>(strains, strains) +=
        strain_stiffness(model.blocks[i].moments.area, elasticity_matrix(model.materials[0]));
  }
  for (const InterfaceElement& element : contacts.elements.own()) {
    const InterfaceMatrices part = stiffness_of(element, Vec4::Ones());
    const Eigen::Index a = 6 * element.block_a;
    const Eigen::Index b = 6 * element.block_b;
    k.block<6, 6>(a, a) += part.aa;
    k.block<6, 6>(b, b) += part.bb;
    k.block<6, 6>(b, a) += part.ba;
    k.block<6, 6>(a, b) += part.ba.transpose();
  }
  return k;
}

// All blocks follow u = gradient * x + rotation.
Eigen::VectorXd uniform_motion(const Model& model, const Vec3& strain, double turn, const Vec2& shift) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(6 * model.blocks.size()));
  Vec6 field;
  field << shift, turn, strain;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    q.segment<6>(static_cast<Eigen::Index>(6 * i)) << displacement_rows(model.blocks[i].moments.centroid) * field, turn,
        strain;
  return q;
}

// Forces on the six unknowns of every block by the traction of a uniform stress on the outline of the whole grid: what
// the blocks' own areas carry, less what their neighbours hand over. Of the blocks inside it is nothing.
bool is_inside(const Model& model, const ContactSet& contacts, std::size_t block) {
  double held = 0;
  for (const Interface& interface : contacts.interfaces)
    if (interface.block_a == static_cast<int>(block) || interface.block_b == static_cast<int>(block))
      held += interface.length;
  const Ring& ring = model.blocks[block].shape.outer;
  double outline = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) outline += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return held > outline * (1 - 1e-9);
}

const std::array grids = {
    GridCase{"stress_25_square", PlaneState::stress, 0.25, 1, GridPattern::stack},
    GridCase{"stress_33_square", PlaneState::stress, 0.33, 1, GridPattern::stack},
    GridCase{"strain_45_square", PlaneState::strain, 0.45, 1, GridPattern::stack},
    GridCase{"stress_25_long", PlaneState::stress, 0.25, 2, GridPattern::stack},
    GridCase{"stress_33_high", PlaneState::stress, 0.33, 0.5, GridPattern::stack},
    GridCase{"strain_45_long", PlaneState::strain, 0.45, 2, GridPattern::stack},
    GridCase{"stress_25_running_bond", PlaneState::stress, 0.25, 2, GridPattern::running_bond},
    GridCase{"stress_33_running_bond_square", PlaneState::stress, 0.33, 1, GridPattern::running_bond},
    GridCase{"strain_45_running_bond", PlaneState::strain, 0.45, 2, GridPattern::running_bond},
    GridCase{"strain_499_square", PlaneState::strain, 0.499, 1, GridPattern::stack},
    GridCase{"strain_499_running_bond", PlaneState::strain, 0.499, 2, GridPattern::running_bond},
};

class BondedGrid : public testing::TestWithParam<GridCase> {};
INSTANTIATE_TEST_SUITE_P(Contact, BondedGrid, testing::ValuesIn(grids),
                         [](const auto& each) { return each.param.name; });

// Nine interfaces around a block, each with entries of the size of the stiffness.
constexpr double round_off = 1e-12;

TEST_P(BondedGrid, UniformStrainIsInEquilibriumInside) {
  for (const double angle : {0.0, 0.5}) {
    const Model model = grid_of(GetParam(), InterfaceLaw::consistent, 4, angle);
    const ContactSet contacts = make_contacts(model);
    const Eigen::MatrixXd k = stiffness_matrix(model, contacts);
    const Eigen::VectorXd force = k * uniform_motion(model, Vec3(1, -0.6, 0.8), 0.3, Vec2(2, -1));
    int inside = 0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      if (!is_inside(model, contacts, i)) continue;
      ++inside;
      EXPECT_LT(force.segment<6>(static_cast<Eigen::Index>(6 * i)).cwiseAbs().maxCoeff(),
                round_off * k.cwiseAbs().maxCoeff());
    }
    EXPECT_GE(inside, 4);
  }
}

TEST_P(BondedGrid, ClassicalSpringsFailThatTest) {
  const Model model = grid_of(GetParam(), InterfaceLaw::classical, 4);
  const ContactSet contacts = make_contacts(model);
  const Eigen::VectorXd force =
      stiffness_matrix(model, contacts) * uniform_motion(model, Vec3(1, -0.6, 0.8), 0, Vec2::Zero());
  double largest = 0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (is_inside(model, contacts, i))
      largest = std::max(largest, force.segment<6>(static_cast<Eigen::Index>(6 * i)).cwiseAbs().maxCoeff());
  // Without gaps the springs carry nothing, so that each block's area times its stress is out of balance.
  EXPECT_GT(largest, 0.1 * young * GetParam().width / 2);
}

TEST_P(BondedGrid, ExactlyThreeMotionsAreFree) {
  const Model model = grid_of(GetParam(), InterfaceLaw::consistent, 4, 0.3);
  const ContactSet contacts = make_contacts(model);
  const Eigen::MatrixXd k = stiffness_matrix(model, contacts);
  for (const auto& [turn, shift] : {std::pair(0.0, Vec2(1, 0)), {0.0, Vec2(0, 1)}, {1.0, Vec2(0, 0)}}) {
    const Eigen::VectorXd force = k * uniform_motion(model, Vec3::Zero(), turn, shift);
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 10 * round_off * k.cwiseAbs().maxCoeff());  // arms up to 6 m
  }
  const Eigen::VectorXd modes = dense_modes(k).squares;
  const double largest = modes.tail<1>()(0);
  EXPECT_LT(modes.head<3>().cwiseAbs().maxCoeff(), 1e-12 * largest);
  EXPECT_GT(modes(3), 1e-6 * largest);
  RecordProperty("fourth_over_largest", std::to_string(modes(3) / largest));
}

TEST_P(BondedGrid, SupportedStiffnessIsPositive) {
  for (const int size : {2, 3, 6}) {
    const Model model = grid_of(GetParam(), InterfaceLaw::consistent, size);
    Eigen::MatrixXd k = stiffness_matrix(model, make_contacts(model));
    // Both lower corners of the first block held as stiffly as rock of its size.
    for (const double x : {0.0, 0.5 * GetParam().width})
      k.topLeftCorner<6, 6>() +=
          support_stiffness(displacement_rows(Vec2(x, 0) - model.blocks[0].moments.centroid), young * Mat2::Identity());
    const Eigen::VectorXd modes = dense_modes(k).squares;
    // A square of n blocks bends with a stiffness that falls as 1/n^2 and more; 1e-12 is round-off of the solver.
    EXPECT_GT(modes(0), 1e-8 * modes.tail<1>()(0)) << size << " blocks a side";
  }
}

// The patch test of a cubic chain: the strain it carries without sideways force, between its free sides.
TEST(CubicChain, UniformStretchIsInEquilibriumAndOnlyThreeMotionsAreFree) {
  for (const double poisson : {0.0, 0.25, 0.45}) {
    Model model = model_of(std::vector<Polygon>{}, {"rock", 1, young, poisson, PlaneState::strain});
    append_bar(model, {.length = 5, .height = 0.8, .block_length = 1});
    model.joints = {{.name = "bond", .law = InterfaceLaw::cubic, .bonded = true}};
    place(model, 0.4);
    const ContactSet contacts = make_contacts(model);
    for (const InterfaceElement& element : contacts.elements.own()) ASSERT_EQ(element.law, InterfaceLaw::cubic);
    const Eigen::MatrixXd k = stiffness_matrix(model, contacts);
    // Strain of uniaxial stress along the bar.
    const Vec3 along = rotate_stress(Vec3(1, 0, 0), 0.4);
    const Vec3 strain = elasticity_matrix(model.materials[0]).inverse() * along;
    const Eigen::VectorXd force = k * uniform_motion(model, strain, 0.3, Vec2(2, -1));
    EXPECT_LT(force.segment(6, 18).cwiseAbs().maxCoeff(), round_off * k.cwiseAbs().maxCoeff());
    const Eigen::VectorXd modes = dense_modes(k).squares;
    const double largest = modes.tail<1>()(0);
    EXPECT_LT(modes.head<3>().cwiseAbs().maxCoeff(), 1e-12 * largest);
    EXPECT_GT(modes(3), 1e-6 * largest);
  }
}

}  // namespace
}  // namespace dda
