// The thesis' chapter 3 as data: its bar and what its tables print.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace verify {

// Table 3.1 and section 3.1, SI units.
struct ThesisBar {
  double density = 0;           // kg/m3
  double young = 0;             // Pa
  double poisson = 0;           // -
  double friction_angle = 0;    // rad
  double cohesion = 0;          // Pa
  double tensile_strength = 0;  // Pa
  double length = 0;            // m
  double height = 0;            // m
  double measuring_point = 0;   // m from the loaded end
  double load_amplitude = 0;    // N per m of thickness
  double load_frequency = 0;    // Hz, one cycle

  [[nodiscard]] double wave_speed() const;                                           // m/s, sqrt(E/rho): thesis Eq. 14
  [[nodiscard]] double wavelength() const { return wave_speed() / load_frequency; }  // m
  [[nodiscard]] double incident_stress() const { return load_amplitude / height; }   // Pa, A0 of thesis Eq. 15
  [[nodiscard]] double eta(double block_length) const { return block_length / wavelength(); }  // thesis Eq. 16
};

// One column of Tables 3.2 and 3.3.
struct PrintedResult {
  double dt = 0;             // s
  double block_length = 0;   // m
  double amplitude_kpa = 0;  // Table 3.2
  double velocity = 0;       // m/s, Table 3.3
};

struct ThesisReference {
  ThesisBar bar;
  std::vector<double> time_steps;      // s, in the order of the tables
  std::vector<double> block_lengths;   // m
  std::vector<PrintedResult> printed;  // by time step, then block length

  // Throws std::out_of_range where the tables have no such column.
  [[nodiscard]] const PrintedResult& at(double dt, double block_length) const;
};

[[nodiscard]] const ThesisReference& thesis_reference();

// reference_data/thesis_tables_3.json
[[nodiscard]] std::string_view thesis_tables_text();

}  // namespace verify
