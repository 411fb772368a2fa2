#include "engine/model/block_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dda {
namespace {

// Blocks of 1 m by 1 m, 1000 kg/m3 but for their width.
Model blocks_of(const std::vector<double>& widths) {
  Model model;
  model.materials.resize(1);
  model.materials[0].density = 1000;
  for (const double width : widths) model.blocks.emplace_back().moments.area = width;
  return model;
}

BlockPeaks thrown_at(double velocity) {
  BlockPeaks peaks;
  peaks.thrown = velocity;
  peaks.ejected_at = 1;
  return peaks;
}

TEST(Ejection, SortsBlocksByVelocity) {
  const Model model = blocks_of({1, 2, 3, 4, 5});
  std::vector<BlockPeaks> peaks = {thrown_at(0.4), thrown_at(2), thrown_at(7.9), thrown_at(9), thrown_at(8)};
  peaks[3].ejected_at = BlockPeaks{}.ejected_at;  // the fastest has only come from a wave
  for (BlockPeaks& block : peaks) block.kinetic = 10;
  const Ejection ejection = ejection_of(model, peaks);
  EXPECT_EQ(ejection.all.blocks, 4U);
  EXPECT_EQ(ejection.all.mass, 11e3);
  EXPECT_DOUBLE_EQ(ejection.all.kinetic, 500 * (1 * 0.16 + 2 * 4 + 3 * 7.9 * 7.9 + 5 * 64));
  EXPECT_DOUBLE_EQ(ejection.mean_velocity, std::sqrt(2 * ejection.all.kinetic / 11e3));
  EXPECT_EQ(ejection.all.from, 0.4);
  EXPECT_EQ(ejection.all.to, 8);
  EXPECT_EQ(ejection.kinetic_at_end, 40);
  ASSERT_EQ(ejection.classes.size(), 8U);  // of 1 m/s: a tenth of 8, rounded up; the last holds its upper limit
  std::vector<std::size_t> counts;
  double mass = 0, kinetic = 0;
  for (const ThrownBlocks& each : ejection.classes) {
    EXPECT_DOUBLE_EQ(each.to - each.from, 1);
    counts.push_back(each.blocks);
    mass += each.mass;
    kinetic += each.kinetic;
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 0, 1, 0, 0, 0, 0, 2}));
  EXPECT_EQ(mass, ejection.all.mass);
  EXPECT_DOUBLE_EQ(kinetic, ejection.all.kinetic);
}

TEST(Ejection, OfNothingIsNothing) {
  const Model model = blocks_of({1, 2});
  const std::vector<BlockPeaks> still(2);
  EXPECT_EQ(ejection_of(model, still).all.blocks, 0U);
  EXPECT_EQ(ejection_of(model, still).all.to, 0);
  EXPECT_TRUE(ejection_of(model, still).classes.empty());
}

BlockPeaks block_at(double x, double speed) {
  BlockPeaks peaks;
  peaks.place = {x, 0};
  peaks.speed = speed;
  return peaks;
}

// Speeds made by the law itself; charge, source and the range of distances are those of the request.
TEST(ScaledDistance, GivesBackTheLawOfARecord) {
  constexpr double k = 0.7, exponent = 1.6;
  AttenuationRequest asked{{5, 0}, 12.5, 2, 60};
  std::vector<BlockPeaks> peaks;
  for (const double distance : {2.0, 3.5, 7.0, 20.0, 60.0})
    peaks.push_back(block_at(5 + distance, k * std::pow(distance / std::sqrt(12.5), -exponent)));
  peaks.push_back(block_at(6, 1e3));    // too near
  peaks.push_back(block_at(66, 1e-9));  // too far
  peaks.push_back(block_at(10, 0));     // has not moved
  peaks.push_back(thrown_at(30));       // ejected
  peaks.push_back(block_at(12, 50));
  peaks.back().takes_part = false;
  const auto law = attenuation_of(asked, peaks);
  ASSERT_TRUE(law);
  EXPECT_EQ(law->points, 5U);
  EXPECT_NEAR(law->k, k, 1e-14);
  EXPECT_NEAR(law->exponent, exponent, 1e-14);
  EXPECT_NEAR(law->correlation, -1, 1e-14);
}

// By hand: x = 0, 1, 2 and y = 0, -2, -1 in logarithms. Mean 1 and -1; xx 2, xy -1, yy 2.
TEST(ScaledDistance, IsTheLeastSquaresLineOfScatteredSpeeds) {
  const double e = std::exp(1.0);
  const std::vector<SpeedAtDistance> points = {{1, 1}, {e, 1 / (e * e)}, {e * e, 1 / e}};
  const auto law = fit_scaled_distance(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 0.5, 1e-15);
  EXPECT_NEAR(law->k, std::exp(-0.5), 1e-15);
  EXPECT_NEAR(law->correlation, -0.5, 1e-15);
}

TEST(ScaledDistance, NeedsTwoDistances) {
  EXPECT_FALSE(fit_scaled_distance({}));
  const std::vector<SpeedAtDistance> at_one_distance = {{3, 1}, {3, 2}, {3, 5}};
  EXPECT_FALSE(fit_scaled_distance(at_one_distance));
}

}  // namespace
}  // namespace dda
