// The linear pieces of what ends answer, as Newton's method with friction takes them.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/contact_pieces.h"
#include "engine/contact/open_close.h"
#include "engine/contact/open_close_models.h"

namespace dda {
namespace {

const EndStrength dry{0, 0, 0.5};

InterfaceElement projected_element() {
  InterfaceElement element = classical_element();
  element.law = InterfaceLaw::projected;
  element.lever = 0.4;
  return element;
}

// A dry end at these gaps (normal and shear springs 100 and 40 N/m), the other end pressed.
InterfaceTrial trial_at(double normal_gap, double shear_gap, const EndStrength& strength = dry) {
  InterfaceTrial trial = start_trial(classical_element(), strength, start_with(true));
  trial.broken = {true, true};
  trial.gap << normal_gap, shear_gap, -1, 0;
  respond_with_friction(classical_element(), strength, trial);
  return trial;
}

ContactPiece piece_at(double normal_gap, double shear_gap) { return pieces_of(trial_at(normal_gap, shear_gap))[0]; }

TEST(ContactPieces, AreReadOffTheAnswer) {
  EXPECT_EQ(piece_at(0.01, 0.3), ContactPiece::open);
  EXPECT_EQ(piece_at(-0.04, 0.049), ContactPiece::stuck);  // 1.96 N of 2 N
  EXPECT_EQ(piece_at(-0.04, 0.051), ContactPiece::slides_forth);
  EXPECT_EQ(piece_at(-0.04, -0.051), ContactPiece::slides_back);
}

TEST(ContactPieces, OfAWholeEndIsStuck) {
  InterfaceTrial trial = trial_at(0.01, 0.3);
  trial.broken[0] = false;
  EXPECT_EQ(pieces_of(trial)[0], ContactPiece::stuck);
}

// The capacity is that of the normal force at the same gap, as if update_capacity had followed.
TEST(ContactPieces, AnswerWithFrictionIsTheFixedPointOverCapacities) {
  for (const double normal_gap : {-0.1, -0.04, 0.0, 0.02}) {
    for (const double shear_gap : {-0.3, -0.01, 0.02, 0.2}) {
      InterfaceTrial trial = trial_at(normal_gap, shear_gap);
      const Vec4 force = trial.force;
      EXPECT_EQ(update_capacity(classical_element(), dry, trial), 0);
      EXPECT_EQ(trial.force, force);
    }
  }
}

TEST(ContactPieces, SlipDoesNotTurnWithoutSticking) {
  InterfaceTrial trial = trial_at(-0.04, -0.3);
  ContactPieces pieces{ContactPiece::slides_forth, ContactPiece::stuck};
  EXPECT_TRUE(keep_to_bordering_pieces(classical_element(), dry, {}, trial, pieces));
  EXPECT_EQ(pieces[0], ContactPiece::stuck);
  EXPECT_DOUBLE_EQ(trial.force(1), shear_spring * -0.3);  // what it would answer if it stuck
  EXPECT_DOUBLE_EQ(trial.active(1), 1);
  EXPECT_DOUBLE_EQ(trial.force(0), -4);
}

TEST(ContactPieces, OfTheSecondEndToo) {
  InterfaceTrial trial = trial_at(-0.04, 0);
  trial.gap(3) = 2;
  respond_with_friction(classical_element(), dry, trial);
  ContactPieces pieces{ContactPiece::stuck, ContactPiece::slides_back};
  EXPECT_TRUE(keep_to_bordering_pieces(classical_element(), dry, {}, trial, pieces));
  EXPECT_EQ(pieces[1], ContactPiece::stuck);
  EXPECT_DOUBLE_EQ(trial.force(3), shear_spring * 2);
}

TEST(ContactPieces, BorderingOnesAreLeftAlone) {
  const auto stays = [](ContactPiece before, double normal_gap, double shear_gap) {
    InterfaceTrial trial = trial_at(normal_gap, shear_gap);
    const Vec4 force = trial.force;
    ContactPieces pieces{before, ContactPiece::stuck};
    return !keep_to_bordering_pieces(classical_element(), dry, {.strict = true}, trial, pieces) &&
           trial.force == force && pieces == pieces_of(trial);
  };
  EXPECT_TRUE(stays(ContactPiece::stuck, -0.04, 0.3));         // starts to slide
  EXPECT_TRUE(stays(ContactPiece::slides_forth, -0.04, 0.3));  // slides on
  EXPECT_TRUE(stays(ContactPiece::slides_back, -0.04, 0.01));  // sticks
  EXPECT_TRUE(stays(ContactPiece::slides_back, 0.04, 0.01));   // opens
  EXPECT_TRUE(stays(ContactPiece::open, -0.04, -0.3));         // closes and slides
}

// Strictly, an end slides between open and stuck, on the line through what it answers at a gap of zero.
TEST(ContactPieces, OpenEndsSlideBeforeTheyStick) {
  for (const double side : {-1.0, 1.0}) {
    InterfaceTrial trial = trial_at(-0.04, side * 0.01);
    ContactPieces pieces{ContactPiece::open, ContactPiece::stuck};
    EXPECT_FALSE(keep_to_bordering_pieces(classical_element(), dry, {}, trial, pieces));
    pieces[0] = ContactPiece::open;
    EXPECT_TRUE(keep_to_bordering_pieces(classical_element(), dry, {.strict = true}, trial, pieces));
    EXPECT_EQ(pieces[0], side < 0 ? ContactPiece::slides_back : ContactPiece::slides_forth);
    EXPECT_DOUBLE_EQ(trial.force(0), -4);
    EXPECT_DOUBLE_EQ(trial.force(1), side * 2);
    EXPECT_EQ(trial.active(1), 0);
  }
}

TEST(ContactPieces, StuckEndsSlideBeforeTheyOpen) {
  InterfaceTrial trial = trial_at(0.02, 0.01);
  ContactPieces pieces{ContactPiece::stuck, ContactPiece::stuck};
  EXPECT_TRUE(keep_to_bordering_pieces(classical_element(), dry, {.strict = true}, trial, pieces));
  EXPECT_EQ(pieces[0], ContactPiece::slides_forth);
  EXPECT_DOUBLE_EQ(trial.force(0), 2);   // the line of the closed end goes on
  EXPECT_DOUBLE_EQ(trial.force(1), -1);  // and that of friction with it
  EXPECT_EQ(trial.active(0), 1);
}

// Where the old piece makes no more than a negligible difference the end stays on it, with its forces and slopes.
TEST(ContactPieces, AreKeptWhereTheDifferenceIsNegligible) {
  struct Way {
    ContactPiece before;
    double normal_gap, shear_gap, difference;
  };
  for (const Way& way :
       {Way{ContactPiece::open, -0.04, 0, 4}, Way{ContactPiece::stuck, 0.02, 0.01, 2},
        Way{ContactPiece::slides_forth, -0.04, 0.04, 0.4}, Way{ContactPiece::stuck, -0.04, 0.06, 0.4}}) {
    InterfaceTrial trial = trial_at(way.normal_gap, way.shear_gap);
    const InterfaceTrial answer = trial;
    ContactPieces pieces{way.before, ContactPiece::stuck};
    const PieceRule generous{.strict = true, .negligible_force = 1.001 * way.difference};
    EXPECT_FALSE(keep_to_bordering_pieces(classical_element(), dry, generous, trial, pieces));
    EXPECT_EQ(pieces[0], way.before);
    EXPECT_NEAR((trial.force - answer.force).cwiseAbs().maxCoeff(), way.difference, 1e-12);
    EXPECT_EQ(trial.active(0), way.before == ContactPiece::open ? 0 : 1);

    trial = answer;
    pieces[0] = way.before;
    const PieceRule narrow{.strict = true, .negligible_force = 0.999 * way.difference};
    static_cast<void>(keep_to_bordering_pieces(classical_element(), dry, narrow, trial, pieces));
    EXPECT_NE(pieces[0], way.before);
  }
}

// Residual friction and cohesion count.
TEST(ContactPieces, LieWhereTheStrengthPutsThem) {
  InterfaceTrial trial = trial_at(-0.04, 0.01, weakening);
  trial.residual[0] = true;
  ContactPieces pieces{ContactPiece::open, ContactPiece::stuck};
  EXPECT_TRUE(keep_to_bordering_pieces(classical_element(), weakening, {.strict = true}, trial, pieces));
  EXPECT_DOUBLE_EQ(trial.force(1), 0.6 + (0.5 - 0.2) * 4);
}

TEST(ShearByNormalGap, IsTheDerivativeOfTheAnswer) {
  constexpr double difference = 1e-6;
  for (const double shear_gap : {-0.3, 0.01, 0.3}) {
    for (const double normal_gap : {-0.05, 0.05}) {
      InterfaceTrial trial = trial_at(normal_gap, shear_gap);
      const Mat2 slopes = shear_by_normal_gap(classical_element(), dry, trial, pieces_of(trial));
      const double more = trial_at(normal_gap + difference, shear_gap).force(1);
      const double less = trial_at(normal_gap - difference, shear_gap).force(1);
      // The answer is piecewise linear: round-off of 2 N over the difference.
      EXPECT_NEAR(slopes(0, 0), (more - less) / (2 * difference), 1e-8) << normal_gap << " " << shear_gap;
      EXPECT_EQ(slopes(0, 1), 0);
    }
  }
}

// A stretch of the projected law at these normal gaps, both ends slid far; a tenth of it has been torn at its end.
InterfaceTrial projected_at(const Vec2& normal_gaps, const EndStrength& strength, bool residual) {
  InterfaceTrial trial = start_trial(projected_element(), strength, start_with(true));
  trial.broken = {true, true};
  trial.residual = {residual, residual};
  trial.torn = {0, 0.1};
  trial.gap << normal_gaps(0), 50, normal_gaps(1), -50;
  respond_with_friction(projected_element(), strength, trial);
  return trial;
}

// Closed, gaping by either end a little and nearly all the way, and open: what one end presses follows both gaps, and
// so does the length that has cohesion.
TEST(ShearByNormalGap, OfAGapingStretchIsTheDerivativeByBothGaps) {
  constexpr double difference = 1e-6;
  const auto expect_derivative = [&](const Vec2& gaps, const EndStrength& strength, bool residual) {
    const InterfaceTrial trial = projected_at(gaps, strength, residual);
    const Mat2 slopes = shear_by_normal_gap(projected_element(), strength, trial, pieces_of(trial));
    for (int column = 0; column < 2; ++column) {
      const Vec2 change = difference * Vec2::Unit(column);
      const auto beside = [&](double side) { return projected_at(gaps + side * change, strength, residual).force; };
      const Vec4 by = (beside(1) - beside(-1)) / (2 * difference);
      // The bed's second derivative over its stiffness is at most some tens per metre: (1e-6)^2 of that, and round-off
      // of 50 N over the difference.
      EXPECT_NEAR(slopes(0, column), by(1), 1e-7) << gaps.transpose() << " column " << column;
      EXPECT_NEAR(slopes(1, column), by(3), 1e-7) << gaps.transpose() << " column " << column;
    }
  };
  for (const Vec2& gaps : {Vec2(-0.1, -0.2), Vec2(-0.1, 0.02), Vec2(0.05, -0.1), Vec2(0.2, -0.1), Vec2(0.2, 0.1)}) {
    expect_derivative(gaps, dry, false);
    for (const bool residual : {false, true}) expect_derivative(gaps, weakening, residual);
  }
}

}  // namespace
}  // namespace dda
