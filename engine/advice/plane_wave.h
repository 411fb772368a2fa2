// Plane waves in a lattice in any direction, each block answering its neighbours' motion with the phase of the wave.
#pragma once

#include <optional>

#include "engine/advice/lattice.h"
#include "engine/advice/time_steps.h"

namespace dda {

enum class WaveKind {
  bar,  // along a row whose sides are free
  p,
  s,
};

// m/s, of the continuous material.
double continuum_speed(const Material& material, WaveKind kind);

// The unit vector along which particles move.
Vec2 polarization(WaveKind kind, const Vec2& direction);

using ComplexVec6 = Eigen::Matrix<Complex, 6, 1>;
using ComplexMat6 = Eigen::Matrix<Complex, 6, 6>;

// A wave exp(s t - i q x), x along the direction: s given, q (1/m) sought.
struct PlaneWave {
  Complex wavenumber;
  ComplexVec6 shape;
};

class WaveSolver {
 public:
  // `direction`: unit vector.
  WaveSolver(const Lattice& lattice, const Stage& stage, WaveKind kind, const Vec2& direction);

  // Wave of the frequency omega (rad/s) in steady motion, under the time steps given. Nothing above the highest
  // frequency that the blocks carry.
  [[nodiscard]] std::optional<PlaneWave> steady(const TimeSteps& time, double omega) const;

  // The solution of (stiffness(q) + square inertia(q)) shape = 0 nearest to `guess` (Newton's method).
  [[nodiscard]] std::optional<PlaneWave> near(PlaneWave guess, Complex square) const;

  // 1/m, of a wave two blocks long, or close to it.
  [[nodiscard]] double largest_wavenumber() const;

  // Long wave of the kind, to begin a search with.
  [[nodiscard]] PlaneWave long_wave(Complex s) const;

 private:
  // The wave of the kind at a real wavenumber: rad/s, and its shape.
  struct Mode {
    double omega = 0;
    ComplexVec6 shape;
  };
  [[nodiscard]] Mode mode_at(double wavenumber) const;

  LatticeMatrices matrices_;
  LatticeMatrices uncorrected_;  // as they are without time steps, which the search begins with
  Vec2 direction_, particles_;
  double speed_;
  double shortest_step_;  // m, least distance of two blocks along the direction
};

}  // namespace dda
