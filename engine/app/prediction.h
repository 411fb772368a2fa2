// What blocks, interfaces and time steps do to a harmonic wave, before anything is run: leading-order errors of its
// speed, cause by cause. README.md has the formulas.
#pragma once

#include "engine/model/settings.h"

namespace dda {

// A plane wave that runs across a row of equal blocks.
struct BlockWave {
  double frequency = 0;   // Hz
  double speed = 0;       // m/s, in the continuous material
  double block_size = 0;  // m, along the wave
  double compliance = 0;  // eta_s = modulus * interface area / (interface stiffness * block size); 0 without springs
  double lateral_coupling = 0;  // nu^2 ks h/(L E) of a bar with corner springs, which keep its sides from contracting
  bool cubic = false;           // all interfaces have the cubic law
  double strain_inertia = 1;
  double softened = 0;  // taken off (omega/k)^2 by the jumps of strains (mesh_correction.h), over (Omega c)^2
  Integrator integrator;
  double dt = 0;                // s
  bool time_corrected = false;  // inertia of cubic or consistent interfaces makes up for the integrator's period error
  // Of consistent interfaces: what time correction takes, over the modulus of the wave, from the inertia between blocks
  // and from that of their strains; and the most that the latter can give, over the mass of a block times its size^2.
  double shear = 0, strain = 0, most_strain = 0;
};

// Relative errors of the phase speed (positive: too fast), and the share of the amplitude that the integrator takes on
// the way of one wavelength (negative: it grows).
struct WaveErrors {
  double interfaces = 0;
  double blocks = 0;
  double time = 0;
  double amplitude_loss = 0;

  [[nodiscard]] double speed() const { return interfaces + blocks + time; }
};

inline double wavelength(const BlockWave& wave) { return wave.speed / wave.frequency; }  // m

WaveErrors predict_errors(const BlockWave& wave);

}  // namespace dda
