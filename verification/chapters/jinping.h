// Chapter 5, the model: a blast in jointed rock of 120 m with sensors, in several readings of what the text leaves
// open.
#pragma once

#include <string>
#include <vector>

#include "verification/chapters/chapter_5.h"
#include "verification/chapters/scene_runs.h"

namespace verify {

struct JinpingReading {
  std::string name;
  std::string difference;  // from the first reading
  std::string scheme = "accurate";
  std::string plane = "strain";
  double density = 2700;    // kg/m3
  double dt = 2e-5;         // s
  double half_height = 13;  // m, of the rock
};

[[nodiscard]] std::vector<JinpingReading> jinping_readings();

// `margin` m of rock more on every side, for what the edges send back.
[[nodiscard]] SceneFolder::Scene jinping_scene(const JinpingReading& reading, double margin);

// m of rock more on every side, against which what the edges send back is measured. What its own edges send back
// reaches point 6 after the end of the run, and point 5 weakly from 28 ms on.
inline constexpr double larger_margin = 40;

// The name of a reading's run.
[[nodiscard]] std::string jinping_run(const JinpingReading& reading, double margin);

struct JinpingOutcome {
  JinpingReading reading;
  std::vector<double> arrivals;  // s from the start of the load, by sensor
  std::vector<double> theory;    // s, distance from the wall of the hole by Eq. 11
  std::vector<double>
      edge_differences;  // of the two edge points: largest difference from the larger model over the peak
};

// First time at which a velocity exceeds a twentieth of its largest size, s.
[[nodiscard]] double arrival(const std::vector<double>& time, const std::vector<double>& velocity);

[[nodiscard]] std::vector<JinpingOutcome> run_jinping(const SceneFolder& folder,
                                                      const std::vector<JinpingReading>& readings,
                                                      std::vector<std::string>& failures);

// The two statements on the model, its assumptions and its table.
void judge_jinping(const std::vector<JinpingOutcome>& outcomes, Chapter& chapter);

}  // namespace verify
