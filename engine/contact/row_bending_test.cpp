// Bending stiffness of joints in rows one block wide, against the energy of bent half beams.
#include "engine/contact/row_bending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "engine/builder/generators.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

Model consistent_pair(const std::vector<Polygon>& shapes) {
  Model model = model_of(shapes);
  model.joints = {{.name = "bond", .law = InterfaceLaw::consistent, .bonded = true}};
  return model;
}

double bending_row(const Model& model) { return make_contacts(model).elements.own().at(0).stiffness(2); }

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

// The piece of a ring of radii `inner` and `outer` between two directions.
Ring voussoir(double inner, double outer, double from, double to) {
  const Vec2 first(std::cos(from), std::sin(from));
  const Vec2 last(std::cos(to), std::sin(to));
  return {inner * first, outer * first, outer * last, inner * last};
}

// Joints lean against the axes of both voussoirs, by half of what these turn by.
TEST(RowBending, VoussoirsBendAsTheBeamsThatTheyArePiecesOf) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double turn = 0.02 + 0.75 * any(random);
    const double inner = 2 + any(random);
    const double thickness = (0.01 + 0.15 * any(random)) * inner;  // thicker ones are no pieces of a beam
    const double outer = inner + thickness;
    Model model = consistent_pair({{voussoir(inner, outer, -turn, 0), {}}, {voussoir(inner, outer, 0, turn), {}}});
    place(model, 6 * any(random), Vec2(3, -1));
    const double height = thickness * std::cos(turn / 2);                                  // across the axis
    double to_joints = 0;                                                                  // from the centroids
    for (const Block& block : model.blocks) to_joints += block.moments.area / height / 2;  // half of the mean length
    const double stiffness = 4 * 1e9 * std::pow(height, 3) / 12 / to_joints / (thickness * thickness);
    EXPECT_NEAR(bending_row(model) / stiffness, 1, 0.01) << turn << " " << thickness / inner;
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
  const Vec4 before = make_contacts(model).elements.own().at(0).stiffness;
  model.joints[0].stabilisation = default_stabilisation;
  const Vec4 given = make_contacts(model).elements.own().at(0).stiffness;
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

// Two bonded layers of three blocks each, or one layer on blocks that are no part of it. Joint 1 is the bed.
Model layers(const JointMaterial& bed, double shift = 0) {
  Model model = model_of(std::vector<Polygon>{});
  model.materials = {rock()};
  for (int i = 0; i < 3; ++i) model.blocks.emplace_back().shape = {box_ring(i, 0, i + 1, 0.7), {}};
  for (int i = 0; i < 3; ++i) model.blocks.emplace_back().shape = {box_ring(i + shift, 0.7, i + 1 + shift, 1.9), {}};
  model.joints = {{.name = "bond", .law = InterfaceLaw::consistent, .bonded = true}, bed};
  for (int a = 0; a < 3; ++a)
    for (int b = 3; b < 6; ++b) model.joint_of_block_pair[{a, b}] = 1;
  finish_model(model);
  return model;
}

// Returns how stiff every upright joint is against bending, over a bent beam of its height.
std::vector<double> upright_rows(const Model& model) {
  std::vector<double> rows;
  const ContactSet contacts = make_contacts(model);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (contacts.interfaces[i].length > 0 && std::abs(contacts.interfaces[i].normal.x()) > 0.5)
      rows.push_back(contacts.elements[i].stiffness(2) / (1e9 * contacts.interfaces[i].length / 3));
  return rows;
}

void expect_beams(const Model& model) {
  const std::vector<double> rows = upright_rows(model);
  ASSERT_EQ(rows.size(), 4U);
  for (const double row : rows) EXPECT_NEAR(row, 1, 1e-9);
}

TEST(RowBending, WhatOnlyPressesOnARowLeavesItItsStiffness) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.9, 0.9);
  JointMaterial smooth{.name = "bed", .law = InterfaceLaw::classical};
  JointMaterial rough{.name = "bed", .law = InterfaceLaw::consistent};
  rough.friction_angle = 0.5;
  for (const JointMaterial& bed : {smooth, rough}) {
    expect_beams(layers(bed));  // corners meet corners
    for (int i = 0; i < 20; ++i) expect_beams(layers(bed, shift(random)));
  }
}

TEST(RowBending, ALayerBondedToAnotherIsAMesh) {
  JointMaterial bond{.name = "bed", .law = InterfaceLaw::consistent, .cohesion = 1e6, .tensile_strength = 1e6};
  for (const double row : upright_rows(layers(bond))) EXPECT_LT(row, 0.5);
  bond.bonded = true;
  for (const double row : upright_rows(layers(bond))) EXPECT_LT(row, 0.5);
  bond.law = InterfaceLaw::classical;
  for (const double row : upright_rows(layers(bond, 0.3))) EXPECT_LT(row, 0.5);
}

// A row of six blocks of 1 x 0.7 m, and what is glued on top of it: `extra`, whose corners on the row are corners of
// it.
std::vector<double> rows_below(const std::vector<Ring>& extra) {
  Model model = model_of(std::vector<Polygon>{});
  model.materials = {rock()};
  for (int i = 0; i < 6; ++i) {
    Ring ring = box_ring(i, 0, i + 1, 0.7);
    std::vector<double> cuts;
    for (const Ring& each : extra)
      for (const Vec2& corner : each)
        if (std::abs(corner.y() - 0.7) < 1e-12 && corner.x() > i && corner.x() < i + 1) cuts.push_back(corner.x());
    std::ranges::sort(cuts, std::greater{});
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 0; k < cuts.size(); ++k) ring.insert(ring.begin() + 3 + static_cast<int>(k), {cuts[k], 0.7});
    model.blocks.emplace_back().shape = {ring, {}};
  }
  for (const Ring& each : extra) model.blocks.emplace_back().shape = {each, {}};
  model.joints = {{.name = "bond", .law = InterfaceLaw::consistent, .bonded = true}};
  finish_model(model);
  std::vector<double> rows;
  const ContactSet contacts = make_contacts(model);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (contacts.interfaces[i].block_b < 6)
      rows.push_back(contacts.elements[i].stiffness(2) / (1e9 * contacts.interfaces[i].length / 3));
  return rows;
}

void expect_a_beam_below(const std::vector<Ring>& extra) {
  const std::vector<double> rows = rows_below(extra);
  ASSERT_EQ(rows.size(), 5U);
  for (const double row : rows) EXPECT_NEAR(row, 1, 1e-9);
}

TEST(RowBending, WhatHangsAtABlockLeavesItsRowTheStiffness) {
  expect_a_beam_below({});
  for (const double width : {1e-3, 0.1, 0.9})  // however large
    for (const double left : {0.03, 2.05, 4.06})
      expect_a_beam_below({box_ring(left, 0.7, left + width, 0.7 + 5 * width)});
  expect_a_beam_below({box_ring(1, 0.7, 2, 1.4), box_ring(2.2, 0.7, 2.5, 0.8), box_ring(4.9, 0.7, 5, 1.4)});
}

// However small, as blocks of one strain bend in their joints, and there such a tie locks them: a cantilever of blocks
// of 1 m with ties of 1 mm on all joints but the first bends 0.50 times as far as a beam, and 0.44 times if its joints
// had the stiffness of a beam besides. Where it hardly bridges the joint, it hangs.
TEST(RowBending, ABlockThatBridgesAJointTakesItsPlace) {
  for (const double half : {1e-3, 1e-2, 0.1, 0.6}) {
    const std::vector<double> rows = rows_below({box_ring(3 - half, 0.7, 3 + half, 0.7 + half)});
    EXPECT_LT(rows[2], 0.5) << half;
    EXPECT_NEAR(rows[0], 1, 1e-9) << half;
  }
  for (const double beyond : {1e-6, 1e-3})
    EXPECT_NEAR(rows_below({box_ring(2, 0.7, 3 + beyond, 1.7)})[2], 1, 6 * beyond);
}

// A layer along the whole row makes a mesh of it by its thickness; composite beams grow stiffer by more.
TEST(RowBending, AThinLayerLeavesARowNearlyItsStiffness) {
  for (const double thickness : {1e-3, 0.07, 0.14, 0.35, 0.7}) {
    std::vector<Ring> layer;
    for (int i = 0; i < 6; ++i) layer.push_back(box_ring(i, 0.7, i + 1, 0.7 + thickness));
    const double row = rows_below(layer)[2];
    const double share = thickness / 0.7;
    EXPECT_GT(row, 1 - 3 * share) << thickness;
    EXPECT_GT(row + 3 * share * (1 + share), 1) << thickness;
    EXPECT_LT(row, thickness < 0.35 ? 1 : 0.5) << thickness;
  }
}

TEST(RowBending, ARowIsOneOnceItsNeighboursAreRemoved) {
  Model model = layers({.name = "bed", .law = InterfaceLaw::consistent, .bonded = true});
  model.blocks.erase(model.blocks.begin() + 4, model.blocks.end());  // one block on the first one is left
  model.joint_of_block_pair = {{{0, 3}, 1}};
  finish_model(model);
  ContactSet contacts = make_contacts(model);
  for (InterfaceState& state : contacts.states) state.gap(2) = 1e-4;
  leave_out({false, false, false, true}, contacts);
  stiffen_rows(model, contacts);
  ASSERT_EQ(contacts.elements.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(contacts.elements[i].stiffness(2), 1e9 * 0.7 / 3, 1);
    EXPECT_EQ(contacts.states[i].force(2), contacts.elements[i].stiffness(2) * 1e-4);
  }
}

}  // namespace
}  // namespace dda
