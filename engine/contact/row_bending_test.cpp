// Bending stiffness of joints in rows one block wide, against the energy of bent half beams.
#include "engine/contact/row_bending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/scene/generators.h"

namespace dda {
namespace {

Model consistent_pair(const std::vector<Polygon>& shapes) {
  Model model = model_of(shapes);
  model.joints = {{.name = "bond", .law = InterfaceLaw::consistent, .bonded = true}};
  return model;
}

double bending_row(const Model& model) { return make_contacts(model).elements.at(0).stiffness(2); }

TEST(RowBending, EnergyOfATurnedJointIsThatOfItsBentHalves) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> size(0.2, 5);
  for (int i = 0; i < 200; ++i) {
    const double height = size(random);
    const double first = size(random);
    const double last = size(random);
    Model model = consistent_pair({{box_ring(-first, 0, 0, height), {}}, {box_ring(0, 0, last, height), {}}});
    model.materials.push_back(
        {"other", 2000, 1e8 * size(random), 0.3, i % 2 ? PlaneState::strain : PlaneState::stress});
    model.blocks[1].material = 1;
    place(model, size(random), Vec2(3, -1));
    const double modulus = model.materials[1].young / (i % 2 ? 1 - 0.3 * 0.3 : 1);
    const double second_moment = height * height * height / 12;
    const double turn = 1e-3;
    const double moment = turn / (first / 2 / (1e9 * second_moment) + last / 2 / (modulus * second_moment));
    const double gap = turn * height / 2;
    EXPECT_NEAR(bending_row(model) * gap * gap, moment * turn, 1e-9 * moment * turn);  // round-off of the places
  }
}

TEST(RowBending, HeldBlocksAreRigid) {
  Model model = consistent_pair({{box_ring(-2, 0, 0, 1), {}}, {box_ring(0, -3, 4, 5), {}}});
  model.held_blocks.push_back({});
  model.held_blocks.back().block = 1;
  EXPECT_NEAR(bending_row(model), 1e9 / 3, 1e-3);
}

TEST(RowBending, AGivenStabilisationStays) {
  Model model = consistent_pair({{box_ring(-1, 0, 0, 1), {}}, {box_ring(0, 0, 1, 1), {}}});
  EXPECT_NEAR(bending_row(model), 1e9 / 3, 1e-3);
  const Vec4 before = make_contacts(model).elements.at(0).stiffness;
  model.joints[0].stabilisation = default_stabilisation;
  const Vec4 given = make_contacts(model).elements.at(0).stiffness;
  EXPECT_EQ(given(2), given(3));
  for (const Eigen::Index row : {0, 1, 3}) EXPECT_EQ(before(row), given(row));
}

// The oracle is the stiffness of a mesh: that of a given stabilisation.
void expect_mesh(Model model) {
  model.joints = {{.name = "bond", .law = InterfaceLaw::consistent, .bonded = true}};
  const ContactSet free = make_contacts(model);
  model.joints[0].stabilisation = default_stabilisation;
  const ContactSet given = make_contacts(model);
  ASSERT_FALSE(free.elements.empty());
  for (std::size_t i = 0; i < free.elements.size(); ++i)
    EXPECT_EQ(free.elements[i].stiffness, given.elements[i].stiffness) << i;
}

TEST(RowBending, MeshesStayAsTheyAre) {
  Model grid = model_of(std::vector<Polygon>{});
  append_grid(grid, {.columns = 4, .rows = 2, .block_width = 1, .block_height = 1});
  grid.materials = {rock()};
  finish_model(grid);
  expect_mesh(grid);
  expect_mesh(model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(0, 1, 1, 2), {}}, {box_ring(1, 1, 2, 2), {}}}));
  expect_mesh(model_of({{Ring{{0, 0}, {1, 0}, {0, 1}}, {}}, {Ring{{1, 0}, {1, 1}, {0, 1}}, {}}}));  // triangles
}

}  // namespace
}  // namespace dda
