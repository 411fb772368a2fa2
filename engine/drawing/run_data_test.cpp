// Run data of df, in both layouts. All numbers are our own; only their order is that of other programs' files.
#include "engine/drawing/run_data.h"

#include "engine/drawing/drawing_test_support.h"

namespace dda {
namespace {

const std::string material = "2.6 25.5 20000 0.25\n-1.0 -2.0 0.5\n0 0 0\n0.1 0.2 0.3\n";
const std::string short_file = "1\n200\n1\n2\n0.005\n0.01\n" + material + "35 0.1 0\n20 0 0.05\n";
const std::string long_file = "0\n200\n1\n2\n0.005\n0.01\n1e6\n0 2 3\n0 0 0\n1 0.1 0\n0 0 -5\n0.5 0 -6\n9 1 -7\n" +
                              material + "35 0.1 0\n20 0 0.05\n";

std::string with(const std::string& text, const std::string& old, const std::string& by) {
  std::string changed = text;
  return changed.replace(changed.find(old), old.size(), by);
}

TEST(ReadRunData, TheShortLayoutHasNoSpringsAndTables) {
  const RunData data = read_run_data(short_file, "a.df", 3);
  EXPECT_EQ(data.velocity_share, 1);
  EXPECT_EQ(data.steps, 200);
  EXPECT_EQ(data.displacement_ratio, 0.005);
  EXPECT_EQ(data.longest_step, 0.01);
  EXPECT_EQ(data.spring, 0);
  EXPECT_TRUE(data.points.empty());
  ASSERT_EQ(data.materials.size(), 1U);
  EXPECT_EQ(data.materials[0].unit_weight, 25.5);
  EXPECT_EQ(data.materials[0].stress, (std::array<double, 3>{-1, -2, 0.5}));
  EXPECT_EQ(data.materials[0].velocity, Vec2(0.1, 0.2));
  EXPECT_EQ(data.materials[0].spin, 0.3);
  ASSERT_EQ(data.joints.size(), 2U);
  EXPECT_EQ(data.joints[1].friction_deg, 20);
  EXPECT_EQ(data.joints[1].tension, 0.05);
}

TEST(ReadRunData, TheLongLayoutHasThem) {
  const RunData data = read_run_data(long_file, "a.df", 3);
  EXPECT_EQ(data.velocity_share, 0);
  EXPECT_EQ(data.spring, 1e6);
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_TRUE(data.points[0].rows.empty());
  EXPECT_EQ(data.points[1].rows[1], (std::array<double, 3>{1, 0.1, 0}));
  EXPECT_EQ(data.points[2].rows.size(), 3U);
  EXPECT_EQ(data.joints[0].cohesion, 0.1);
}

// Another number of points, or more or fewer numbers, and the file is of a layout that nobody knows.
TEST(ReadRunData, OtherNumbersOfNumbersAreRefused) {
  const std::string sentence = "numbers for 1 block and 2 joint materials";
  expect_refused([] { read_run_data(long_file, "a.df", 2); }, sentence);
  expect_refused([] { read_run_data(long_file, "a.df", 4); }, "a.df");
  expect_refused([] { read_run_data(long_file + "1.4\n", "a.df", 3); }, sentence);
  expect_refused(
      [] { read_run_data(short_file + "1.4\n", "a.df", 3); },
      "a.df is 26 numbers for 1 block and 2 joint "
      "materials, 3 points that are fixed or loaded, and their tables, expected 25, or 29 and three for each row");
  expect_refused([] { read_run_data(with(short_file, "1\n2\n", "2\n2\n"), "a.df", 0); }, "expected 38, or 39");
}

TEST(ReadRunData, WhatIsWrongIsSaidInOneSentence) {
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "a.df line 1 is the end of the file, before static or dynamic"},
      {with(short_file, "1\n200", "2\n200"), "a.df line 1 is 2 for static or dynamic, expected 0 for static, 1 for"},
      {with(short_file, "200", "0"), "a.df line 2 is 0 for the number of steps, expected a whole number from 1"},
      {with(short_file, "0.005", "1.5"), "a.df line 5 is 1.5 for the largest displacement of a step, expected a share"},
      {with(short_file, "2.6 25.5", "0 25.5"), "a.df line 7 is 0 for the density, expected more than 0"},
      {with(short_file, "0 0 0\n0.1", "0 0.2 0\n0.1"),
       "a.df line 9 is 0.2 behind the stresses of a block material, expected 0"},
      {with(short_file, "35 0.1", "95 0.1"), "a.df line 11 is 95 for a friction angle, expected below 90"},
      {with(short_file, "20 0 0.05", "20 -1 0.05"), "a.df line 12 is -1 for a cohesion, expected 0 or more"},
      {with(short_file, "35", "x"), "a.df line 11 is \"x\" for a number of run data, expected a finite number"},
      {with(long_file, "0 2 3", "0 1 3"),
       "a.df line 8 is 1 for the number of rows of a point, expected 0, or 2 and more"},
      {with(long_file, "9 1 -7", "0.5 1 -7"), "a.df line 13 is the time 0.5 behind 0.5, expected times that grow"},
  };
  for (const auto& each : all) expect_refused([&] { read_run_data(each.first, "a.df", 3); }, each.second);
}

}  // namespace
}  // namespace dda
