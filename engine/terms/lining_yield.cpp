#include "engine/terms/lining_yield.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

// The trial force moved by `flow` (the plastic multiplier) towards the set.
struct Returned {
  double axial = 0, moment = 0, double_shear = 0;  // N, |M| and |Q|
  double slope = 0;                                // of P at N
  double divisor = 1;                              // dN = dN_trial/divisor at a given flow
  double excess = 0;                               // |M| + |Q|/2 - P(N)
};

Returned returned(const LiningStrength& strength, const Vec3& stiffness, const Vec3& trial, double flow) {
  const double curve = strength.thickness / (2 * (strength.crushing + strength.tearing));  // -P''/2
  const double centre = strength.tearing - strength.crushing;                              // twice the N of largest P
  Returned at;
  at.divisor = 1 + 2 * curve * flow * stiffness(0);
  at.axial = (trial(0) + flow * stiffness(0) * curve * centre) / at.divisor;
  at.slope = curve * (centre - 2 * at.axial);
  at.moment = std::max(0.0, std::abs(trial(1)) - flow * stiffness(1));
  at.double_shear = std::max(0.0, std::abs(trial(2)) - flow * stiffness(2) / 2);
  at.excess = at.moment + at.double_shear / 2 - plastic_moment(strength, at.axial);
  return at;
}

// By how much the excess falls with the flow.
double fall(const Vec3& stiffness, const Returned& at) {
  return (at.moment > 0 ? stiffness(1) : 0) + (at.double_shear > 0 ? stiffness(2) / 4 : 0) +
         stiffness(0) * at.slope * at.slope / at.divisor;
}

// The flow at which the excess, which falls with it, is gone: Newton's method kept inside of a bracket.
double flow_of(const LiningStrength& strength, const Vec3& stiffness, const Vec3& trial) {
  constexpr int most_rounds = 200;  // Newton's method takes five, halving alone 60 from the first bracket
  const Returned start = returned(strength, stiffness, trial, 0);
  double low = 0;
  double high = start.excess / fall(stiffness, start);
  while (returned(strength, stiffness, trial, high).excess > 0) high *= 2;
  double flow = high;
  for (int round = 0; round < most_rounds; ++round) {
    const Returned at = returned(strength, stiffness, trial, flow);
    (at.excess > 0 ? low : high) = flow;
    const double newton = flow + at.excess / fall(stiffness, at);
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (std::abs(next - flow) <= 1e-15 * high || next == low || next == high) break;
    flow = next;
  }
  return flow;
}

double with_sign(double magnitude, double of) { return of < 0 ? -magnitude : magnitude; }

}  // namespace

// With a factor s, s (|M| + |Q|/2) = P(s N) is a quadratic equation, in which a single strength can leave no tension.
double utilisation(const LiningStrength& strength, const Vec3& force) {
  const double curve = strength.thickness / (2 * (strength.crushing + strength.tearing));
  const double moment = std::abs(force(1)) + std::abs(force(2)) / 2;
  const double square = curve * force(0) * force(0);
  const double linear = moment - curve * force(0) * (strength.tearing - strength.crushing);
  const double constant = curve * strength.crushing * strength.tearing;
  const double root = std::sqrt(linear * linear + 4 * square * constant);
  if (linear <= 0) return root > linear ? 2 * square / (root - linear) : 0;
  return constant > 0 ? (linear + root) / (2 * constant) : 1;  // nothing is carried but what lies on the edge
}

LiningAnswer lining_answer(const LiningStrength& strength, const Vec3& stiffness, const Vec3& gap) {
  const Vec3 trial = stiffness.cwiseProduct(gap);
  if (returned(strength, stiffness, trial, 0).excess <= 0) return {trial, Mat3(stiffness.asDiagonal()), false};
  const Returned at = returned(strength, stiffness, trial, flow_of(strength, stiffness, trial));
  LiningAnswer answer;
  answer.yields = true;
  answer.force = {at.axial, with_sign(at.moment, trial(1)), with_sign(at.double_shear, trial(2))};
  const double bends = at.moment > 0 ? 1 : 0;
  const double shears = at.double_shear > 0 ? 1 : 0;
  const Vec3 normal(-at.slope / at.divisor, with_sign(bends, trial(1)), with_sign(shears, trial(2)) / 2);
  const Vec3 along = stiffness.cwiseProduct(normal);
  const Vec3 kept = stiffness.cwiseProduct(Vec3(1 / at.divisor, bends, shears));
  answer.tangent = Mat3(kept.asDiagonal()) - along * along.transpose() / fall(stiffness, at);
  return answer;
}

}  // namespace dda
