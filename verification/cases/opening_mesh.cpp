#include "verification/cases/opening_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/builder/free_outline.h"
#include "verification/cases/cavity_mesh.h"
#include "verification/exact/kirsch.h"

namespace verify {
namespace {

// Kirsch's stress as xx, yy, xy.
dda::Vec3 stress_at(const dda::Vec2& at, const FarStress& far) {
  const double angle = std::atan2(at.y(), at.x());
  const exact::PolarStress s = exact::kirsch(far.xx, far.yy, 1 / at.norm(), angle);
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return {c * c * s.radial + n * n * s.hoop - 2 * c * n * s.shear,
          n * n * s.radial + c * c * s.hoop + 2 * c * n * s.shear,
          c * n * (s.radial - s.hoop) + (c * c - n * n) * s.shear};
}

template <typename StressAt>
void press_outside(dda::Model& model, const StressAt& stress) {
  for (const dda::Stretch& s : dda::outer_rings(dda::free_rings(model)))
    model.edge_loads.push_back(
        {s.block, s.from, s.to, dda::traction_on(stress((s.from + s.to) / 2), -s.inward), dda::Constant{}});
}

}  // namespace

double FarStress::size() const { return std::max(std::abs(xx), std::abs(yy)); }

void hold_outside(dda::Model& model, const FarStress& far) {
  press_outside(model, [&](const dda::Vec2& at) { return stress_at(at, far); });
}

void hold_outside(dda::Model& model, const dda::Vec3& stress) {
  press_outside(model, [&](const dda::Vec2&) { return stress; });
}

dda::Model opened(int sectors, const FarStress& far) {
  dda::Model model = ring_mesh(sectors, 6);
  for (dda::Block& block : model.blocks) block.initial_stress = {far.xx, far.yy, 0};
  hold_outside(model, far);
  return model;
}

// The corners of the opening are those of the first ring that lie nearest.
dda::Model filled(int sectors, double outer_radius) {
  dda::Model model = ring_mesh(sectors, outer_radius);
  dda::Block core;
  core.name = "core";
  for (int i = 0; i < sectors; ++i) {
    const dda::Ring& ring = model.blocks[static_cast<std::size_t>(i)].shape.outer;
    const double direction = 2 * std::numbers::pi * (i - 0.5) / sectors;
    const dda::Vec2 corner(std::cos(direction), std::sin(direction));
    core.shape.outer.push_back(
        *std::ranges::min_element(ring, {}, [&](const dda::Vec2& each) { return (each - corner).norm(); }));
  }
  model.blocks.push_back(core);
  dda::finish_model(model);
  return model;
}

double mean_error(const dda::Simulation& simulation, const FarStress& far) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < simulation.model().blocks.size(); ++i) {
    const dda::Vec2 at = simulation.model().blocks[i].moments.centroid;
    if (at.norm() < 1.2 || at.norm() > 4) continue;
    sum += (simulation.state().stress[i] - stress_at(at, far)).squaredNorm();
    count += 3;
  }
  return std::sqrt(sum / count) / far.size();
}

double at_wall(const dda::Model& model, std::size_t sectors, const std::array<double, 3>& values) {
  const auto radius = [&](std::size_t ring) { return model.blocks[ring * sectors].moments.centroid.norm(); };
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < 3; ++j)
      if (j != i) weight *= (1 - radius(j)) / (radius(i) - radius(j));
    sum += weight * values[i];
  }
  return sum;
}

double wall_stress(const dda::Simulation& simulation, std::size_t sectors) {
  const std::vector<dda::Vec3>& stress = simulation.state().stress;
  return at_wall(simulation.model(), sectors, {stress[0][1], stress[sectors][1], stress[2 * sectors][1]});
}

}  // namespace verify
