// Section 6.2: a blast beside a tunnel, with joints of different friction, without stress and under 50 MPa.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "verification/chapters/jointed_rock.h"
#include "verification/chapters/scene_runs.h"
#include "verification/chapters/statement.h"

namespace verify {

struct TunnelBlastReading {
  std::string name;
  std::string difference;  // from the first reading
  JointSet first{0, 0.5};
  JointSet second{90, 0.5};
  double spacing = 2;  // m, of both
  std::string scheme = "accurate";
};

[[nodiscard]] std::vector<double> blast_frictions();  // deg: Table 6.2, and the 15 that its figures show
[[nodiscard]] std::vector<double> blast_stresses();   // Pa
[[nodiscard]] std::vector<TunnelBlastReading> tunnel_blast_readings();

// The name of the run with or without the blast.
[[nodiscard]] std::string tunnel_blast_run(const TunnelBlastReading& reading, double friction, double stress,
                                           bool blast);
[[nodiscard]] SceneFolder::Scene tunnel_blast_scene(const TunnelBlastReading& reading, double friction, double stress,
                                                    bool blast);

// With the blast less without it.
struct TunnelBlastOutcome {
  double friction = 0;                   // deg
  double stress = 0;                     // Pa, in situ
  std::array<double, 4> velocity{};      // m/s, largest: points 1 (wall at the blast), 2 roof, 3 far wall, 4 floor
  std::array<double, 4> acceleration{};  // m/s2
  double stress_5 = 0, stress_6 = 0;  // Pa, largest change of sigma_x or sigma_y: between blast and tunnel; behind it
  double roof_end_speed = 0;          // m/s downwards, with the blast, over the last fifth of its stage
  double free_fall_speed = 0;         // the same of a block that nothing has held since the tunnel was opened
};
[[nodiscard]] TunnelBlastOutcome tunnel_blast_outcome(double friction, double stress, const SceneRun& with,
                                                      const SceneRun& without);

struct TunnelBlastResult {
  TunnelBlastReading reading;
  std::vector<TunnelBlastOutcome> outcomes;  // by stress, then friction; those whose runs are well
};

[[nodiscard]] std::vector<TunnelBlastResult> run_tunnel_blast(const SceneFolder& folder,
                                                              const std::vector<TunnelBlastReading>& readings,
                                                              std::vector<std::string>& failures);

// Statements, assumptions and tables of section 6.2.
void judge_tunnel_blast(const std::vector<TunnelBlastResult>& results, Chapter& chapter);

}  // namespace verify
