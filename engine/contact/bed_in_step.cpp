#include "engine/contact/bed_in_step.h"

#include "engine/contact/projected_law.h"

namespace dda {
namespace {

// The part of the balance that makes the work of a bed the change of what it stores, as conserving_spring() of one end.
BedAnswer conserving_bed(const Bed& bed, const Vec2& start, const Vec2& gaps) {
  const OpenEnds before = open_ends(bed.lever, start);
  const bool gapes = before.first != before.second;
  if (!gapes && before == open_ends(bed.lever, gaps)) return press_bed(bed, gaps);  // as all the way
  BedAnswer answer = mean_of_bed(bed, start, gaps);
  answer.force = 2 * answer.force - press_bed(bed, start).force;
  answer.slope *= 2;
  answer.coupling *= 2;
  return answer;
}

}  // namespace

BedAnswer answer_of_bed(const InterfaceSprings& springs, const InterfaceTrial& trial, const Vec2& gaps) {
  const Bed bed = bed_of(springs);
  const Vec2 start(trial.start(0), trial.start(2));
  if (trial.rule.conserves_energy) return conserving_bed(bed, start, gaps);
  if (!has_dashpots(springs, trial)) return press_bed(bed, gaps);
  const double ahead = springs.dashpot(0) * trial.rule.dashpot_rate / springs.stiffness(0);
  const bool was_open = press_bed(bed, start).force.isZero(0);
  BedAnswer answer = press_bed(bed, was_open ? Vec2((1 + ahead) * gaps) : Vec2(gaps + ahead * (gaps - start)));
  answer.slope *= 1 + ahead;
  answer.coupling *= 1 + ahead;
  return answer;
}

}  // namespace dda
