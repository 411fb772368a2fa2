#include "verification/exact/cantilever.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double first_root = 1.8751040687119611664;  // cos x cosh x = -1

// What is left at the free end of deflection, turn, moment and shear force that start without deflection and turn.
double end_determinant(const Cantilever& beam, double omega) {
  const double shear_stiffness = 5 * (1 + beam.poisson) / (6 + 5 * beam.poisson) * beam.shear_modulus() * beam.height;
  const double inertia = beam.density * omega * omega;
  // Scaled by L, E I/L and E I/L^2, so that all entries are of order one: d/d(x/L) of (w/L, psi, M L/(E I), Q L^2/(E
  // I)).
  const double l = beam.length;
  const double bending = beam.young * beam.second_moment();
  Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
  system(0, 1) = 1;
  system(0, 3) = bending / (shear_stiffness * l * l);
  system(1, 2) = 1;
  system(2, 1) = -inertia * beam.second_moment() * l * l / bending;
  system(2, 3) = -1;
  system(3, 0) = -inertia * beam.height * std::pow(l, 4) / bending;
  // exp by squaring of a Taylor series.
  constexpr int squarings = 10;
  const Eigen::Matrix4d small = system / (1 << squarings);
  Eigen::Matrix4d term = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d transfer = term;
  for (int i = 1; i < 10; ++i) {
    term = term * small / i;
    transfer += term;
  }
  for (int i = 0; i < squarings; ++i) transfer = transfer * transfer;
  return transfer.bottomRightCorner<2, 2>().determinant();
}

}  // namespace

double bending_deflection(const Cantilever& beam, double load) {
  return load * std::pow(beam.length, 3) / (3 * beam.young * beam.second_moment());
}

double deflection_with_shear(const Cantilever& beam, double load) {
  return bending_deflection(beam, load) + 1.2 * load * beam.length / (beam.shear_modulus() * beam.height);
}

double fibre_stress(const Cantilever& beam, double load, double x, double y) {
  return load * (beam.length - x) * y / beam.second_moment();
}

double shear_stress(const Cantilever& beam, double load, double y) {
  return -load / (2 * beam.second_moment()) * (beam.height * beam.height / 4 - y * y);
}

double mean_shear_stress(const Cantilever& beam, double load, double lower, double upper) {
  // Simpson's rule, exact for a parabola.
  return (shear_stress(beam, load, lower) + 4 * shear_stress(beam, load, (lower + upper) / 2) +
          shear_stress(beam, load, upper)) /
         6;
}

double bending_frequency(const Cantilever& beam) {
  return first_root * first_root / (2 * std::numbers::pi * beam.length * beam.length) *
         std::sqrt(beam.young * beam.second_moment() / (beam.density * beam.height));
}

double mode_deflection(const Cantilever& beam, double x) {
  const double share = (std::cosh(first_root) + std::cos(first_root)) / (std::sinh(first_root) + std::sin(first_root));
  const double z = first_root * x / beam.length;
  return std::cosh(z) - std::cos(z) - share * (std::sinh(z) - std::sin(z));
}

double mode_slope(const Cantilever& beam, double x) {
  const double share = (std::cosh(first_root) + std::cos(first_root)) / (std::sinh(first_root) + std::sin(first_root));
  const double z = first_root * x / beam.length;
  return first_root / beam.length * (std::sinh(z) + std::sin(z) - share * (std::cosh(z) - std::cos(z)));
}

double timoshenko_frequency(const Cantilever& beam) {
  const double upper = 2 * std::numbers::pi * bending_frequency(beam);
  double high = upper;
  double low = upper / 2;
  const double sign_low = end_determinant(beam, low);
  while (high - low > 1e-14 * upper) {
    const double middle = (low + high) / 2;
    (end_determinant(beam, middle) * sign_low > 0 ? low : high) = middle;
  }
  return low / (2 * std::numbers::pi);
}

}  // namespace exact
