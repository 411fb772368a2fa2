#include "engine/terms/lining_yield.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dda {
namespace {

// 0.2 m of concrete of 20 MPa, cracking at 2 MPa.
constexpr double thickness = 0.2, compressive = 20e6, tensile = 2e6;
LiningStrength concrete() { return {thickness, compressive * thickness, tensile * thickness}; }
Vec3 stiffness() { return {4e9, 1.4e7, 1.1e8}; }

// Stress blocks put together by hand.
TEST(LiningYield, MomentIsThatOfTwoStressBlocks) {
  for (const double pulled : {0.0, 0.02, 0.1, 0.18, 0.2}) {
    const double pressed = thickness - pulled;
    const double axial = tensile * pulled - compressive * pressed;
    // About the middle of the section.
    const double moment = tensile * pulled * pressed / 2 + compressive * pressed * pulled / 2;
    EXPECT_NEAR(plastic_moment(concrete(), axial), moment, 1e-9 * compressive * thickness * thickness);
  }
  const LiningStrength no_tension{thickness, compressive * thickness, 0};
  EXPECT_NEAR(plastic_moment(no_tension, -no_tension.crushing / 2), no_tension.crushing * thickness / 8, 1e-6);
}

TEST(LiningYield, CrushesTearsAndBendsNoFurther) {
  const LiningAnswer crushed = lining_answer(concrete(), stiffness(), {-1, 0, 0});
  EXPECT_NEAR(crushed.force(0), -concrete().crushing, 1e-9 * concrete().crushing);
  const LiningAnswer torn = lining_answer(concrete(), stiffness(), {1, 0, 0});
  EXPECT_NEAR(torn.force(0), concrete().tearing, 1e-9 * concrete().crushing);
  // Bent alone it grows longer, as it is weaker in tension; held at its length it is pressed.
  const LiningAnswer bent = lining_answer(concrete(), stiffness(), {0, 1, 0});
  EXPECT_NEAR(bent.force(1), plastic_moment(concrete(), bent.force(0)), 1e-9 * bent.force(1));
  EXPECT_LT(bent.force(0), 0);
  EXPECT_NEAR(lining_answer(concrete(), stiffness(), {0, -1, 0}).force(1), -bent.force(1), 1e-9 * bent.force(1));
}

Vec3 random_gap(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Vec3 unit(4e6 / stiffness()(0), 2e5 / stiffness()(1), 4e5 / stiffness()(2));
  return 2 * unit.cwiseProduct(Vec3(normal(random), normal(random), normal(random)));
}

double excess(const Vec3& force) {
  return std::abs(force(1)) + std::abs(force(2)) / 2 - plastic_moment(concrete(), force(0));
}

// What comes out lies in the set, on its edge where it yields, and is nearer to the trial in the energy than any other
// point of the set: the inequality of the projection on a convex set, which is also that of the plastic work.
TEST(LiningYield, AnswerIsTheNearestPointOfTheSet) {
  std::mt19937 random(7);
  int yielding = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 gap = random_gap(random);
    const LiningAnswer answer = lining_answer(concrete(), stiffness(), gap);
    const double scale = concrete().crushing * thickness;
    EXPECT_LE(excess(answer.force), 1e-12 * scale);
    if (!answer.yields) {
      EXPECT_EQ(answer.force, stiffness().cwiseProduct(gap));
      continue;
    }
    ++yielding;
    EXPECT_NEAR(excess(answer.force), 0, 1e-12 * scale);
    const Vec3 plastic = gap - answer.force.cwiseQuotient(stiffness());
    for (int j = 0; j < 20; ++j) {
      const Vec3 other = lining_answer(concrete(), stiffness(), random_gap(random)).force;
      EXPECT_GE(plastic.dot(answer.force - other), -1e-9 * scale * gap.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_GT(yielding, 500);
}

TEST(LiningYield, UtilisationLeadsToTheEdge) {
  std::mt19937 random(3);
  for (const double tearing : {0.0, tensile * thickness}) {
    const LiningStrength strength{thickness, compressive * thickness, tearing};
    for (int i = 0; i < 500; ++i) {
      const Vec3 force = lining_answer(strength, stiffness(), random_gap(random)).force;
      const double used = utilisation(strength, force);
      EXPECT_GE(used, 0);
      EXPECT_LE(used, 1 + 1e-9);
      if (used < 1e-3) continue;
      const Vec3 edge = force / used;
      const double moment = std::abs(edge(1)) + std::abs(edge(2)) / 2;
      EXPECT_NEAR(moment, plastic_moment(strength, edge(0)), 1e-6 * strength.crushing * thickness);
    }
    EXPECT_EQ(utilisation(strength, Vec3::Zero()), 0);
    EXPECT_NEAR(utilisation(strength, {-0.25 * strength.crushing, 0, 0}), 0.25, 1e-12);
  }
}

TEST(LiningYield, TangentIsTheDerivative) {
  std::mt19937 random(11);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 gap = random_gap(random);
    const LiningAnswer answer = lining_answer(concrete(), stiffness(), gap);
    EXPECT_LT((answer.tangent - answer.tangent.transpose()).norm(), 1e-12 * stiffness()(0));
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double step = 1e-6 * std::abs(gap(k));
      Vec3 more = gap;
      Vec3 less = gap;
      more(k) += step;
      less(k) -= step;
      const LiningAnswer after = lining_answer(concrete(), stiffness(), more);
      const LiningAnswer before = lining_answer(concrete(), stiffness(), less);
      const bool same_piece = ((after.force.array() == 0) == (before.force.array() == 0)).all() &&
                              after.yields == before.yields && after.yields == answer.yields;
      if (!same_piece) continue;
      const Vec3 slope = (after.force - before.force) / (2 * step);
      // Scaled by what an elastic element has in the same rows.
      const Vec3 scale = (stiffness() * stiffness()(k)).cwiseSqrt();
      EXPECT_LT((slope - answer.tangent.col(k)).cwiseQuotient(scale).cwiseAbs().maxCoeff(), 1e-5);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace dda
