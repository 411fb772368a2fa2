// Ends that ride up as they slide, answered at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "engine/contact/contact_pieces.h"
#include "engine/contact/open_close.h"
#include "engine/contact/open_close_models.h"
#include "engine/contact/rising_end.h"

namespace dda {
namespace {

struct Kind {
  const char* name;
  bool is_vertex, is_damped;
  bool conserves = false;
};

class RisingEnds : public testing::TestWithParam<Kind> {
 protected:
  double number(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(generator_); }

  InterfaceElement element() const {
    InterfaceElement element = classical_element();
    element.length = GetParam().is_vertex ? 0 : 2;
    if (GetParam().is_damped) element.dashpot << normal_dashpot, shear_dashpot, normal_dashpot, shear_dashpot;
    if (!GetParam().is_vertex) return element;
    element.stiffness.tail<2>().setZero();
    element.dashpot.tail<2>().setZero();
    return element;
  }

  // Spring and dashpot of a normal row that ends the step at `gap`, without a pull.
  double normal_force(double gap, double start) const {
    if (gap >= 0) return 0;
    const double dashpot = element().dashpot(0) * rate;
    return std::min(0.0, normal_spring * gap + dashpot * (gap - std::min(0.0, start)));
  }

  // Shear of an end that has not slipped in the step.
  double stuck_force(const InterfaceTrial& trial, int end) const {
    const double gap = trial.gap(2 * end + 1);
    return shear_spring * gap + element().dashpot(1) * rate * (gap - trial.start(2 * end + 1));
  }

  // A third are on their way back, a third beyond the slip where they rise no further; steps are up to a few of these.
  InterfaceTrial random_trial() {
    InterfaceState start = start_with(true);
    start.broken = {true, true};
    start.gap(0) = start.gap(2) = -0.04;
    start.gap(1) = start.gap(3) = GetParam().is_damped ? number(-0.02, 0.02) : 0;
    start.slip = {number(-0.06, 0.06), number(-0.06, 0.06)};
    if (GetParam().conserves) {
      start.gap(1) = number(-0.02, 0.02);
      start.gap(3) = number(-0.02, 0.02);
      start.force = element().stiffness.cwiseProduct(start.gap);
    }
    start_ = start;
    InterfaceTrial trial =
        start_trial(element(), strength_, start, {.conserves_energy = GetParam().conserves, .dashpot_rate = rate});
    for (const int end : {0, 1}) trial.gap.segment<2>(2 * end) << number(-0.1, 0.02), number(-0.15, 0.15);
    respond_with_friction(element(), strength_, trial);
    return trial;
  }

  InterfaceState start_;  // of the last trial

  static constexpr double rate = 20, normal_dashpot = 2, shear_dashpot = 3;  // dashpots of 0.4 and 1.5 springs
  const EndStrength strength_{.friction = 0.5, .dilation = 0.25, .dilation_slip = 0.04};
  std::mt19937 generator_{1};
};
constexpr Kind vertex{"vertex", true, false}, stretch{"stretch", false, false};
constexpr Kind damped_vertex{"dampedVertex", true, true}, damped_stretch{"dampedStretch", false, true};
constexpr Kind conserving_vertex{"conservingVertex", true, false, true};
constexpr Kind conserving_stretch{"conservingStretch", false, false, true};
constexpr Kind damped_conserving_vertex{"dampedConservingVertex", true, true, true};

std::string name_of(const testing::TestParamInfo<Kind>& kind) { return kind.param.name; }

INSTANTIATE_TEST_SUITE_P(Dilation, RisingEnds,
                         testing::Values(vertex, stretch, damped_vertex, damped_stretch, conserving_vertex,
                                         conserving_stretch, damped_conserving_vertex),
                         name_of);

class RisingEndsOfForces : public RisingEnds {};
INSTANTIATE_TEST_SUITE_P(Dilation, RisingEndsOfForces, testing::Values(vertex, stretch, damped_vertex, damped_stretch),
                         name_of);

class RisingEndsOfMeans : public RisingEnds {};
INSTANTIATE_TEST_SUITE_P(Dilation, RisingEndsOfMeans, testing::Values(conserving_vertex, conserving_stretch), name_of);

// Signorini's and Coulomb's laws with the rise that belongs to the slip, whatever the way there.
TEST_P(RisingEndsOfForces, ObeyEveryLawAtOnce) {
  int sliding_ends = 0;
  for (int i = 0; i < 5000; ++i) {
    const InterfaceTrial trial = random_trial();
    for (int end = 0; end < ends_of(element()); ++end) {
      const auto e = static_cast<std::size_t>(end);
      const double normal = trial.force(2 * end), shear = trial.force(2 * end + 1);
      ASSERT_LE(normal, 0);
      if (normal == 0) {  // open, even where it has ridden up on the whole way
        const double way = stuck_force(trial, end) / (shear_spring + element().dashpot(1) * rate);
        const double risen = strength_.lift(trial.slip[e] + way) - strength_.lift(trial.slip[e]);
        ASSERT_NEAR(normal_force(trial.gap(2 * end) - risen, trial.start(2 * end)), 0, 1e-12);
        const bool is_closed = trial.gap(2 * end) < risen;  // where a dashpot takes what the spring presses with
        ASSERT_EQ(shear, 0);
        ASSERT_NEAR(trial.dilation[e], is_closed ? risen : 0, round_off);
        continue;
      }
      const double slip = (stuck_force(trial, end) - shear) / (shear_spring + element().dashpot(1) * rate);
      const double risen = strength_.lift(trial.slip[e] + slip) - strength_.lift(trial.slip[e]);
      ASSERT_NEAR(trial.dilation[e], risen, round_off);
      ASSERT_NEAR(normal, normal_force(trial.gap(2 * end) - risen, trial.start(2 * end)), 100 * round_off);
      ASSERT_LE(std::abs(shear), -0.5 * normal + 100 * round_off);
      if (std::abs(slip) < round_off) continue;
      ASSERT_GT(slip * shear, 0);
      ASSERT_NEAR(std::abs(shear), -0.5 * normal, 100 * round_off);
      ++sliding_ends;
    }
  }
  EXPECT_GT(sliding_ends, 1000);
}

// The mean pressure does the work of the spring, the mean shear and what the spring keeps are at most its friction, the
// rise is that of the slip, opening or not, and all of it together takes energy. (Of springs alone: what dashpots take
// is no energy of springs.)
TEST_P(RisingEndsOfMeans, ObeyTheirLaws) {
  const auto stored = [](double spring, double gap) { return spring * gap * gap / 2; };
  int sliding_ends = 0, opening_ends = 0;
  for (int i = 0; i < 5000; ++i) {
    const InterfaceTrial trial = random_trial();
    const InterfaceState after = finish_trial(element(), start_, trial);
    for (int end = 0; end < ends_of(element()); ++end) {
      const auto e = static_cast<std::size_t>(end);
      const Vec2 begin = start_.gap.segment<2>(2 * end);
      const Vec2 mean = (trial.force + start_.force).segment<2>(2 * end) / 2;
      const double gap = trial.normal_gap(end);
      const double gained = stored(normal_spring, std::min(0.0, gap)) - stored(normal_spring, begin(0));
      ASSERT_NEAR(mean(0) * (gap - begin(0)), gained, round_off);
      ASSERT_LT(mean(0), 0);
      const double friction = -0.5 * mean(0), slip = after.slip[e] - start_.slip[e];
      ASSERT_NEAR(trial.dilation[e], strength_.lift(after.slip[e]) - strength_.lift(start_.slip[e]), round_off);
      ASSERT_EQ(after.dilation[e], trial.dilation[e]);
      ASSERT_LE(std::abs(mean(1)), friction + 100 * round_off);
      const bool is_open = after.status[e] == ContactStatus::open;
      if (is_open && trial.dilation[e] == 0) continue;  // its slip is not counted
      const double kept = shear_spring * (trial.gap(2 * end + 1) - slip);
      ASSERT_LE(std::abs(kept), friction + 100 * round_off);
      const double shear_gained =
          stored(shear_spring, is_open ? 0 : kept / shear_spring) - stored(shear_spring, begin(1));
      const double work = mean.dot(trial.gap.segment<2>(2 * end) - begin);
      ASSERT_LE(gained + shear_gained, work + round_off);
      if (std::abs(slip) < round_off) continue;
      ASSERT_GT(slip * kept, 0);
      ASSERT_NEAR(std::abs(kept), friction, 100 * round_off);
      ++(is_open ? opening_ends : sliding_ends);
    }
  }
  EXPECT_GT(sliding_ends, 1000);
  EXPECT_GT(opening_ends, 100);
}

// The outer fixed points have nothing left to do.
TEST_P(RisingEnds, AreTheFixedPointOverCapacitiesAndDilations) {
  for (int i = 0; i < 2000; ++i) {
    InterfaceTrial trial = random_trial();
    ASSERT_LT(update_dilation(element(), strength_, trial), 1e-12);
    ASSERT_LT(update_capacity(element(), strength_, trial), 1e-12);
  }
}

// What an end has ridden up by is that of its slip, whether it ends the step closed or open.
TEST_P(RisingEnds, HaveRiddenUpByWhatTheyHaveSlipped) {
  int opened = 0;
  for (int i = 0; i < 2000; ++i) {
    InterfaceTrial trial = random_trial();
    update_dilation(element(), strength_, trial);
    const InterfaceState after = finish_trial(element(), start_, trial);
    for (int end = 0; end < ends_of(element()); ++end) {
      const auto e = static_cast<std::size_t>(end);
      const double risen = strength_.lift(after.slip[e]) - strength_.lift(start_.slip[e]);
      ASSERT_NEAR(after.dilation[e] - start_.dilation[e], risen, 1e-12);
      if (after.status[e] == ContactStatus::open && risen != 0) ++opened;
    }
  }
  if (element().dashpot(0) > 0) {
    EXPECT_GT(opened, 10);
  }
}

// Rows in the matrix and what lies beyond them make up the slopes of the answer.
TEST_P(RisingEnds, SlopesAreThoseOfTheAnswer) {
  constexpr double step = 1e-7;
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const InterfaceTrial trial = random_trial();
    const ContactPieces pieces = pieces_of(trial);
    for (int end = 0; end < ends_of(element()); ++end) {
      const ContactPiece piece = pieces[static_cast<std::size_t>(end)];
      if (!slides(piece)) continue;
      const Mat2 beyond = slopes_beyond_rows(element(), strength_, trial, end, direction_of(piece));
      const auto moved = [&](int row, double by) {
        InterfaceTrial other = trial;
        other.gap(2 * end + row) += by;
        respond_with_friction(element(), strength_, other);
        return other;
      };
      for (int row : {0, 1}) {
        const InterfaceTrial after = moved(row, step), before = moved(row, -step);
        // Differences across a corner of the answer are no slopes.
        if (after.active != trial.active || before.active != trial.active) continue;
        Vec4 change = Vec4::Zero();
        change(2 * end + row) = step;
        const Vec2 in_matrix = force_change(element(), trial.active, trial.coupling, change).segment<2>(2 * end) / step;
        const Vec2 slope = (after.force - before.force).segment<2>(2 * end) / (2 * step);
        ASSERT_LT((in_matrix + beyond.col(row) - slope).norm(), 1e-6 * normal_spring);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

// Nobody knows how much of its motion was in contact, and with the rise the same gaps have a second answer.
TEST(RisingEnd, ThatWasOpenRidesUpFromTheNextStepOn) {
  const EndStrength strength{.friction = 0.5, .dilation = 0.25};
  InterfaceState state = start_with(true, open);
  state.gap(0) = 0.01;
  state.slip[0] = 0.02;
  state = step_to(strength, state, -0.04, 0.3);
  EXPECT_EQ(state.status[0], sliding);
  EXPECT_EQ(state.slip[0], 0.02);
  EXPECT_EQ(state.dilation[0], 0);
  const double kept = state.gap(1);
  state = step_to(strength, state, -0.04, kept + 0.1);
  EXPECT_GT(state.slip[0], 0.03);
  EXPECT_NEAR(state.dilation[0], 0.25 * (state.slip[0] - 0.02), 1e-12);
}

}  // namespace
}  // namespace dda
