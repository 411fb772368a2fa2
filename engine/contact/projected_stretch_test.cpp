// A projected stretch that is measured where its blocks are: the same whichever way they lie together.
#include "engine/contact/projected_stretch.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "engine/contact/contact_geometry.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/make_element.h"
#include "engine/contact/moving_contacts.h"
#include "engine/contact/projected_law.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

JointMaterial dry_joint() {
  JointMaterial joint;
  joint.law = InterfaceLaw::projected;
  joint.friction_angle = std::atan(0.5);
  return joint;
}

// Two bricks on each other, under pressure as drawn.
Model two_bricks(const Vec3& in_situ, const JointMaterial& joint = dry_joint()) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  model.blocks.resize(2);
  model.blocks[0].shape.outer = box_ring(0, 0, 2, 1);
  model.blocks[1].shape.outer = box_ring(0.4, 1, 2.4, 1.6);
  for (Block& block : model.blocks) block.initial_stress = in_situ;
  finish_model(model);
  return model;
}

// Turns both blocks by `angle` about the origin and moves them; the upper one has gone by `apart` before that.
State moved(const Model& model, double angle, const Vec2& apart) {
  State state = initial_state(model);
  const Mat2 turn = rotation(angle);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 drawn = model.blocks[i].moments.centroid;
    const Vec2 now = turn * (drawn + (i == 1 ? apart : Vec2::Zero())) + Vec2(7, -3);
    state.displacement[i].head<2>() = now - drawn;
    state.displacement[i](2) = angle;
    state.deformation[i] = turn;
    state.stress[i] = rotate_stress(model.blocks[i].initial_stress, angle);
  }
  return state;
}

InterfaceState measured(const Model& model, const State& state, const std::array<double, 2>& slip = {0, 0}) {
  ContactSet contacts = make_contacts(model);
  contacts.states.at(0).slip = slip;
  update_geometry(model, state, state, contacts);
  return contacts.states.at(0);
}

TEST(ProjectedStretch, HasTheForcesOfTheDrawingWherePressedBlocksAreTurned) {
  const Model model = two_bricks({-2e6, -3e6, 0.4e6});
  const InterfaceState drawn = make_contacts(model).states.at(0);
  for (const double angle : {0.0, 0.3, 1.9, -2.7}) {
    const InterfaceState state = measured(model, moved(model, angle, Vec2::Zero()));
    EXPECT_LT((state.force - drawn.force).norm(), 1e-9 * drawn.force.norm()) << angle;
    EXPECT_LT((state.gap - drawn.gap).norm(), 1e-9 * drawn.gap.norm()) << angle;
  }
}

// With a compliance of the joint the springs are pressed as drawn too, beside what the stresses make of the gap.
TEST(ProjectedStretch, HasThemWithACompliantJoint) {
  JointMaterial joint = dry_joint();
  joint.normal_stiffness = 5e9;
  joint.shear_stiffness = 2e9;
  const Model model = two_bricks({-2e6, -3e6, 0.4e6}, joint);
  const InterfaceState drawn = make_contacts(model).states.at(0);
  const InterfaceState state = measured(model, moved(model, 1.1, Vec2::Zero()));
  EXPECT_LT((state.force - drawn.force).norm(), 1e-9 * drawn.force.norm());
}

TEST(ProjectedStretch, IsPressedBySoMuchMoreAndShearedByWhatHasNotSlipped) {
  const Model model = two_bricks({0, -3e6, 0});
  const ContactSet contacts = make_contacts(model);
  const Vec4& stiffness = contacts.elements.own().at(0).stiffness;
  const Vec2 apart(3e-6, -1e-6);  // b's tangent is counter-clockwise from the normal upwards: to the left
  const InterfaceState stuck = measured(model, moved(model, 0.7, apart));
  const InterfaceState slipped = measured(model, moved(model, 0.7, apart), {-2e-6, -2e-6});
  for (const Eigen::Index n : {0, 2}) {
    const double more = stuck.force(n) - contacts.states[0].force(n);
    EXPECT_NEAR(more, -1e-6 * stiffness(n), 1e-6 * 1e-6 * stiffness(n));
    EXPECT_NEAR(stuck.force(n + 1), -3e-6 * stiffness(n + 1), 1e-6 * 3e-6 * stiffness(n + 1));
    EXPECT_NEAR(slipped.force(n + 1), -1e-6 * stiffness(n + 1), 1e-6 * 3e-6 * stiffness(n + 1));
  }
}

// What goes while the joint is open is slip, and no shear when it closes.
TEST(ProjectedStretch, ClosesWithoutShearWhereverItWent) {
  const Model model = two_bricks(Vec3::Zero());
  ContactSet contacts = make_contacts(model);
  const State open = moved(model, 0.7, {4e-4, 1e-4});
  const State closed = moved(model, 0.7, {4e-4, -1e-6});
  for (const State& state : {open, closed}) update_geometry(model, state, state, contacts);
  const InterfaceState& state = contacts.states.at(0);
  EXPECT_EQ(state.status[0], ContactStatus::locked);
  EXPECT_LT(state.force(0), 0);
  EXPECT_NEAR(state.slip[0], -4e-4, 1e-12);
  EXPECT_NEAR(state.force(1) / contacts.elements[0].stiffness(1), 0, 1e-12);
}

TEST(ProjectedStretch, PartsWhenAnEndHasGoneAHundredthOfItsLength) {
  const Model model = two_bricks({0, -3e6, 0});
  const Interface interface = make_contacts(model).interfaces.at(0);
  ASSERT_NEAR(interface.length, 1.6, 1e-12);
  EXPECT_FALSE(has_parted(model, moved(model, 2.5, {0.015, 0}), interface));
  EXPECT_TRUE(has_parted(model, moved(model, 2.5, {0.017, 0}), interface));
  EXPECT_TRUE(has_parted(model, moved(model, 2.5, {0, 0.017}), interface));
}

// The upper block turned about a point of the joint, counter-clockwise.
State tilted(const Model& model, const Vec2& about, double angle) {
  State state = initial_state(model);
  const Vec2 arm = model.blocks[1].moments.centroid - about;
  state.displacement[1].head<2>() = rotation(angle) * arm - arm;
  state.displacement[1](2) = angle;
  state.deformation[1] = rotation(angle);
  return state;
}

TEST(ProjectedStretch, StaysWhereItHasTurnedAboutOneOfItsEnds) {
  const Model model = two_bricks({0, -3e6, 0});
  const Interface interface = make_contacts(model).interfaces.at(0);
  EXPECT_FALSE(has_parted(model, tilted(model, {0.4, 1}, 0.04), interface));
  EXPECT_TRUE(has_parted(model, tilted(model, {0.4, 1}, 0.06), interface));
  EXPECT_FALSE(has_parted(model, tilted(model, {2, 1}, -0.04), interface));
  EXPECT_TRUE(has_parted(model, tilted(model, {2, 1}, -0.06), interface));
}

// The face beside the corner that it turns over is above the other block's, and comes down on it.
TEST(ProjectedStretch, PartsSoonerWhereItsBlocksAreAboutToMeetElsewhere) {
  Model model = two_bricks({0, -3e6, 0});
  model.blocks[1].shape.outer = {{0.4, 1}, {2.4, 1}, {2.4, 1.6}, {0.1, 1.6}, {0.1, 1.006}};
  finish_model(model);
  const Interface interface = make_contacts(model).interfaces.at(0);
  ASSERT_NEAR(interface.length, 1.6, 1e-12);
  EXPECT_FALSE(has_parted(model, tilted(model, {0.4, 1}, 0.009), interface));
  EXPECT_TRUE(has_parted(model, tilted(model, {0.4, 1}, 0.011), interface));
  EXPECT_FALSE(has_parted(model, tilted(model, {2, 1}, -0.04), interface));
}

// The joint carries something else than its blocks' own tractions.
TEST(ProjectedStretch, LeavesForcesOnStrainsAndBringsNoEnergyWhenItParts) {
  const Model model = two_bricks({-2e6, -3e6, 0.4e6});
  ContactSet contacts = make_contacts(model);
  const State state = moved(model, 0.9, Vec2::Zero());
  update_geometry(model, state, state, contacts);
  const InterfaceElement& element = contacts.elements.own().at(0);
  const Vec4 force = 0.3 * contacts.states.at(0).force + Vec4(1e5, 2e5, -1e5, 0);
  const StressLetGo change = stress_let_go(model, state, element, force);
  InterfaceElement bare = element;  // whose gaps know of no stress
  bare.softness.setZero();
  set_geometry(model, acting_frame(model, state, contacts.interfaces.at(0), element.law), bare);
  const Mat3 d = elasticity_matrix(model.materials[0]);
  double before = 0;
  double after = 0;
  for (const std::size_t block : {std::size_t{0}, std::size_t{1}}) {
    const double area = model.blocks[block].moments.area;
    const Vec3& stress = state.stress[block];
    const Vec3 less = stress + (block == 0 ? change.of_a : change.of_b);
    const Mat46 by_stress = block == 0 ? element.rows_a - bare.rows_a : element.rows_b - bare.rows_b;
    const Vec3 with_joint =
        area * stress - outline_force(contacts, block, d, stress) + by_stress.rightCols<3>().transpose() * force;
    EXPECT_LT((area * less - with_joint).norm(), 1e-12 * with_joint.norm());
    before += area * stress.dot(d.inverse() * stress) / 2;
    after += area * less.dot(d.inverse() * less) / 2;
  }
  const Vec4 gap = force.cwiseQuotient(element.stiffness);
  EXPECT_LT(after, before - outline_energy(contacts, state.stress) + gap.dot(force) / 2);
}

TEST(ProjectedStretch, LeavesItsForceAndMomentToItsEnds) {
  const Model model = two_bricks({0, -3e6, 0});
  const InterfaceElement element = make_contacts(model).elements.own().at(0);
  const Vec4 inside(-3, 1, -2, 0.5);
  InterfaceState state;
  state.force = inside;
  const std::array<Vec2, 2> ends = pressing_ends(element, state);
  EXPECT_LT((ends[0] + ends[1] - inside.head<2>() - inside.tail<2>()).norm(), 1e-15);
  EXPECT_NEAR(ends[1](0) - ends[0](0), element.lever * (inside(2) - inside(0)), 1e-15);
  // A resultant at one end leaves nothing to the other, and none pulls.
  state.force << -10, 2, 9, 0;
  const std::array<Vec2, 2> beyond = pressing_ends(element, state);
  EXPECT_EQ(beyond[1], Vec2::Zero());
  EXPECT_LT((beyond[0] - Vec2(-1, 2)).norm(), 1e-15);
  // Nor is there at an end that gapes.
  state.force = inside;
  state.status[0] = ContactStatus::open;
  EXPECT_EQ(pressing_ends(element, state)[0], Vec2::Zero());
}

TEST(ProjectedStretch, IsKeptWherePressed) {
  const Model model = two_bricks({0, -3e6, 0});
  const Interface interface = make_contacts(model).interfaces.at(0);
  EXPECT_FALSE(has_parted(model, moved(model, 0.3, {0, -0.1}), interface));
  EXPECT_TRUE(touch_there_alone(model, interface));
}

// Beside an opening nearly all blocks have corners that point inwards, where they face it.
TEST(ProjectedStretch, IsKeptBesideAnOpeningThatIsCutOutOfABlock) {
  Model model = two_bricks({0, -3e6, 0});
  const Interface interface = make_contacts(model).interfaces.at(0);
  Ring& above = model.blocks[1].shape.outer;
  const double right = std::ranges::max(above, {}, [](const Vec2& corner) { return corner.x(); }).x();
  const double top = std::ranges::max(above, {}, [](const Vec2& corner) { return corner.y(); }).y();
  // An arc from the right end of the stretch to the top, bent into the block.
  above = {{interface.from.x(), 1}, {right, 1}, {right - 0.4, 1.1}, {right - 0.6, top}, {interface.from.x(), top}};
  EXPECT_TRUE(touch_there_alone(model, interface));
  above[0].y() -= 1e-15;  // corners at the ends have round-off, of which no direction follows
  EXPECT_TRUE(touch_there_alone(model, interface));
  // A staple that comes back to the line where the other block goes on along it, to stand on that leg some time.
  above = {{0.4, 1}, {1, 1}, {1, 1.2}, {1.5, 1.001}, {1.5, 1.6}, {0.4, 1.6}};
  Interface shorter = interface;
  (shorter.from.x() < shorter.to.x() ? shorter.to : shorter.from).x() = 1;
  shorter.length = (shorter.to - shorter.from).norm();
  EXPECT_FALSE(touch_there_alone(model, shorter));
}

// A stone in a corner of two others, under stress as drawn, that has gone out of it: both of its faces part at once.
// What it keeps of its stress must not depend on which is looked at first.
Vec3 stress_of_stone_that_parts(bool wall_before_floor) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_joint()};
  model.blocks.resize(3);
  model.blocks[wall_before_floor ? 1 : 0].shape.outer = box_ring(0, -1, 2, 0);
  model.blocks[wall_before_floor ? 0 : 1].shape.outer = box_ring(-1, -1, 0, 1);
  model.blocks[2].shape.outer = box_ring(0, 0, 1, 1);
  for (Block& block : model.blocks) block.initial_stress = {-2e6, -3e6, 0.4e6};
  finish_model(model);
  State state = initial_state(model);
  ContactSet contacts = make_contacts(model);
  MovingContacts moving(model, state, contacts);
  EXPECT_EQ(moving.stretches(), 3U) << "the floor and the wall have one, too";
  state.displacement[2].head<2>() = Vec2(0.03, 0.03);
  state.stress[2] *= 1.5;  // the joints carry what they did
  moving.let_part(model, state, contacts);
  EXPECT_EQ(moving.stretches(), 1U);
  return state.stress[2];
}

TEST(ProjectedStretch, ThoseThatPartAtOnceLetGoOfStressInAnyOrder) {
  const Vec3 floor_first = stress_of_stone_that_parts(false), wall_first = stress_of_stone_that_parts(true);
  EXPECT_LT((floor_first - wall_first).norm(), 1e-12 * floor_first.norm());
}

}  // namespace
}  // namespace dda
