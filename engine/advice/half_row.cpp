#include "engine/advice/half_row.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dda {
namespace {

enum class Layer { none, last, same, next };

Layer layer_of(double distance, double step) {
  if (std::abs(distance) < 1e-6 * step) return Layer::same;
  if (std::abs(distance - step) < 1e-6 * step) return Layer::next;
  if (std::abs(distance + step) < 1e-6 * step) return Layer::last;
  return Layer::none;
}

double least_step(const Lattice& lattice, const Vec2& direction) {
  double step = std::numeric_limits<double>::infinity();
  for (const Vec2& offset : lattice.offsets) {
    const double along = std::abs(offset.dot(direction));
    if (along > 1e-6 * offset.norm()) step = std::min(step, along);
  }
  return step;
}

// T of x_(j+1) = T x_j for waves that decay away from the end: next T^2 + own T + last = 0, by logarithmic reduction
// (Latouche & Ramaswami 1993), which squares what is left of a wave in every round.
ComplexMat6 decaying_step(const ComplexMat6& own, const ComplexMat6& next, const ComplexMat6& last) {
  const Eigen::PartialPivLU<ComplexMat6> solver(own);
  ComplexMat6 up = -solver.solve(next);
  ComplexMat6 down = -solver.solve(last);
  ComplexMat6 step = down;
  ComplexMat6 reach = up;
  for (int i = 0; i < 60; ++i) {
    const ComplexMat6 both = ComplexMat6::Identity() - up * down - down * up;
    const Eigen::PartialPivLU<ComplexMat6> reduced(both);
    const ComplexMat6 up2 = up * up;
    const ComplexMat6 down2 = down * down;
    up = reduced.solve(up2);
    down = reduced.solve(down2);
    const ComplexMat6 more = reach * down;
    step += more;
    reach = reach * up;
    if (!(more.cwiseAbs().maxCoeff() > 1e-15 * step.cwiseAbs().maxCoeff())) break;
  }
  return step;
}

ComplexMat6 power(ComplexMat6 base, int exponent) {
  ComplexMat6 result = ComplexMat6::Identity();
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = result * base;
    base = base * base;
  }
  return result;
}

}  // namespace

std::optional<HalfRow> HalfRow::make(const Lattice& lattice, const Stage& stage, WaveKind kind, const Vec2& direction) {
  const LatticeMatrices whole = lattice_matrices(lattice, stage);
  const Vec2 particles = polarization(kind, direction);
  HalfRow row;
  row.step_ = least_step(lattice, direction);
  row.load_filter_ = whole.load_filter();
  std::vector<bool> present;
  for (const Vec2& offset : lattice.offsets) {
    const Layer layer = layer_of(offset.dot(direction), row.step_);
    if (layer == Layer::none) return std::nullopt;
    present.push_back(layer != Layer::last);
  }
  double area = 0;
  for (const LatticeCoupling& coupling : whole.couplings) {
    const Layer layer = layer_of(coupling.offset.dot(direction), row.step_);
    if (layer == Layer::same) continue;
    if (std::abs(coupling.normal.dot(direction)) < 1 - 1e-6) return std::nullopt;  // a staircase
    if (layer == Layer::last) area += coupling.length;
  }
  const auto add = [&](const LatticeMatrices& matrices, Mat6 Layers::*own) {
    row.stiffness_.*own += matrices.stiffness;
    row.inertia_.*own += matrices.inertia;
    for (const LatticeCoupling& coupling : matrices.couplings) {
      if (layer_of(coupling.offset.dot(direction), row.step_) != Layer::same) continue;
      row.stiffness_.*own += coupling.stiffness;
      row.inertia_.*own += coupling.inertia;
    }
  };
  add(whole, &Layers::own);
  const LatticeMatrices first = lattice_matrices(lattice, stage, present);
  add(first, &Layers::end);
  for (const LatticeCoupling& coupling : whole.couplings) {
    const Layer layer = layer_of(coupling.offset.dot(direction), row.step_);
    if (layer == Layer::same) continue;
    row.stiffness_.*(layer == Layer::next ? &Layers::next : &Layers::last) += coupling.stiffness;
    row.inertia_.*(layer == Layer::next ? &Layers::next : &Layers::last) += coupling.inertia;
    if (layer == Layer::next) continue;
    // A unit traction on the end, and the traction that the layer before exerts, along the wave's motion.
    const double part = coupling.length / area;
    const Vec2 force = coupling.length * particles;
    row.push_ += first.load(coupling.middle, force);
    const Vec2 tangent(-coupling.normal.y(), coupling.normal.x());
    const Vec2 weights(particles.dot(coupling.normal), particles.dot(tangent));
    row.traction_here_ += part * (coupling.traction_here.transpose() * weights);
    row.traction_last_ += part * (coupling.traction_there.transpose() * weights);
  }
  return row;
}

Complex HalfRow::traction(Complex square, int joint) const {
  const auto forces = [&](Mat6 Layers::*part) -> ComplexMat6 {
    return (stiffness_.*part).cast<Complex>() + square * (inertia_.*part).cast<Complex>();
  };
  const ComplexMat6 next = forces(&Layers::next);
  const ComplexMat6 step = decaying_step(forces(&Layers::own), next, forces(&Layers::last));
  const ComplexMat6 end = forces(&Layers::end) + next * step;
  const ComplexVec6 first = end.partialPivLu().solve(push_.cast<Complex>());
  const ComplexVec6 last = power(step, joint - 1) * first;
  const ComplexVec6 here = step * last;
  return traction_here_.cast<Complex>().dot(here) + traction_last_.cast<Complex>().dot(last);
}

}  // namespace dda
