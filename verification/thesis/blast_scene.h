// The blast of the thesis' chapter 4 as a Model, as far as the text defines it.
#pragma once

#include "engine/model/model.h"
#include "verification/thesis/blast_reference.h"

namespace verify {

// Blocks to the distances that Table 4.1 needs: 1 m x 2 m along the axes of the blast ("refined horizontal and
// vertical"), 8 m x 8 m in the four quarters between.
struct BlastMesh {
  int quarter_columns = 8;  // of 8 m: level to 7.2 + 8 quarter_columns m
  int quarter_rows = 5;     // upright to 7 + 8 quarter_rows m
};

// exp(-(t - start - rise)/decay_time) after a straight line over blast_rise.
struct BlastPulse {
  double decay_time = 0;  // s
  double start = 0;       // s
};
// In place of the jump of Eq. 18, s.
inline constexpr double blast_rise = 20e-6;
[[nodiscard]] double blast_factor(const BlastPulse& pulse, double time);

// Eq. 18 with R = the width of the octagon: t_a, s. The pressure starts at 1.1 t_a.
[[nodiscard]] double blast_arrival_time(const ThesisBlast& blast);
[[nodiscard]] BlastPulse equation_18(const ThesisBlast& blast);

struct BlastRun {
  dda::JointMaterial joint;
  dda::Integrator integrator;
  double dt = 0;        // s
  double duration = 0;  // s
  BlastPulse pulse;
  bool loaded = true;  // false: the run that is subtracted
  BlastMesh mesh;
  bool element = false;  // the hole is lined with the blast element of eight blocks
};
// The inner edges of the blast element over its outer ones. Its Figure 4.3 is not in the text.
inline constexpr double element_hollow = 0.5;

// Plane stress, small motions, viscous edges all around. The element's inner faces bear the same force as the wall of
// the hole without it. Measures velocity and stress in the direction of the blast at every point of Table 4.1 inside
// the mesh, two measurements a point.
[[nodiscard]] dda::Model blast_scene(const ThesisBlast& blast, const BlastRun& run);
[[nodiscard]] std::vector<PrintedArrival> points_inside(const ThesisBlast& blast, const BlastMesh& mesh);

}  // namespace verify
