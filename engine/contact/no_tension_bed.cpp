#include "engine/contact/no_tension_bed.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

// The gaps as their mean and half of the difference of those at the ends.
struct Opening {
  double mean, turn;
};

Opening opening_of(double lever, const Vec2& gaps) {
  return {(gaps(0) + gaps(1)) / 2, (gaps(1) - gaps(0)) / (2 * lever)};
}

double bed_of(double lever) { return 3 * lever * lever; }

bool is_closed(const Opening& opening, double bed) { return opening.mean <= -bed * std::abs(opening.turn); }

bool is_open(const Opening& opening) { return opening.mean >= std::abs(opening.turn); }

// Normal force and moment, and their slopes by mean and turn: N by mean, N by turn (which is M by mean), M by turn.
struct Resultants {
  double normal, moment;
  double by_mean, mixed, by_turn;
};

Resultants pressed_in_part(double whole, double bed, const Opening& opening) {
  const double turn = std::abs(opening.turn);
  const double side = std::copysign(1, opening.turn);
  const double ratio = opening.mean / turn;
  const double root = std::sqrt(1 - (1 - bed) * (1 - ratio));
  const double closed = (1 - ratio) / (1 + root);  // of the length
  const double unit = bed * whole;
  const double moment = closed * closed * (1 - 2 * closed / 3);
  return {-unit * turn * closed * closed, side * unit * turn * moment, unit * closed / root,
          -side * unit * closed * (1 - closed) / root, unit * (moment + closed * (1 - closed) * ratio / root)};
}

}  // namespace

BedAnswer press_bed(double stiffness, double lever, const Vec2& gaps) {
  const Opening opening = opening_of(lever, gaps);
  // One that just touches at both points is closed: what is stacked without force would else have nothing to stand on
  // in the first pass of its first step, and lose digits on the way back from where that takes it.
  if (is_closed(opening, bed_of(lever))) return {stiffness * gaps, Vec2::Constant(stiffness), 0};
  if (is_open(opening)) return {Vec2::Zero(), Vec2::Zero(), 0};
  const Resultants sum = pressed_in_part(2 * stiffness, bed_of(lever), opening);
  const double by_turn = sum.by_turn / (lever * lever);
  const double mixed = 2 * sum.mixed / lever;
  return {Vec2(sum.normal - sum.moment / lever, sum.normal + sum.moment / lever) / 2,
          Vec2(sum.by_mean - mixed + by_turn, sum.by_mean + mixed + by_turn) / 4, (sum.by_mean - by_turn) / 4};
}

OpenEnds open_ends(double lever, const Vec2& gaps) {
  const Opening opening = opening_of(lever, gaps);
  if (is_closed(opening, bed_of(lever))) return {false, false};
  if (is_open(opening)) return {true, true};
  return {opening.turn<0, opening.turn> 0};
}

double deepest_end(double lever, const Vec2& gaps) {
  const Opening opening = opening_of(lever, gaps);
  return std::abs(opening.turn) - opening.mean;
}

}  // namespace dda
