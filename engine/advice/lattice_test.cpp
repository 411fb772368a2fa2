#include "engine/advice/lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/advice/lattice_test_support.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

TEST(Lattice, OfARow) {
  const Lattice lattice = lattice_of(row_of_blocks(bonded(InterfaceLaw::cubic), 2));
  EXPECT_TRUE(lattice.row);
  ASSERT_EQ(lattice.offsets.size(), 2U);
  EXPECT_NEAR(lattice.offsets[0].norm(), 2, 1e-12);
  EXPECT_NEAR((lattice.offsets[0] + lattice.offsets[1]).norm(), 0, 1e-12);
  EXPECT_EQ(lattice.joints[0].law, InterfaceLaw::cubic);
  ASSERT_EQ(lattice.face_normals().size(), 1U);
  EXPECT_EQ(lattice.face_normals()[0], Vec2(1, 0));
  EXPECT_NE(lattice.origin.find("everywhere"), std::string::npos);
}

TEST(Lattice, OfSquaresAndOfARunningBond) {
  const Lattice squares = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  EXPECT_FALSE(squares.row);
  EXPECT_EQ(squares.offsets.size(), 4U);
  EXPECT_TRUE(looks_the_same(squares, {1, 0}, {0, 1}));
  EXPECT_FALSE(looks_the_same(squares, {1, 0}, Vec2(1, 1).normalized()));
  const Lattice bond = lattice_of(courses(bonded(InterfaceLaw::consistent), 0.5, 0.5));
  EXPECT_EQ(bond.offsets.size(), 6U);
  EXPECT_FALSE(looks_the_same(bond, {1, 0}, {0, 1}));
  EXPECT_EQ(bond.face_normals().size(), 2U);
  // Square blocks, but not in a square pattern; and square patterns of joints that differ.
  EXPECT_FALSE(looks_the_same(lattice_of(courses(bonded(InterfaceLaw::consistent), 0.5)), {1, 0}, {0, 1}));
  Lattice striped = squares;
  for (std::size_t i = 0; i < striped.offsets.size(); ++i)
    if (std::abs(striped.offsets[i].x()) > 0.5) striped.joints[i].law = InterfaceLaw::classical;
  EXPECT_FALSE(looks_the_same(striped, {1, 0}, {0, 1}));
}

// What a block has on its right its copy has on its left.
TEST(Lattice, OppositeNeighboursHaveOneJoint) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent));
  model.joints.push_back(bonded(InterfaceLaw::classical));
  for (const int left : {0, 2, 4}) model.joint_of_block_pair[{left, left + 1}] = 1;
  const Lattice lattice = lattice_of(model);
  EXPECT_EQ(lattice.joints[0].law, lattice.joints[1].law);
}

TEST(Lattice, IsAssumedWhereBlocksAreNotAlike) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent));
  model.blocks.clear();
  for (const auto& [left, right] : {std::pair{0.0, 1.0}, {1.0, 2.5}, {2.5, 3.0}})
    model.blocks.emplace_back().shape.outer = box_ring(left, 0, right, 0.8);
  const Lattice lattice = lattice_of(finished(model));
  EXPECT_NE(lattice.origin.find("assumed"), std::string::npos);
  EXPECT_NEAR(lattice.offsets[0].norm(), 1.5, 1e-12);
  EXPECT_NEAR(signed_area(lattice.ring), 1.5 * 0.8, 1e-12);
}

TEST(Lattice, NoneWhereAMaterialTouchesNothingOfItsOwn) {
  Model model = row_of_blocks(bonded(InterfaceLaw::consistent), 1, 2);
  model.materials.push_back(rock());
  model.blocks[1].material = 1;
  EXPECT_FALSE(find_lattice(model, make_contacts(model), 1).has_value());
}

// Springs of a stiffness by the engine's own rule must stay what they are when blocks are scaled in the search.
TEST(Lattice, KeepsTheSpringsOfTheScene) {
  JointMaterial joint = bonded(InterfaceLaw::classical);
  joint.automatic_stiffness = true;
  const Model model = row_of_blocks(joint);
  const Lattice lattice = lattice_of(model);
  const double wanted = make_contacts(model).elements[0].stiffness(0);
  const auto stiffness_of_first = [](const Lattice& of) {
    return lattice_matrices(of, steps(trapezoidal_integrator(), 1e-4)).stiffness(0, 0);
  };
  EXPECT_NEAR(stiffness_of_first(lattice), 4 * wanted, 1e-9 * wanted);  // two springs on each side
  EXPECT_NEAR(stiffness_of_first(scaled(lattice, 2)), 4 * wanted, 1e-9 * wanted);
}

TEST(Lattice, ScaledRowsKeepTheirHeight) {
  const Lattice row = scaled(lattice_of(row_of_blocks(bonded(InterfaceLaw::cubic))), 3);
  EXPECT_NEAR(row.offsets[0].norm(), 3, 1e-12);
  EXPECT_NEAR(signed_area(row.ring), 3 * 0.8, 1e-12);
  const Lattice mesh = scaled(lattice_of(courses(bonded(InterfaceLaw::consistent), 0)), 3);
  EXPECT_NEAR(signed_area(mesh.ring), 9, 1e-12);
}

// The patch has none of the scene's blocks: `dda check` refused scenes with loads that change in a stage after one that
// removes rock, or in it.
TEST(Lattice, OfAStageThatRemovesBlocksHasTheSameMatrices) {
  const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  Stage stage = steps(trapezoidal_integrator(), 1e-4);
  const LatticeMatrices whole = lattice_matrices(lattice, stage);
  stage.removal.blocks = {3};
  stage.removal.relaxation = PiecewiseLinear{{0, 1}, {1, 0}};
  EXPECT_EQ(lattice_matrices(lattice, stage).stiffness, whole.stiffness);
}

}  // namespace
}  // namespace dda
