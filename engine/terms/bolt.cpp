#include "engine/terms/bolt.h"

namespace dda {

BoltRows bolt_rows(const Vec2& direction, const Vec2& arm_a, const Vec2& arm_b) {
  Mat2 axes;
  axes << direction.x(), direction.y(), -direction.y(), direction.x();
  return {-axes * displacement_rows(arm_a), axes * displacement_rows(arm_b)};
}

BoltAnswer bolt_answer(const BoltLaw& law, const Vec2& gap) {
  BoltAnswer answer{law.stiffness.cwiseProduct(gap), Vec2::Ones()};
  for (Eigen::Index i = 0; i < 2; ++i) {
    // What is neither slack nor taut is taken to carry: a block that hangs on such bolts alone would else have nothing.
    if (answer.force(i) >= law.least(i) && answer.force(i) < law.most(i)) continue;
    if (law.stiffness(i) == 0) continue;
    answer.force(i) = answer.force(i) >= law.most(i) ? law.most(i) : law.least(i);
    answer.active(i) = 0;
  }
  return answer;
}

Vec2 elastic_part(const BoltLaw& law, const Vec2& gap) {
  Vec2 elastic = gap;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double stuck = law.stiffness(i) * gap(i);
    if (stuck > law.most(i)) elastic(i) = law.most(i) / law.stiffness(i);
    if (stuck < law.least(i) && law.least(i) < 0) elastic(i) = law.least(i) / law.stiffness(i);
  }
  return elastic;
}

double bolt_energy(const BoltLaw& law, const Vec2& force) {
  double energy = 0;
  for (Eigen::Index i = 0; i < 2; ++i)
    if (law.stiffness(i) > 0) energy += force(i) * force(i) / (2 * law.stiffness(i));
  return energy;
}

}  // namespace dda
