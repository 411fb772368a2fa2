// Contacts that conserve energy, dashpots beside springs, and contacts that stick: the laws of one end.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/contact/open_close.h"

namespace dda {
namespace {

constexpr double spring = 100;
constexpr double round_off = 1e-13;

// One dry contact: normal and shear springs, and dashpots.
InterfaceElement contact_with(double dashpot) {
  InterfaceElement element;
  element.law = InterfaceLaw::classical;
  element.stiffness << spring, spring / 2, 0, 0;
  element.dashpot << dashpot, dashpot / 2, 0, 0;
  return element;
}

InterfaceState at_gap(double normal, double shear = 0) {
  InterfaceState state;
  state.broken = {true, true};
  state.gap << normal, shear, 0, 0;
  state.force << spring * std::min(0.0, normal), spring / 2 * shear, 0, 0;
  state.status = {normal < 0 ? ContactStatus::locked : ContactStatus::open, ContactStatus::open};
  return state;
}

InterfaceTrial trial_at(const InterfaceElement& element, const InterfaceState& start, const ContactRule& rule,
                        double gap) {
  InterfaceTrial trial = start_trial(element, {0, 0, 0.5}, start, rule);
  trial.gap(0) = gap;
  respond(element, trial);
  return trial;
}

double stored(double gap) { return spring * std::min(0.0, gap) * std::min(0.0, gap) / 2; }

struct Draw {
  std::mt19937 random{20};
  std::uniform_real_distribution<double> gap{-1, 1};
  double operator()() { return gap(random); }
};

TEST(ConservingContact, WorkOfTheMeanForceIsTheChangeOfTheSpringsEnergy) {
  Draw draw;
  const InterfaceElement element = contact_with(0);
  for (int i = 0; i < 1000; ++i) {
    const double from = draw();
    const double to = draw();
    const InterfaceState start = at_gap(from);
    const double mean = (trial_at(element, start, {.conserves_energy = true}, to).force(0) + start.force(0)) / 2;
    EXPECT_NEAR(mean * (to - from), stored(to) - stored(from), round_off * spring);
    EXPECT_LE(mean, round_off * spring) << "pulls";
  }
}

// What Newton's method and its line search rest on.
TEST(ConservingContact, ForceGrowsWithTheGapAndActiveIsItsSlope) {
  Draw draw;
  for (const bool conserves : {false, true}) {
    for (const double dashpot : {0.0, 3.0}) {
      const InterfaceElement element = contact_with(dashpot);
      const ContactRule rule{.conserves_energy = conserves, .dashpot_rate = 10};
      for (int i = 0; i < 1000; ++i) {
        const InterfaceState start = at_gap(draw());
        const double gap = draw();
        constexpr double step = 1e-6;
        const double below = trial_at(element, start, rule, gap - step).force(0);
        const double above = trial_at(element, start, rule, gap + step).force(0);
        EXPECT_GE(above, below - round_off * spring);
        const InterfaceTrial here = trial_at(element, start, rule, gap);
        const bool at_kink = std::abs((above - here.force(0)) - (here.force(0) - below)) > 1e-3 * spring * step;
        if (at_kink) continue;
        EXPECT_NEAR((above - below) / (2 * step), spring * here.active(0), 1e-4 * spring);
      }
    }
  }
}

TEST(DampedContact, DashpotTakesEnergyAndNeverPulls) {
  Draw draw;
  for (const bool conserves : {false, true}) {
    const InterfaceElement element = contact_with(7);
    const ContactRule rule{.conserves_energy = conserves, .dashpot_rate = 10};
    double taken = 0;
    for (int i = 0; i < 1000; ++i) {
      const double from = draw();
      const InterfaceState start = at_gap(from);
      const InterfaceTrial trial = trial_at(element, start, rule, draw());
      const double work = dashpot_force(element, trial)(0) * (trial.gap(0) - from);
      EXPECT_GE(work, -round_off * spring);
      taken += work;
      EXPECT_LE(trial.force(0) + (conserves ? start.force(0) : 0), round_off * spring) << "pulls";
    }
    EXPECT_GT(taken, 0);
  }
}

// While closed: force of the balance = k g + c (change of gap) * rate, in shear as well; the state keeps the springs'.
TEST(DampedContact, ActsOnTheRateOfTheGap) {
  const InterfaceElement element = contact_with(2);
  const InterfaceState start = at_gap(-0.5, 0.01);
  InterfaceTrial trial = start_trial(element, {0, 0, 0.5}, start, {.dashpot_rate = 10});
  trial.gap << -0.6, 0.02, 0, 0;
  respond(element, trial);
  EXPECT_NEAR(trial.force(0), spring * -0.6 + 2 * 10 * -0.1, round_off * spring);
  EXPECT_NEAR(trial.force(1), spring / 2 * 0.02 + 1 * 10 * 0.01, round_off * spring);
  const InterfaceState after = finish_trial(element, start, trial);
  EXPECT_NEAR(after.force(0), spring * -0.6, round_off * spring);
  EXPECT_NEAR(after.force(1), spring / 2 * 0.02, round_off * spring);
}

// A dashpot may bring an end to its friction though its spring alone is well below. What slides then lies in line with
// both, so it goes the way of the force, and spring and dashpot go on bearing that force together.
TEST(DampedContact, SlidesTheWayItIsPushed) {
  Draw draw;
  const InterfaceElement element = contact_with(7);
  int slid = 0;
  for (int i = 0; i < 1000; ++i) {
    const InterfaceState start = at_gap(-0.5, 0.2 * draw());
    InterfaceTrial trial = start_trial(element, {0, 0, 0.5}, start, {.dashpot_rate = 10});
    trial.gap << -0.5 + 0.1 * draw(), start.gap(1) + draw(), 0, 0;
    respond(element, trial);
    const InterfaceState after = finish_trial(element, start, trial);
    if (after.status[0] != ContactStatus::sliding) continue;
    ++slid;
    EXPECT_GE((after.slip[0] - start.slip[0]) * trial.force(1), -round_off * spring);
    EXPECT_NEAR(after.force(1) + dashpot_force(element, trial)(1), trial.force(1), round_off * spring);
    EXPECT_NEAR(dashpot_force(element, trial)(1), 3.5 * 10 * (after.gap(1) - start.gap(1)), round_off * spring);
  }
  EXPECT_GT(slid, 100);
}

// An end that rides up as it slides presses the harder, and with a soft shear spring and a dashpot beside it the force
// may grow faster with the gap than that of an end that sticks: it slides all the same.
TEST(DampedContact, SlidesWhereItRidesUp) {
  InterfaceElement element = contact_with(7);
  element.stiffness(1) = spring / 50;
  EndStrength strength{0, 0, 0.5};
  strength.dilation = 0.4;
  const InterfaceState start = at_gap(-0.5, 0);
  InterfaceTrial trial = start_trial(element, strength, start, {.dashpot_rate = 10});
  trial.gap << -0.5, 3, 0, 0;
  respond(element, trial);
  EXPECT_LT(trial.force(1), 3 * (spring / 50 + 3.5 * 10)) << "what it would bear without slip";
  const InterfaceState after = finish_trial(element, start, trial);
  EXPECT_EQ(after.status[0], ContactStatus::sliding);
  EXPECT_GT(after.slip[0], 0.1);
  EXPECT_LT(after.gap(1), 2.9);
}

TEST(StickingContact, CarriesAnyShearWhileClosedAndNoneWhenOpen) {
  const InterfaceElement element = contact_with(0);
  const ContactRule rule{.sticks = true, .touching = 1e-9};
  InterfaceTrial trial = start_trial(element, {0, 0, 0.5}, at_gap(0), rule);
  trial.gap << -1e-3, 1, 0, 0;
  respond(element, trial);
  EXPECT_DOUBLE_EQ(trial.force(1), spring / 2);
  trial = start_trial(element, {0, 0, 0.5}, at_gap(1e-3), rule);
  trial.gap << -1e-3, 1, 0, 0;
  respond(element, trial);
  EXPECT_EQ(trial.force(1), 0);
}

TEST(StickingContact, ReleaseLeavesWhatFrictionHolds) {
  const InterfaceElement element = contact_with(0);
  InterfaceState state = at_gap(-0.1, 0.5);
  EXPECT_TRUE(release_shear(element, {0, 0, 0.5}, state));
  EXPECT_DOUBLE_EQ(state.force(1), 5);
  EXPECT_DOUBLE_EQ(state.gap(1), 0.1);
  EXPECT_DOUBLE_EQ(state.slip[0], 0.4);
  EXPECT_FALSE(release_shear(element, {0, 0, 0.5}, state));
}

}  // namespace
}  // namespace dda
