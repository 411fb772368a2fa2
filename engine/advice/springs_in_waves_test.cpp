#include "engine/advice/springs_in_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/advice/advise.h"
#include "engine/advice/lattice_test_support.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

Model dry_squares(InterfaceLaw law, Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.joints.emplace_back().law = law;
  model.joints[0].friction_angle = std::atan(0.7);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      model.blocks.emplace_back().shape.outer = box_ring(column, row, column + 1, row + 1);
  model.stages = {steps(generalized_alpha_integrator(0.8), 1e-4)};
  model.stages[0].kinematics = kinematics;
  return model;
}

Advice advice_on(Model model) {
  AdviceQuestion question;
  question.limits = false;
  question.frequency = continuum_speed(model.materials[0], WaveKind::p) / 20;
  finish_model(model);
  return advise(Simulation(std::move(model)), question);
}

double worst_by_interfaces(const Advice& advice) {
  double worst = 0;
  for (const WaveAdvice& wave : advice.stages.at(0).waves)
    worst = std::max(worst, std::abs(wave.steady.value().speed.interfaces));
  return worst;
}

TEST(SpringsInWaves, NamesTheLawThatCarriesThemBetter) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    const Advice advice = advice_on(dry_squares(law, Kinematics::finite));
    EXPECT_GT(worst_by_interfaces(advice), 0.1);
    EXPECT_NE(advice.springs.find("projected"), std::string::npos) << advice.springs;
  }
}

TEST(SpringsInWaves, HasNothingToSayOfWhatIsNoSpring) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    const Advice advice = advice_on(dry_squares(InterfaceLaw::projected, kinematics));
    EXPECT_LT(worst_by_interfaces(advice), 1e-6);
    EXPECT_EQ(advice.springs, "");
  }
}

TEST(SpringsInWaves, NamesTheLawToIntegratorsThatDampNothing) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model conserving = dry_squares(InterfaceLaw::classical, kinematics);
    conserving.stages[0].integrator = trapezoidal_integrator();
    EXPECT_NE(advice_on(conserving).springs.find("projected"), std::string::npos);
  }
}

// A stiffness that is given is the joint's own, and of damped contacts nothing is foretold.
TEST(SpringsInWaves, DoesNotNameItWhereItIsNotMeantOrNotToBeHad) {
  Model stiffness = dry_squares(InterfaceLaw::classical, Kinematics::finite);
  stiffness.joints[0].normal_stiffness = 1e11;
  stiffness.joints[0].shear_stiffness = 4e10;
  EXPECT_EQ(advice_on(stiffness).springs, "");
  Model damped = dry_squares(InterfaceLaw::classical, Kinematics::finite);
  damped.joints[0].contact_damping = 0.1;
  EXPECT_EQ(advice_on(damped).springs, "");
}

}  // namespace
}  // namespace dda
