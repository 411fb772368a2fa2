#include "engine/advice/plane_wave.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "engine/contact/cubic_law.h"

namespace dda {

double continuum_speed(const Material& material, WaveKind kind) {
  switch (kind) {
    case WaveKind::bar: return std::sqrt(side_free_modulus(material) / material.density);
    case WaveKind::p: return p_wave_speed(material);
    case WaveKind::s: return s_wave_speed(material);
  }
  return 0;
}

Vec2 polarization(WaveKind kind, const Vec2& direction) {
  return kind == WaveKind::s ? Vec2(-direction.y(), direction.x()) : direction;
}

namespace {

Stage without_correction(Stage stage) {
  stage.correct_time_dispersion = false;
  return stage;
}

}  // namespace

WaveSolver::WaveSolver(const Lattice& lattice, const Stage& stage, WaveKind kind, const Vec2& direction)
    : matrices_(lattice_matrices(lattice, stage)),
      uncorrected_(lattice_matrices(lattice, without_correction(stage))),
      direction_(direction),
      particles_(polarization(kind, direction)),
      speed_(continuum_speed(lattice.material, kind)),
      shortest_step_(std::numeric_limits<double>::infinity()) {
  for (const Vec2& offset : lattice.offsets) {
    const double step = std::abs(offset.dot(direction));
    if (step > 1e-6 * offset.norm()) shortest_step_ = std::min(shortest_step_, step);
  }
}

// Finds the wave whose blocks move most as the kind says, among all of this wavenumber with the same kinetic energy.
WaveSolver::Mode WaveSolver::mode_at(double wavenumber) const {
  ComplexMat6 stiffness = uncorrected_.stiffness.cast<Complex>();
  ComplexMat6 inertia = uncorrected_.inertia.cast<Complex>();
  for (const LatticeCoupling& coupling : uncorrected_.couplings) {
    const Complex phase = std::polar(1.0, -wavenumber * direction_.dot(coupling.offset));
    stiffness += phase * coupling.stiffness;
    inertia += phase * coupling.inertia;
  }
  // Strains may have no inertia (see Stage::lateral_inertia); a trace of it keeps the problem definite, and is gone
  // when near() has the last word.
  const double trace = 1e-6 * uncorrected_.inertia.diagonal().tail<4>().maxCoeff();
  inertia.diagonal().tail<4>().array() += trace;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> waves(stiffness, inertia);
  Mode mode;
  double most = -1;
  for (int i = 0; i < 6; ++i) {
    const ComplexVec6 shape = waves.eigenvectors().col(i);
    const double moved = std::abs(particles_.cast<Complex>().dot(shape.head<2>()));
    if (moved <= most) continue;
    most = moved;
    mode = {std::sqrt(std::max(waves.eigenvalues()(i), 0.0)), shape};
  }
  return mode;
}

double WaveSolver::largest_wavenumber() const { return 0.98 * std::numbers::pi / shortest_step_; }

PlaneWave WaveSolver::long_wave(Complex s) const {
  const Mode mode = mode_at(1e-3 / shortest_step_);
  return {Complex(0, -1) * s / speed_, mode.shape};
}

// Where frequency grows with the wavenumber a few steps of q <- q omega/omega(q) find the wave in continuous time; the
// time steps then move it a little, and into the complex plane.
std::optional<PlaneWave> WaveSolver::steady(const TimeSteps& time, double omega) const {
  double q = omega / speed_;
  Mode mode = mode_at(q);
  for (int i = 0; i < 100 && std::abs(mode.omega / omega - 1) > 1e-10; ++i) {
    if (!(mode.omega > 0)) return std::nullopt;
    q *= omega / mode.omega;
    if (!(q < largest_wavenumber())) return std::nullopt;
    mode = mode_at(q);
  }
  if (std::abs(mode.omega / omega - 1) > 1e-6) return std::nullopt;
  return near({q, mode.shape}, time.square({0, omega}));
}

std::optional<PlaneWave> WaveSolver::near(PlaneWave guess, Complex square) const {
  if (!guess.shape.allFinite()) return std::nullopt;
  guess.shape.normalize();
  for (int i = 0; i < 60; ++i) {
    ComplexMat6 forces = matrices_.stiffness.cast<Complex>() + square * matrices_.inertia.cast<Complex>();
    ComplexMat6 slope = ComplexMat6::Zero();
    for (const LatticeCoupling& coupling : matrices_.couplings) {
      const double distance = direction_.dot(coupling.offset);
      const ComplexMat6 part = std::exp(Complex(0, -distance) * guess.wavenumber) *
                               (coupling.stiffness.cast<Complex>() + square * coupling.inertia.cast<Complex>());
      forces += part;
      slope += Complex(0, -distance) * part;
    }
    const ComplexVec6 moved = forces.partialPivLu().solve(slope * guess.shape);
    const Complex share = guess.shape.dot(moved);                               // conjugates the first
    if (!std::isfinite(std::abs(share)) || std::abs(share) == 0) return guess;  // singular to the last bit: there it is
    const Complex change = 1.0 / share;
    guess.wavenumber -= change;
    guess.shape = (moved / share).normalized();
    if (std::abs(change) < 1e-11 * std::abs(guess.wavenumber)) return guess;
  }
  return std::nullopt;
}

}  // namespace dda
