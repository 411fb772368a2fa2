// For tests: rings of bonded blocks around a hole with a lining on its wall, and what theory says of it.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation/simulation_models.h"

namespace dda {

// Plane strain; the hole's radius is that of the middles of the wall's faces. `far_stress`: on the outside.
struct LinedHole {
  double radius = 2.5, outer_radius = 10;  // m
  int sectors = 32;
  Vec3 far_stress = {-2e6, -1e6, 0};  // Pa
  double thickness = 0.2;             // m
  double lining_young = 15e9;         // Pa
  double lining_poisson = 0.2;
};

inline Material rock_around_hole() {
  Material material = rock();
  material.young = 5e9;
  material.poisson = 0.25;
  material.plane = PlaneState::strain;
  return material;
}

// Corners of rings of blocks about as long as wide.
inline std::vector<double> ring_radii(const LinedHole& hole) {
  const double step = 2 * std::numbers::pi / hole.sectors;
  const int layers = static_cast<int>(std::ceil(std::log(hole.outer_radius / hole.radius) / step));
  const double to_corner = 1 / std::cos(step / 2);
  std::vector<double> radii;
  for (int i = 0; i <= layers; ++i)
    radii.push_back(to_corner * hole.radius * std::pow(hole.outer_radius / hole.radius, 1.0 * i / layers));
  return radii;
}

inline Vec2 on_circle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

// Around the hole as its wall's blocks see it: the rock on the left, so clockwise. `first`: the block of sector 0.
inline Lining ring_lining(const LinedHole& hole, int first) {
  Lining lining;
  lining.name = "shotcrete";
  lining.closed = true;
  lining.thickness = hole.thickness;
  lining.young = hole.lining_young;
  lining.poisson = hole.lining_poisson;
  const double step = 2 * std::numbers::pi / hole.sectors;
  for (int i = hole.sectors - 1; i >= 0; --i) {
    const double angle = (i + 0.5) * step;
    lining.nodes.push_back({first + i, on_circle(hole.radius, angle), {std::sin(angle), -std::cos(angle)}});
  }
  return lining;
}

// Loaded on the outside from the start; three supports that carry nothing.
inline Model lined_hole(const LinedHole& hole, const JointMaterial& joint) {
  Model model;
  model.materials = {rock_around_hole()};
  model.joints = {joint};
  const std::vector<double> radii = ring_radii(hole);
  const double step = 2 * std::numbers::pi / hole.sectors;
  for (std::size_t ring = 0; ring + 1 < radii.size(); ++ring)
    for (int i = 0; i < hole.sectors; ++i)
      model.blocks.emplace_back().shape.outer = {on_circle(radii[ring], i * step), on_circle(radii[ring + 1], i * step),
                                                 on_circle(radii[ring + 1], (i + 1) * step),
                                                 on_circle(radii[ring], (i + 1) * step)};
  const int last_ring = hole.sectors * static_cast<int>(radii.size() - 2);
  for (int i = 0; i < hole.sectors; ++i) {
    const Vec2 normal = on_circle(1, (i + 0.5) * step);
    model.edge_loads.push_back({last_ring + i, on_circle(radii.back(), i * step),
                                on_circle(radii.back(), (i + 1) * step), traction_on(hole.far_stress, normal),
                                Constant{}});
  }
  const int half = hole.sectors / 2;
  model.supports = {{last_ring, on_circle(radii.back(), 0), true, true, 1e10, Vec2::Zero(), {}},
                    {last_ring + half, on_circle(radii.back(), half * step), false, true, 1e10, Vec2::Zero(), {}}};
  model.linings = {ring_lining(hole, 0)};
  model.stages = {stage_of(static_integrator(), 10, 3)};
  return model;
}

// Thrust and moment of a thin ring without slip in an elastic annulus: constant parts, and factors of cos(2 phi).
struct RingForces {
  double thrust_0 = 0, thrust_2 = 0, moment_2 = 0;  // N and N m per m; thrust positive in compression

  [[nodiscard]] double thrust(double phi) const { return thrust_0 + thrust_2 * std::cos(2 * phi); }
  [[nodiscard]] double moment(double phi) const { return moment_2 * std::cos(2 * phi); }
};

// The rock's stresses are those of Michell's stress function (A r^2 + B r^4 + C/r^2 + D) cos(2 phi), and Lame's; the
// ring's displacements w cos(2 phi) outwards and v sin(2 phi) along are those of the wall, and its equilibrium follows
// from the energy E A ((w + v')/a)^2/2 + E I ((v' - w'')/a^2)^2/2 of each length of it. (H. H. Einstein & C. W.
// Schwartz 1979, Simplified analysis for tunnel supports, give the same for a hole in an infinite plane.)
inline RingForces ring_in_annulus(const LinedHole& hole) {
  const Material rock = rock_around_hole();
  const double nu = rock.poisson;
  const double shear = rock.young / (2 * (1 + nu));
  const double a = hole.radius;
  const double b = hole.outer_radius;
  const double modulus = hole.lining_young / (1 - hole.lining_poisson * hole.lining_poisson);
  const double axial = modulus * hole.thickness;
  const double bending = modulus * std::pow(hole.thickness, 3) / 12;
  const double mean = (hole.far_stress(0) + hole.far_stress(1)) / 2;
  const double difference = (hole.far_stress(0) - hole.far_stress(1)) / 2;

  // u = p r + q/r, radial stress 2 G (p/(1 - 2 nu) - q/r^2).
  Eigen::Matrix2d even;
  even << 2 * shear / (1 - 2 * nu), -2 * shear / (b * b), 2 * shear / (1 - 2 * nu) - axial / a,
      -2 * shear / (a * a) - axial / (a * a * a);
  const Eigen::Vector2d pq = even.partialPivLu().solve(Eigen::Vector2d(mean, 0));
  RingForces forces;
  forces.thrust_0 = -axial * (pq(0) + pq(1) / (a * a));

  const auto radial = [](double r) { return Eigen::RowVector4d(-2, 0, -6 / std::pow(r, 4), -4 / (r * r)); };
  const auto along = [](double r) { return Eigen::RowVector4d(2, 6 * r * r, -6 / std::pow(r, 4), -2 / (r * r)); };
  const Eigen::RowVector4d w =
      Eigen::RowVector4d(-2 * a, -4 * nu * a * a * a, 2 / (a * a * a), 4 * (1 - nu) / a) / (2 * shear);
  const Eigen::RowVector4d v =
      Eigen::RowVector4d(2 * a, (6 - 4 * nu) * a * a * a, 2 / (a * a * a), -2 * (1 - 2 * nu) / a) / (2 * shear);
  const Eigen::RowVector4d thrust = -axial / a * (w + 2 * v);
  const Eigen::RowVector4d moment = bending / (a * a) * (4 * w + 2 * v);
  Eigen::Matrix4d odd;
  odd << radial(b), along(b), radial(a) + thrust / a - 4 * moment / (a * a),
      along(a) + 2 * thrust / a - 2 * moment / (a * a);
  const Eigen::Vector4d factors = odd.partialPivLu().solve(Eigen::Vector4d(difference, -difference, 0, 0));
  forces.thrust_2 = thrust * factors;
  forces.moment_2 = -moment * factors;  // where the ring bends more than it was bent, its free face is pressed
  return forces;
}

}  // namespace dda
