// A plane P or S wave in a wide field of equal bonded blocks, looked at before anything is back from the field's edges:
// of any direction, pushed by forces along a line through the field, or pushed on a flat face of it.
#pragma once

#include <array>
#include <vector>

#include "engine/advice/plane_wave.h"
#include "engine/core/counters.h"
#include "engine/model/model.h"
#include "verification/lattice/periodic_mesh.h"

namespace verify {

struct OpenField {
  PeriodicMesh mesh;  // one block and its translations, or bricks: all blocks alike
  dda::Material rock;
  dda::JointMaterial joint;
  dda::Stage stage;  // dt and integrator
  dda::WaveKind kind = dda::WaveKind::p;
  dda::Vec2 direction = dda::Vec2::UnitX();  // unit
  dda::Vec2 particles = dda::Vec2::UnitX();  // unit: along which it is pushed and looked at
  double wavelength = 10;                    // m, of the pulse: two cycles under a sin^2 envelope
  double near = 0.5, far = 2;                // wavelengths from the line to the receivers
  double fastest = 1.2, slowest = 0.9;       // speeds of the waves that count, over that of the continuum

  [[nodiscard]] double speed() const;  // m/s, of the continuum
  [[nodiscard]] double frequency() const { return speed() / wavelength; }
  // -, of the push at time t (s).
  [[nodiscard]] double pulse(double t) const;
};

// The field with its line of forces and two receivers, for as many steps as the wave takes to pass them.
[[nodiscard]] dda::Model field_with_line(const OpenField& field);

// Velocities (m/s) in x and y after every step, the first at rest, of two block centroids.
struct PassingWave {
  std::array<std::vector<double>, 2> near, far;
  double distance = 0;  // m, between the two along the direction
};

// `model` is field_with_line. Throws std::runtime_error if a step fails.
[[nodiscard]] PassingWave run(const OpenField& field, const dda::Model& model, dda::Counters& counters);

// The half of the field that the direction points into, pushed by 1 MPa on its face, with one measurement: the traction
// along the push at the joint nearest to `far`. The direction is across flat layers of blocks.
[[nodiscard]] dda::Model field_with_face(const OpenField& field);

}  // namespace verify
