// Runs the blast of the thesis' chapter 4 with joints as the text has them and with others, and reads Table 4.1 of
// each.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "verification/thesis/blast_scene.h"

namespace verify {

struct BlastReading {
  double peak_time = 0;      // s from the blast, of the largest velocity away from it
  double peak_velocity = 0;  // m/s
  double peak_stress = 0;    // Pa, compression
};

struct BlastResult {
  std::string name;
  std::string description;
  std::vector<BlastReading> readings;  // by point; with the blast minus without
  double largest_without = 0;          // m/s, of all velocities in the run without the blast
  double cpu_s = 0;                    // of the run with it
};

// Dry joints and another decay time; the load starts at once. Of H1 and V1.
struct DecayResult {
  double decay_time = 0;  // s
  BlastReading level, upright;
};

// What the viscous edges of a small domain send back: the largest difference of velocities to those in a domain twice
// as far each way, from which nothing has come back by then, over the peak there.
struct EdgeResult {
  std::string name;       // of the scheme
  std::string point;      // with the largest difference
  double difference = 0;  // share of the peak
};

struct BlastStudy {
  std::vector<PrintedArrival> points;
  std::vector<BlastResult> results;
  std::vector<DecayResult> decays;
  std::vector<EdgeResult> edges;
  int blocks = 0;
  double dt = 0;        // s
  double duration = 0;  // s
};

struct BlastOptions {
  BlastMesh mesh = {};
  double duration = 22e-3;                                                // s
  std::vector<double> decay_times{0.364e-3, 0.729e-3, 2e-3, 4e-3, 8e-3};  // s, on a small mesh
  double duration_of_edges = 9e-3;                                        // s, of a small mesh and one twice as large
  std::ostream* progress = nullptr;                                       // a terminal, or none
};

// Throws std::runtime_error, saying when and why, if a run fails.
[[nodiscard]] BlastStudy run_blast_study(const ThesisBlast& blast, const BlastOptions& options);

}  // namespace verify
