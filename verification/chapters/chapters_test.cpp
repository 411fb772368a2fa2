// Chapters 3 to 5: statements judged on figures that are known, among them wrong ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "verification/chapters/chapter_3.h"
#include "verification/chapters/chapter_4.h"
#include "verification/chapters/chapter_5.h"
#include "verification/chapters/chapters_test_support.h"
#include "verification/chapters/jinping.h"

namespace verify {
namespace {

// The thesis' tables as if all schemes had given them.
Calibration printed_calibration() {
  Calibration calibration = calibration_without_rows();
  for (const char* scheme : {"thesis", "classical_trapezoidal", "consistent", "accurate"})
    for (const PrintedResult& printed : thesis_reference().printed) {
      CalibrationRow row;
      row.scheme = scheme;
      row.dt = printed.dt;
      row.block_length = printed.block_length;
      row.reading = AmplitudeReading::half_range;
      row.printed = printed;
      row.picks = {1e3 * printed.amplitude_kpa, 1e3 * printed.amplitude_kpa, printed.velocity, printed.velocity};
      calibration.rows.push_back(row);
    }
  return calibration;
}

CalibrationRow& row(Calibration& c, const std::string& scheme, double dt, double length) {
  return *std::ranges::find_if(
      c.rows, [&](const auto& r) { return r.scheme == scheme && r.dt == dt && r.block_length == length; });
}

TEST(Chapter3, TheThesisTablesConfirmThemselvesButNotItsOptimum) {
  const Chapter chapter = chapter_3(printed_calibration());
  for (const char* id : {"3-amplitude-10us", "3-amplitude-100us", "3-velocity-10us", "3-velocity-100us",
                         "3-printed-errors", "3-below-2-percent", "3-smaller-steps", "3-springs-amplitude"})
    EXPECT_EQ(verdict(chapter, id), true) << id;
  for (const char* id : {"3-optimum", "3-smaller-blocks", "3-springs-velocity"})
    EXPECT_EQ(verdict(chapter, id), false) << id;
}

TEST(Chapter3, OneWrongValueInATableIsSeen) {
  Calibration calibration = printed_calibration();
  row(calibration, "thesis", 1e-4, 5).picks.half_range *= 1.006;
  row(calibration, "thesis", 1e-5, 1).picks.onset_velocity *= 0.994;
  const Chapter chapter = chapter_3(calibration);
  EXPECT_EQ(verdict(chapter, "3-amplitude-100us"), false);
  EXPECT_EQ(verdict(chapter, "3-velocity-10us"), false);
  EXPECT_EQ(verdict(chapter, "3-amplitude-10us"), true);
}

TEST(Chapter3, AnOptimumInTheRangeWouldBeConfirmed) {
  Calibration calibration = printed_calibration();
  for (const double dt : calibration.time_steps) {
    WavePicks& picks = row(calibration, "thesis", dt, 5).picks;
    picks.half_range = calibration.bar.incident_stress();
    picks.onset_velocity = calibration.bar.wave_speed();
  }
  EXPECT_EQ(verdict(chapter_3(calibration), "3-optimum"), true);
}

TEST(Chapter3, WhatGoesWithTheSpringsIsLaidToThem) {
  Calibration calibration = printed_calibration();
  row(calibration, "consistent", 1e-5, 0.5).picks.correlation_velocity = calibration.bar.wave_speed();
  row(calibration, "classical_trapezoidal", 1e-5, 0.5).picks.half_range = calibration.bar.incident_stress();
  const Chapter chapter = chapter_3(calibration);
  EXPECT_EQ(verdict(chapter, "3-springs-velocity"), true);
  EXPECT_EQ(verdict(chapter, "3-springs-amplitude"), false);
}

// One scheme that gives what Table 4.1 prints, and stresses that fall from the two in the text with 1/sqrt(R).
BlastStudy printed_blast() {
  BlastStudy study;
  study.dt = 1e-5;
  study.blocks = 1;
  BlastResult result{"printed", "", {}, 0, 0};
  for (const PrintedArrival& point : thesis_blast().points) {
    if (!point.actual_ms) continue;
    study.points.push_back(point);
    const double first = point.level() ? 5.14e6 * std::sqrt(5.0) : 8.17e6 * std::sqrt(4.0);
    result.readings.push_back({1e-3 * *point.actual_ms, 1, first / std::sqrt(point.distance)});
  }
  study.results.push_back(result);
  return study;
}

TEST(Chapter4, TheThesisTableConfirmsItself) {
  const Chapter chapter = chapter_4(printed_blast());
  for (const char* id : {"4-times", "4-mid-range", "4-near", "4-upright-better", "4-attenuation", "4-level-stress",
                         "4-upright-stress", "4-upright-over-level"})
    EXPECT_EQ(verdict(chapter, id), true) << id;
  EXPECT_EQ(verdict(chapter, "4-no-reflections"), std::nullopt);
}

TEST(Chapter4, EdgesAreJudgedByWhatComesBack) {
  BlastStudy study = printed_blast();
  study.edges = {{"dry", "H1", 0.02}, {"glued", "V2", 0.049}, {"continuous", "H2", 0.06}};
  EXPECT_EQ(verdict(chapter_4(study), "4-no-reflections"), true);
  study.edges[1].difference = 0.051;
  EXPECT_EQ(verdict(chapter_4(study), "4-no-reflections"), false);
}

TEST(Chapter4, WrongTimesAndStressesAreSeen) {
  BlastStudy study = printed_blast();
  std::vector<BlastReading>& readings = study.results.front().readings;
  readings[1].peak_time *= 1.2;                           // H2
  readings[2].peak_stress = 2 * readings[1].peak_stress;  // H3 above H2
  readings[0].peak_stress *= 1.2;                         // H1
  const Chapter chapter = chapter_4(study);
  for (const char* id : {"4-times", "4-mid-range", "4-attenuation", "4-level-stress", "4-upright-over-level"})
    EXPECT_EQ(verdict(chapter, id), false) << id;
  EXPECT_EQ(verdict(chapter, "4-upright-stress"), true);
}

TEST(Chapter4, AStudyIsReadAsItWasWritten) {
  BlastStudy study = printed_blast();
  study.decays.push_back({4e-3, {1, 2, 3}, {4, 5, 6}});
  study.edges.push_back({"dry", "H1", 0.125});
  const BlastStudy read = blast_from_json(blast_json(study));
  EXPECT_EQ(blast_json(read), blast_json(study));
  EXPECT_EQ(read.points.size(), study.points.size());
  EXPECT_THROW(static_cast<void>(blast_from_json("{\"points\": []}")), dda::InputError);
}

TEST(Chapter5, TriggerTimesOfTheTableContradictAnySpeed) {
  EXPECT_EQ(verdict(chapter_5(), "5-field-earlier"), true);
  EXPECT_EQ(verdict(chapter_5(), "5-material-explains"), false);
}

TEST(Chapter5, TriggersOfOneSlowSpeedWouldBeExplained) {
  std::vector<Sensor> sensors(jinping_sensors().begin(), jinping_sensors().end());
  for (Sensor& sensor : sensors) sensor.trigger = sensor.distance / 3000;
  EXPECT_EQ(verdict(chapter_5(sensors), "5-field-earlier"), false);
  EXPECT_EQ(verdict(chapter_5(sensors), "5-material-explains"), true);
}

std::vector<JinpingOutcome> jinping_as_described() {
  return {{jinping_readings().front(), {0.034, 0.034, 0.025, 0.024}, {0.033, 0.033, 0.0245, 0.0235}, {0.01, 0.02}}};
}

std::optional<bool> jinping_verdict(const std::vector<JinpingOutcome>& outcomes, const std::string& id) {
  Chapter chapter;
  judge_jinping(outcomes, chapter);
  return verdict(chapter, id);
}

TEST(Chapter5, TheModelIsJudgedByArrivalsAndEdges) {
  std::vector<JinpingOutcome> outcomes = jinping_as_described();
  EXPECT_EQ(jinping_verdict(outcomes, "5-arrivals"), true);
  EXPECT_EQ(jinping_verdict(outcomes, "5-no-reflections"), true);
  for (double& time : outcomes.front().arrivals) time *= 1.05;
  outcomes.front().edge_differences = {0.06, 0.06};
  EXPECT_EQ(jinping_verdict(outcomes, "5-arrivals"), false);
  EXPECT_EQ(jinping_verdict(outcomes, "5-no-reflections"), false);
  outcomes.front().arrivals.clear();
  EXPECT_EQ(jinping_verdict(outcomes, "5-arrivals"), std::nullopt);
}

TEST(Chapter5, AnArrivalIsTheFirstTwentiethOfThePeak) {
  EXPECT_EQ(arrival({0, 1, 2, 3, 4}, {0, 0.04, -0.06, 1, 0.5}), 2);
}

}  // namespace
}  // namespace verify
