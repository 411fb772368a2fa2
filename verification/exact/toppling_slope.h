// Limit equilibrium of a slope of columns on a stepped base (Goodman and Bray 1976; Hoek and Bray 1981, chapter 10).
//
// Column n = 1 .. N (1 at the toe) is y_n high and `width` wide, on a base that dips at psi out of the slope. Below the
// crest a column's top is `lower_step` above its downhill neighbour's, above the crest `upper_step` below; each base is
// `base_step` above its downhill neighbour's. Column n feels P_n from above and passes P_(n-1) on, at the top of the
// shorter of the two (M_n and L_n above the base), with friction mobilised on both sides when it topples:
//   topples: P_(n-1) = (P_n (M_n - width tan f) + (W_n/2)(y_n sin psi - width cos psi))/L_n
//   slides:  P_(n-1) = P_n - W_n (cos psi tan f - sin psi)/(1 - tan^2 f)
// and the larger counts; zero where neither needs holding. The slope stands when the toe column needs none: P_0 <= 0.
#pragma once

#include <vector>

namespace exact {

struct TopplingSlope {
  double width = 10;        // m, of the columns
  double dip = 0;           // rad, psi
  double lower_step = 5;    // m, a_1
  double upper_step = 5;    // m, a_2
  double base_step = 1;     // m, b
  int crest = 10;           // number of the highest column
  int columns = 16;         // N
  double unit_weight = 25;  // kN/m3; forces in kN per m of thickness

  [[nodiscard]] double height(int column) const;  // y_n, m
};

// The published example: 16 columns, psi = 30 deg, 92.5 m high.
[[nodiscard]] TopplingSlope goodman_bray_slope();

// P_0 .. P_N, kN per m of thickness, for one coefficient of friction on sides and bases. P_0 may be negative.
[[nodiscard]] std::vector<double> column_forces(const TopplingSlope& slope, double friction);

// The coefficient of friction at which P_0 = 0, between `low` and `high`.
[[nodiscard]] double limiting_friction(const TopplingSlope& slope, double low = 0.6, double high = 0.9);

}  // namespace exact
