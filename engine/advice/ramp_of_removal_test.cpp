#include "engine/advice/ramp_of_removal.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/contact/make_contacts.h"
#include "engine/model/settings.h"

namespace dda {
namespace {

double ratio_of(double poisson) { return (1 - poisson) / (1 - 2 * poisson); }

// Published for a sudden removal, to half of their last digit, and 3e-4 of the inversion.
TEST(WallOvershoot, OfASuddenRemovalIsThePublishedOne) {
  EXPECT_NEAR(wall_overshoot(ratio_of(0.2), 0), 0.182, 1e-3);
  EXPECT_NEAR(wall_overshoot(ratio_of(0.25), 0), 0.191, 1e-3);
  EXPECT_NEAR(wall_overshoot(ratio_of(0.3), 0), 0.204, 1e-3);
}

TEST(WallOvershoot, FallsWithTheLengthOfTheRamp) {
  double before = wall_overshoot(ratio_of(0.25), 0);
  for (double ramp = 0.5; ramp < 300; ramp *= 1.7) {
    const double now = wall_overshoot(ratio_of(0.25), ramp);
    EXPECT_LT(now, before) << ramp;
    before = now;
  }
  EXPECT_LT(before, 5e-3);
}

TEST(LeastRamp, LeavesWhatIsWanted) {
  for (const double poisson : {0.05, 0.25, 0.4})
    for (const double wanted : {0.1, 0.05, 0.01}) {
      const double ramp = least_ramp(ratio_of(poisson), wanted);
      EXPECT_LE(wall_overshoot(ratio_of(poisson), ramp), wanted);
      EXPECT_GT(wall_overshoot(ratio_of(poisson), 0.97 * ramp), wanted);
    }
  EXPECT_EQ(least_ramp(ratio_of(0.25), 0.3), 0);
}

// A pressure that fades over ages is one at rest at any time: what is left of the overshoot goes with 1/T.
TEST(WallOvershoot, OfTheLongestRampsIsNothingAndFoundAtOnce) {
  EXPECT_LT(wall_overshoot(ratio_of(0.25), 1e6), 1e-5);
  EXPECT_LT(wall_overshoot(ratio_of(0.25), 1e12), 1e-8);
}

// Nine squares, of which the middle one goes.
Model rock_around() {
  Model model;
  Material rock;
  rock.density = 2500;
  rock.young = 4e10;
  rock.poisson = 0.25;
  rock.plane = PlaneState::strain;
  model.materials = {rock};
  model.joints.emplace_back().bonded = true;
  for (int i = 0; i < 9; ++i) {
    Block& block = model.blocks.emplace_back();
    const double x = i % 3, y = i / 3;
    block.shape.outer = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  }
  model.stages.resize(2);
  for (Stage& stage : model.stages) stage.dt = stage.duration = 1e-3;
  model.stages[1].removal.blocks = {4};
  finish_model(model);
  return model;
}

TEST(RampOfRemoval, SaysWhatARoundOpeningOfThatAreaDoes) {
  Model model = rock_around();
  const ContactSet contacts = make_contacts(model);
  // a/c_P = 0.564 m over 4382 m/s = 0.129 ms; 16.4 and 91 of them leave 5 and 1 %.
  EXPECT_EQ(ramp_of_removal(model, contacts, 1),
            "a round opening of that area in rock without joints overshoots by 19 %; \"over\" 0.0021 s leaves 5 %, "
            "0.012 s 1 %");
  EXPECT_EQ(ramp_of_removal(model, contacts, 0), "");
  model.stages[1].rock.materials = model.materials;
  model.stages[1].rock.materials[0].young /= 100;  // waves of a tenth of the speed
  EXPECT_EQ(ramp_of_removal(model, contacts, 1),
            "a round opening of that area in rock without joints overshoots by 19 %; \"over\" 0.021 s leaves 5 %, "
            "0.12 s 1 %");
  model.stages[1].integrator = static_integrator();
  EXPECT_EQ(ramp_of_removal(model, contacts, 1), "");
}

}  // namespace
}  // namespace dda
