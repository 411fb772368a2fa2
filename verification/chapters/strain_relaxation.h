// Section 6.1: a tunnel is opened in jointed rock under stress, in several readings of what the text leaves open.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/chapters/jointed_rock.h"
#include "verification/chapters/scene_runs.h"
#include "verification/chapters/statement.h"

namespace verify {

struct RelaxationReading {
  std::string name;
  std::string difference;  // from the first reading
  JointSet first{60, 1.0 / 3};
  JointSet second{120, 0};
  double spacing = 3;      // m, of both
  double half_width = 30;  // m, of the square that is modelled
  std::string scheme = "accurate";
  double dt = 1e-4;            // s
  double duration = 0.1;       // s, after the tunnel is opened
  double velocity_factor = 1;  // k01
  bool sides_held = true;      // level, while the rock settles
};

// Stresses of Table 6.1, Pa.
[[nodiscard]] std::vector<double> relaxation_stresses();
[[nodiscard]] std::vector<RelaxationReading> relaxation_readings();
// Small and short, for tests: seconds in all.
[[nodiscard]] std::vector<RelaxationReading> quick_relaxation_readings();

// The blocks that the text measures, found by block theory as there: the largest that friction holds on a joint at the
// left wall, and the largest that falls from the roof.
struct KeyBlocks {
  std::string wall;  // "" where block theory finds none
  std::string roof;
};
[[nodiscard]] KeyBlocks key_blocks_of(const SceneFolder::Scene& bodies);

// The name of the run at this stress.
[[nodiscard]] std::string relaxation_run(const RelaxationReading& reading, double stress);
[[nodiscard]] SceneFolder::Scene relaxation_scene(const RelaxationReading& reading, double stress,
                                                  const KeyBlocks& blocks);

// What is read of a run from the moment when the tunnel is opened.
struct RelaxationOutcome {
  double stress = 0;                  // Pa, in situ
  double wall_peak_velocity = 0;      // m/s, key block 1
  double wall_peak_acceleration = 0;  // m/s2
  double wall_displacement = 0;       // m, largest
  double wall_end_speed = 0;          // m/s, mean over the last fifth of the run
  double roof_end_speed = 0;          // the same of key block 2, downwards
  double free_fall_speed = 0;         // the same of a block that nothing holds, by the same steps and damping
  double near_response = 0;           // Pa, point 3: largest change of sigma_x or sigma_y
  double far_response = 0;            // Pa, point 5
};
[[nodiscard]] RelaxationOutcome relaxation_outcome(const RelaxationReading& reading, double stress,
                                                   const SceneRun& run);

struct RelaxationResult {
  RelaxationReading reading;
  std::vector<RelaxationOutcome> outcomes;  // by stress; fewer where a run failed
  std::string missing;                      // why there are fewer; "" otherwise
};

// Runs what is open and reads all. Failures go to the chapter.
[[nodiscard]] std::vector<RelaxationResult> run_relaxation(const SceneFolder& folder,
                                                           const std::vector<RelaxationReading>& readings,
                                                           std::vector<std::string>& failures);

// Statements, assumptions and tables of section 6.1.
void judge_relaxation(const std::vector<RelaxationResult>& results, Chapter& chapter);

}  // namespace verify
