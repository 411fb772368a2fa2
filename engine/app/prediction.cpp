#include "engine/app/prediction.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/contact/cubic_law.h"
#include "engine/contact/mesh_correction.h"

namespace dda {
namespace {

using Complex = std::complex<double>;

// Wavenumber that the time steps give a wave of frequency omega, over omega/c. With z = exp(i theta) the integrator
// replaces omega^2 by -(z - 2 + 1/z)/(dt^2 (beta z + (1/2 + gamma - 2 beta) + (1/2 - gamma + beta)/z)), times the ratio
// of the weights alpha_m and alpha_f. All powers of theta are kept: high orders matter at a few steps a period, and the
// amplitude loss of most integrators has no low ones.
Complex wavenumber_ratio(const Integrator& integrator, double theta) {
  const double beta = integrator.beta;
  const double gamma = integrator.gamma;
  const Complex z = std::polar(1.0, theta);
  const Complex newmark = beta * z + (0.5 + gamma - 2 * beta) + (0.5 - gamma + beta) / z;
  const Complex inertia_weight = (1 - integrator.alpha_m) + integrator.alpha_m / z;
  const Complex force_weight = (1 - integrator.alpha_f) + integrator.alpha_f / z;
  const double minus_second_difference = 4 * std::pow(std::sin(theta / 2), 2);
  return std::sqrt(minus_second_difference / newmark * inertia_weight / force_weight) / theta;
}

// By how much inertia is lowered, over the mass of a block and (block size/wave)^2.
double lowered_inertia(const BlockWave& wave, double wanted) {
  if (wave.cubic) return std::min(wanted, cubic::most_correction);
  return std::min(wanted * wave.shear, mesh::most_correction) + std::min(wanted * wave.strain, wave.most_strain);
}

// Share of the speed that the inertia of cubic and consistent interfaces gives back.
double time_correction(const BlockWave& wave, double theta) {
  const double courant = wave.speed * wave.dt / wave.block_size;
  const double lowered = lowered_inertia(wave, period_error(wave.integrator) * courant * courant);
  return lowered / (courant * courant) * theta * theta / 2;
}

double block_error(const BlockWave& wave, double phase) {
  if (wave.cubic) return std::pow(phase, 6) / 60480;
  return (2 - wave.strain_inertia - 12 * wave.softened) * phase * phase / 24;
}

}  // namespace

WaveErrors predict_errors(const BlockWave& wave) {
  const double omega = 2 * std::numbers::pi * wave.frequency;
  const double phase = omega * wave.block_size / wave.speed;  // of one block
  const double theta = omega * wave.dt;
  const Complex ratio = wavenumber_ratio(wave.integrator, theta);
  WaveErrors errors;
  errors.interfaces = -wave.compliance / 2 + wave.lateral_coupling * phase * phase / 4;
  errors.blocks = block_error(wave, phase);
  errors.time = 1 / ratio.real() - 1;
  if (wave.time_corrected) errors.time += time_correction(wave, theta);
  errors.amplitude_loss = 1 - std::exp(2 * std::numbers::pi * ratio.imag() / ratio.real());
  return errors;
}

}  // namespace dda
