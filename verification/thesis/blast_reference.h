// The thesis' chapter 4 as data: its blast and what Table 4.1 prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace verify {

struct PrintedArrival {
  std::string point;                // "H1": level, "V1": upright
  double distance = 0;              // m from the centre; inferred from the predictions
  std::optional<double> actual_ms;  // time of the peak velocity; none where the table says N/A
  double predicted_ms = 0;

  [[nodiscard]] bool level() const { return point.front() == 'H'; }
};

struct ThesisBlast {
  double density = 0;         // kg/m3
  double young = 0;           // Pa
  double poisson = 0;         // -
  double friction_angle = 0;  // rad
  double time_step = 0;       // s
  double octagon_edge = 0;    // m
  double peak_pressure = 0;   // Pa
  double block_along_x = 0;   // m
  double block_along_y = 0;   // m
  double level_stress = 0;    // Pa, largest printed
  double upright_stress = 0;  // Pa, largest printed
  std::vector<PrintedArrival> points;

  // From side to side of the octagon, m.
  [[nodiscard]] double octagon_width() const;
  // m/s; Eq. 11 of the thesis is that of plane strain.
  [[nodiscard]] double speed_plane_stress() const;
  [[nodiscard]] double speed_plane_strain() const;
};

[[nodiscard]] const ThesisBlast& thesis_blast();

// reference_data/thesis_tables_4.json
[[nodiscard]] std::string_view thesis_blast_text();

}  // namespace verify
