// Meshes around a cavity with a pressure on its wall, and the stresses that waves bring to their blocks.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/model/time_function.h"
#include "verification/exact/pressurised_cavity.h"
#include "verification/harness/cavity.h"
#include "verification/harness/recorded_run.h"

namespace verify {

// Rock of the cavity cases: plane strain, c_P = 3464 m/s.
inline constexpr double cavity_density = 2500;  // kg/m3
inline constexpr double cavity_young = 25e9;    // Pa
inline constexpr double cavity_poisson = 0.25;

[[nodiscard]] exact::Cavity cavity_in_rock(double radius);

// `sectors` blocks in a ring, from the radius 1 m to `outer_radius` (m); polygons have the areas of the circles. Rings
// are as thick as blocks are wide, beyond 2 m as thick as there. Sector 1 lies about the x axis.
[[nodiscard]] dda::Model ring_mesh(int sectors, double outer_radius);

// Squares of `size` (m), `half_width` of them to each side of the middle one, around an octagonal cavity: the sides
// along the axes are `straight` (odd) squares long, those between run along the diagonals of `slant` squares.
struct OctagonMesh {
  int straight = 3;
  int slant = 2;
  int half_width = 20;
  double size = 1;
};
[[nodiscard]] dda::Model octagon_mesh(const OctagonMesh& mesh);
// The radius of the circular cavity that sends out the same long waves, m.
[[nodiscard]] double octagon_source_radius(const OctagonMesh& mesh);

// Gives the model a single stage of small motions.
void set_stage(dda::Model& model, const dda::Integrator& integrator, double dt, double duration);

// Records the stresses of the block in which the point lies.
void probe(dda::Model& model, int block);

struct ProbeHistory {
  double radius = 0;           // m, of the block's centroid
  std::vector<double> radial;  // Pa, stress along the direction of the centroid
  std::vector<double> hoop;    // Pa, across it
};

// Returns what the i-th probe recorded.
[[nodiscard]] ProbeHistory probe_history(const dda::Model& model, const RecordedRun& run, std::size_t i);

}  // namespace verify
