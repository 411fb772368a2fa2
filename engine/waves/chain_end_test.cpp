// The half blocks at the free ends of cubic chains.
#include "engine/waves/chain_end.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/builder/generators.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/inertia.h"
#include "engine/terms/load.h"
#include "engine/terms/potential_check.h"
#include "engine/waves/cubic_inertia.h"

namespace dda {
namespace {

constexpr double round_off = 1e-11;  // some hundred products
constexpr double length = 1.6;       // of a block, along the chain
constexpr double width = 0.9;        // of the chain
constexpr std::array angles = {0.0, 0.4, 1.9, -2.6};

std::array<Material, 2> materials() {
  return {Material{"stress", 2.3, 5.0, 0.3, PlaneState::stress},
          Material{"strain", 2.3, 5.0, 0.35, PlaneState::strain}};
}

Model chain_of(int blocks, const Material& material = materials()[0], double angle = 0) {
  std::vector<Polygon> shapes;
  for (int i = 0; i < blocks; ++i) shapes.push_back({box_ring(i * length, 0, (i + 1) * length, width), {}});
  Model model = model_of(shapes, material);
  model.joints = {{.name = "bond", .law = InterfaceLaw::cubic, .bonded = true}};
  place(model, angle, Vec2(3, -2));
  return model;
}

std::vector<ChainEnd> ends_of(const Model& model) {
  const ContactSet contacts = make_contacts(model);
  return free_chain_ends(model, contacts.interfaces, contacts.elements);
}

std::vector<int> blocks_at_ends(const Model& model) {
  std::vector<int> blocks;
  for (const ChainEnd& end : ends_of(model)) blocks.push_back(end.block);
  return blocks;
}

TEST(ChainEnd, BothEndsOfAFreeChain) {
  for (const double angle : angles) {
    const Model model = chain_of(3, materials()[0], angle);
    const std::vector<ChainEnd> ends = ends_of(model);
    ASSERT_EQ(ends.size(), 2U);
    const Vec2 along(std::cos(angle), std::sin(angle));
    for (const ChainEnd& end : ends) {
      EXPECT_LT((end.outward - (end.block == 0 ? -along : along)).norm(), 1e-12);
      EXPECT_NEAR(end.half_length, length / 2, 1e-12);
      EXPECT_NEAR(end.width, width, 1e-12);
    }
    EXPECT_EQ(ends[0].block + ends[1].block, 2);
  }
}

TEST(ChainEnd, NotWhereSomethingHoldsTheChain) {
  Model absorbing = chain_of(3);
  const Ring& ring = absorbing.blocks[2].shape.outer;
  absorbing.viscous_edges.push_back({2, ring[1], ring[2], 1, 1});
  EXPECT_EQ(blocks_at_ends(absorbing), std::vector{0});
  Model held = chain_of(3);
  held.supports = {{.block = 0, .point = held.blocks[0].shape.outer[0], .stiffness = 1, .history = {}}};
  EXPECT_EQ(blocks_at_ends(held), std::vector{2});
  held.supports[0].holds_y = false;
  EXPECT_EQ(blocks_at_ends(held), std::vector{2});
  held.supports[0].direction = Vec2(0.6, 0.8);
  EXPECT_EQ(blocks_at_ends(held), std::vector{2});
}

// On its end faces; elsewhere on its sides the chain is none (CubicCandidates).
TEST(ChainEnd, WhatHoldsItSidewaysDoesNotMatter) {
  Model rolling = chain_of(3);
  rolling.supports = {
      {.block = 0, .point = rolling.blocks[0].shape.outer[0], .holds_x = false, .stiffness = 1, .history = {}},
      {.block = 2, .point = rolling.blocks[2].shape.outer[1], .stiffness = 1, .history = {}, .direction = {0, 1}}};
  EXPECT_EQ(blocks_at_ends(rolling), (std::vector{0, 2}));
}

TEST(ChainEnd, NotWhereTheChainGoesOnAsAnotherOne) {
  Model mixed = chain_of(5);
  mixed.materials.push_back(mixed.materials[0]);
  mixed.blocks[4].material = mixed.blocks[3].material = 1;
  EXPECT_EQ(blocks_at_ends(mixed), (std::vector{0, 4}));  // cubic, cubic, consistent, cubic
  Model consistent = chain_of(3);
  consistent.joints[0].law = InterfaceLaw::consistent;
  EXPECT_TRUE(blocks_at_ends(consistent).empty());
}

// The equation of chain_end.h for the share.
TEST(ChainEnd, ShareTakesTheThirdOrderAway) {
  const double s = cubic::end_share;
  EXPECT_NEAR((s - 2.0 / 3) * (s + std::sqrt(2) / 6), std::pow(s - 0.5, 2), 1e-15);
}

TEST(ChainEnd, ForceAndStiffnessFollowFromItsEnergy) {
  for (const Material& material : materials()) {
    const Model model = chain_of(2, material, 0.4);
    const Mat3 elasticity = elasticity_matrix(material);
    const Vec3 carried(0.7, -0.2, 0.4);
    for (const ChainEnd& end : ends_of(model)) {
      const auto stress = [&](const Vec6& q) -> Vec3 { return carried + elasticity * q.tail<3>(); };
      const auto energy = [&](const Vec6& q) { return end_energy(model, end, stress(q)); };
      const Vec6 q = (Vec6() << 1, -2, 0.3, 0.5, -0.8, 0.2).finished();
      EXPECT_LT(relative_difference(end_force(model, end, stress(q)), gradient<6>(energy, q, 1)), round_off);
      EXPECT_LT(relative_difference(end_stiffness(model, end), hessian<6>(energy, 1)), round_off);
    }
  }
}

// Blocks, interfaces and ends under one uniaxial stress are in balance with loads on the two faces, and only so do the
// loads' levers fit the ends' potential: at the middle of the face, at a corner and inside the half block.
TEST(ChainEnd, UniaxialStressIsInBalanceWithLoadsOnTheFaces) {
  for (const Material& material : materials()) {
    for (const double angle : angles) {
      const Model model = chain_of(3, material, angle);
      const ContactSet contacts = make_contacts(model);
      const Vec2 n(std::cos(angle), std::sin(angle));
      const Vec3 stress(n.x() * n.x(), n.y() * n.y(), n.x() * n.y());
      const Vec3 strain = elasticity_matrix(material).inverse() * stress;
      Eigen::VectorXd d = Eigen::VectorXd::Zero(18);
      for (int i = 0; i < 3; ++i) {
        const Vec2 r = model.blocks[static_cast<std::size_t>(i)].moments.centroid;
        d.segment<2>(6 * i) =
            Vec2(strain(0) * r.x() + strain(2) / 2 * r.y(), strain(2) / 2 * r.x() + strain(1) * r.y());
        d.segment<3>(6 * i + 3) = strain;
      }
      Eigen::VectorXd force = Eigen::VectorXd::Zero(18);
      for (std::size_t i = 0; i < 2; ++i) {
        const InterfaceElement& element = contacts.elements[i];
        const InterfaceState state = linear_state(element, Vec4::Zero(), d.segment<6>(6 * element.block_a),
                                                  d.segment<6>(6 * element.block_b), stress, stress);
        add_interface_force(element, state.force, state.gap, force);
      }
      for (int i = 0; i < 3; ++i) force.segment<3>(6 * i + 3) += stress_force(length * width, stress);
      for (const ChainEnd& end : ends_of(model)) {
        force.segment<6>(6 * end.block) += end_force(model, end, stress);
        const Vec2 offset = end.half_length * end.outward;
        const Vec2 pull = width * end.outward;
        force.segment<6>(6 * end.block) -= point_load(offset, pull) + end_load(end, offset, pull);
      }
      EXPECT_LT(force.cwiseAbs().maxCoeff(), round_off) << angle;
    }
  }
}

TEST(ChainEnd, LoadsElsewhereKeepTheirLever) {
  const ChainEnd end = ends_of(chain_of(2)).front();
  EXPECT_TRUE(end_load(end, -0.3 * end.outward, Vec2(2, 1)).isZero(0));
  EXPECT_TRUE(end_load(end, 0.3 * end.outward, Vec2(0, 1)).isZero(0));
  const Vec6 near = end_load(end, 0.3 * end.outward + Vec2(0, 0.2), 2 * end.outward);
  EXPECT_NEAR(near(3), -(1 - cubic::end_share) * 0.6, 1e-15);
  EXPECT_NEAR(near.cwiseAbs().sum(), std::abs(near(3)), 1e-15);
}

// Inertia of a whole chain, over the centroids' displacements and strains along it.
Eigen::MatrixXd axial_inertia(const Model& model, double period_error, double dt, bool corrected_ends) {
  const ContactSet contacts = make_contacts(model);
  const auto blocks = static_cast<int>(model.blocks.size());
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(6 * blocks, 6 * blocks);
  for (int i = 0; i < blocks; ++i) {
    const Block& block = model.blocks[static_cast<std::size_t>(i)];
    whole.block<6, 6>(6 * i, 6 * i) += mass_matrix({model.mass_of(i), mean_squares(block.moments), 1});
  }
  for (const Interface& interface : contacts.interfaces) {
    const InterfaceMatrices between = cubic_inertia(model, interface, period_error, dt);
    const int a = 6 * interface.block_a, b = 6 * interface.block_b;
    whole.block<6, 6>(a, a) += between.aa;
    whole.block<6, 6>(b, b) += between.bb;
    whole.block<6, 6>(b, a) += between.ba;
    whole.block<6, 6>(a, b) += between.ba.transpose();
  }
  for (const ChainEnd& end : ends_of(model))
    if (corrected_ends)
      whole.block<6, 6>(6 * end.block, 6 * end.block) +=
          end_inertia(model, end, contacts.interfaces[end.interface], period_error, dt);
  Eigen::MatrixXd axial(2 * blocks, 2 * blocks);
  for (int i = 0; i < 2 * blocks; ++i)
    for (int j = 0; j < 2 * blocks; ++j) axial(i, j) = whole(3 * i, 3 * j);
  return axial;
}

// M - epsilon dt^2 K of the half block, and no more than leaves all inertia positive at any dt.
TEST(ChainEnd, InertiaIsLoweredAsTheStiffnessAsks) {
  const Model model = chain_of(2);
  const ContactSet contacts = make_contacts(model);
  const double modulus = side_free_modulus(model.materials[0]);
  constexpr double error = 1.0 / 6, dt = 0.1;
  for (const ChainEnd& end : ends_of(model)) {
    const Interface& interface = contacts.interfaces[end.interface];
    const double stiffness = cubic::end_share * modulus * width * length / 2;
    EXPECT_NEAR(end_inertia(model, end, interface, error, dt)(3, 3), -error * dt * dt * stiffness, 1e-15);
    EXPECT_TRUE(end_inertia(model, end, interface, 0, dt).isZero(0));
    const double most = -cubic::most_jump_correction * length * length / modulus * model.materials[0].density;
    EXPECT_NEAR(end_inertia(model, end, interface, error, 1e3)(3, 3), most * stiffness, 1e-13);
  }
}

TEST(ChainEnd, InertiaStaysPositive) {
  for (const int blocks : {2, 3, 4, 9}) {
    const Model model = chain_of(blocks);
    for (const double dt : {0.1, 0.5, 1.0, 100.0}) {
      const Eigen::VectorXd share =
          dense_modes(axial_inertia(model, 0.25, dt, true), axial_inertia(model, 0, dt, false)).squares;
      EXPECT_GT(share.minCoeff(), 0.15) << blocks << " blocks, dt = " << dt;  // 0.158 at the least
    }
  }
}

}  // namespace
}  // namespace dda
