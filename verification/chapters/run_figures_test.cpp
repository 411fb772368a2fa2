#include "verification/chapters/run_figures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/core/temporary_folder.h"

namespace verify {
namespace {

// Settled in a stage without time: two rows at 0, of which the second is what the tunnel is opened in.
void write_run(const std::filesystem::path& folder, int rows) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << R"({"status": "ok"})";
  std::ofstream csv(folder / "histories.csv");
  csv << "time [s]";
  for (const char* column : {"displacement_x [m]", "displacement_y [m]", "velocity_x [m/s]", "velocity_y [m/s]",
                             "acceleration_x [m/s2]", "acceleration_y [m/s2]"})
    csv << ",block_1_" << column;
  csv << "\n0,9,9,9,9,9,9\n";
  for (int row = 0; row < rows; ++row) csv << row << ",3,4,3,4,3,4\n";
}

// A run that is well has a figure of its history and the others have none; there is no mesh without the program that
// draws it.
TEST(RunFigures, HistoriesAreOfTheRunsThatAreWell) {
  const dda::TemporaryFolder folder;
  std::ostringstream out;
  const SceneFolder scenes(folder.path(), folder.path() / "no_such_program", 1, out);
  const RelaxationReading reading = relaxation_readings().front();
  write_run(folder.path() / "runs" / relaxation_run(reading, 0), 4);
  write_run(folder.path() / "runs" / relaxation_run(reading, 50e6), 3);
  Chapter chapter;
  draw_relaxation(scenes, {{reading, {}, ""}}, chapter);
  ASSERT_EQ(chapter.figures.size(), 3U);
  EXPECT_EQ(chapter.figures[1].file, "6_1_history_velocity.svg");
  const std::string& svg = chapter.figures[1].svg;
  EXPECT_NE(svg.find("50 MPa"), std::string::npos);
  EXPECT_EQ(svg.find("10 MPa"), std::string::npos);
  EXPECT_EQ(svg.find(">12<"), std::string::npos);  // the row before the tunnel is opened would need a scale up to 12.7
  ASSERT_EQ(chapter.sections.size(), 1U);
  EXPECT_EQ(chapter.sections[0].pieces.size(), 3U);
}

void write_sensors(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << R"({"status": "ok"})";
  std::ofstream csv(folder / "histories.csv");
  csv << "time [s]";
  for (const Sensor& sensor : jinping_sensors()) csv << "," << sensor.name << " [m/s]";
  csv << ",point 5 [m/s],point 6 [m/s]\n0,0,0,0,0,0,0\n1,1,2,3,4,5,6\n";
}

TEST(RunFigures, SensorsAndEdgesOfJinping) {
  const dda::TemporaryFolder folder;
  std::ostringstream out;
  const SceneFolder scenes(folder.path(), folder.path() / "no_such_program", 1, out);
  const JinpingReading reading = jinping_readings().front();
  write_sensors(folder.path() / "runs" / jinping_run(reading, 0));
  Chapter chapter;
  draw_jinping(scenes, {reading}, chapter);
  EXPECT_TRUE(chapter.figures.empty());  // nothing to compare the edges with
  write_sensors(folder.path() / "runs" / jinping_run(reading, larger_margin));
  draw_jinping(scenes, {reading}, chapter);
  ASSERT_EQ(chapter.figures.size(), 2U);
  EXPECT_NE(chapter.figures[0].svg.find("S2-4"), std::string::npos);
  EXPECT_NE(chapter.figures[1].svg.find("point 6, larger rock"), std::string::npos);
}

TEST(RunFigures, AReadingWithoutRunsHasNone) {
  const dda::TemporaryFolder folder;
  std::ostringstream out;
  const SceneFolder scenes(folder.path(), folder.path() / "no_such_program", 1, out);
  Chapter chapter;
  draw_relaxation(scenes, {}, chapter);
  draw_tunnel_blast(scenes, {}, chapter);
  draw_relaxation(scenes, {{relaxation_readings().front(), {}, "no key block"}}, chapter);
  EXPECT_TRUE(chapter.figures.empty());
  EXPECT_TRUE(chapter.sections.empty());
}

}  // namespace
}  // namespace verify
