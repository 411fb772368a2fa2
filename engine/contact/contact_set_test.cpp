#include "engine/contact/contact_set.h"
#include "engine/contact/contact_geometry.h"
#include "engine/contact/in_situ_force.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/make_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/contact_models.h"

namespace dda {
namespace {

constexpr double round_off = 1e-13;  // of coordinates of order ten

// Two blocks side by side, drawn at a slant and moved together by x -> shift + deformation * x.
struct MovedPair {
  MovedPair(const Mat2& deformation, const Vec2& shift)
      : model(model_of({{{{0, 0}, {2, 0}, {1.5, 1}, {0, 1}}, {}}, {{{2, 0}, {3, 0}, {3, 2}, {1, 2}}, {}}})),
        state(initial_state(model)) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2& centroid = model.blocks[i].moments.centroid;
      state.deformation[i] = deformation;
      state.displacement[i].head<2>() = shift + deformation * centroid - centroid;
    }
  }
  Model model;
  State state;
};

TEST(CurrentFrame, FollowsTheBlocks) {
  const Mat2 stretch = (Mat2() << 1.2, 0.3, 0.3, 0.8).finished();
  for (const double angle : {0.0, 0.6, -2.0}) {
    const Mat2 deformation = rotation(angle) * stretch;
    const Vec2 shift(3, -1);
    const MovedPair moved(deformation, shift);
    const Interface interface = find_interfaces(moved.model).at(0);
    const InterfaceFrame frame = current_frame(moved.model, moved.state, interface);
    const Vec2 from = local_place(moved.model, shift + deformation * interface.from);
    const Vec2 to = local_place(moved.model, shift + deformation * interface.to);
    EXPECT_LT((frame.from_a - from).norm() + (frame.from_b - from).norm(), round_off);
    EXPECT_LT((frame.to_a - to).norm() + (frame.to_b - to).norm(), round_off);
    const Vec2 along = (to - from).normalized();
    EXPECT_LT((frame.normal - Vec2(along.y(), -along.x())).norm(), round_off);  // block a on the left
    EXPECT_LT((frame.centroid_b - local_centroid(moved.model, moved.state, 1)).norm(), round_off);
  }
}

// Pressed by 10, sheared by 2 (Pa) on a joint of 3 m between blocks of different stress.
TEST(InSituForce, IsWhatTheMeanStressMakesAtEitherEndAsFarAsAJointCarriesIt) {
  Model model = model_of({{box_ring(0, 0, 3, 1), {}}, {box_ring(0, 1, 3, 2), {}}});
  model.blocks[0].initial_stress = {-100, -12, 1};
  model.blocks[1].initial_stress = {100, -8, 3};
  const auto force_with = [&](double friction, bool bonded) {
    model.joints[0].bonded = bonded;
    model.joints[0].friction_angle = std::atan(friction);
    return in_situ_force(model, find_interfaces(model).at(0));
  };
  // The normal points up, the tangent to the left: what is above pulls the lower block to the right.
  EXPECT_LT((force_with(0.5, false) - Vec4(-15, -3, -15, -3)).norm(), round_off);
  EXPECT_LT((force_with(0.1, false) - Vec4(-15, -1.5, -15, -1.5)).norm(), round_off);
  for (Block& block : model.blocks) block.initial_stress = -block.initial_stress;
  EXPECT_LT((force_with(0, true) - Vec4(15, 3, 15, 3)).norm(), round_off);
  EXPECT_TRUE(force_with(0.5, false).isZero(0)) << "a dry joint does not pull";
}

TEST(CurrentFrame, NormalIsBetweenThoseOfTheTwoEdges) {
  MovedPair moved(Mat2::Identity(), Vec2::Zero());
  moved.state.deformation[0] = rotation(0.02);
  moved.state.deformation[1] = rotation(0.06);
  const Interface interface = find_interfaces(moved.model).at(0);
  const InterfaceFrame frame = current_frame(moved.model, moved.state, interface);
  EXPECT_LT((frame.normal - rotation(0.04) * interface.normal).norm(), round_off);
}

TEST(UpdateGeometry, ElementsTurnWithTheBlocks) {
  const double angle = 0.7;
  const MovedPair moved(rotation(angle), Vec2(1, 2));
  ContactSet contacts = make_contacts(moved.model);
  update_geometry(moved.model, moved.state, moved.state, contacts);
  Model turned = moved.model;
  place(turned, angle, Vec2(1, 2));
  const ContactSet expected = make_contacts(turned);
  EXPECT_LT((contacts.elements[0].rows_a - expected.elements[0].rows_a).norm(), round_off);
  EXPECT_LT((contacts.elements[0].rows_b - expected.elements[0].rows_b).norm(), round_off);
  EXPECT_LT((contacts.elements[0].stress_rows_a - expected.elements[0].stress_rows_a).norm(), round_off);
}

TEST(MakeContacts, KnowsWhetherAnythingCanChange) {
  Model model = model_of({{box_ring(0, 0, 1, 1), {}}, {box_ring(1, 0, 2, 1), {}}});
  EXPECT_TRUE(make_contacts(model).can_change);
  model.joints[0].bonded = true;
  EXPECT_FALSE(make_contacts(model).can_change);
}

}  // namespace
}  // namespace dda
