// A column of a material that carries no tension, under a force N beside its axis (Timoshenko & Gere 1972, Mechanics of
// Materials; the core of a section): sections stay plane, and what would be pulled is open.
#pragma once

namespace exact {

// Turn (rad) of one end against the other of a column with sides of `width` (m) and thickness 1 m, N (N per m of
// thickness) at `eccentricity` from the axis (m, at least 0 and below half of the width).
[[nodiscard]] inline double no_tension_turn(double force, double eccentricity, double width, double length,
                                            double young) {
  if (6 * eccentricity <= width) return 12 * force * eccentricity * length / (young * width * width * width);
  const double to_edge = width / 2 - eccentricity;  // a third of what is pressed
  return 2 * force * length / (9 * young * to_edge * to_edge);
}

// How much (m, at least 0) the axis shortens.
[[nodiscard]] inline double no_tension_shortening(double force, double eccentricity, double width, double length,
                                                  double young) {
  if (6 * eccentricity <= width) return force * length / (young * width);
  const double to_edge = width / 2 - eccentricity;
  return no_tension_turn(force, eccentricity, width, length, young) * (3 * to_edge - width / 2);
}

}  // namespace exact
