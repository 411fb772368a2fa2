#include "engine/contact/no_tension_bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

// n, h and dn/da of the header, for bed K = 1.
struct Share {
  double force, stored, slope;
};

// What n is above the column's, as x (1 - x)^2 (1 - q x^3) of the closed part x = a/a0, for a0 = spread_rise = 1.
Share above_column(double bend, double x) {
  const double q = 14 * (5 - 2 * bend) / (8 - 5 * bend);
  const double rest = 1 - x;
  const double cube = x * x * x;
  const double whole = x * x * (1 / 2.0 - x * (2 / 3.0 - x / 4)) - q * x * x * cube * (1 / 5.0 - x * (1 / 3.0 - x / 7));
  const double first = cube * (1 / 3.0 - x * (1 / 2.0 - x / 5)) - q * cube * cube * (1 / 6.0 - x * (2 / 7.0 - x / 8));
  return {x * rest * rest * (1 - q * cube), 2 * (whole - bend * first),
          rest * ((1 - 3 * x) * (1 - q * cube) - 3 * q * cube * rest)};
}

Share share_of(double bed, double spread, double closed) {
  const double bend = 1 - bed;
  const double square = closed * closed;
  Share share{square, square * closed * (4 - 3 * bend * closed) / 6, 2 * closed};
  if (closed >= spread) return share;
  const Share more = above_column(bend * spread, closed / spread);
  const double scale = spread_rise * spread;
  share.force += scale * spread * more.force;
  share.stored += scale * spread * spread * more.stored;
  share.slope += scale * more.slope;
  return share;
}

// The closed part at this ratio of mean and turn, and the root of the header's equation for it: -1/2 over its slope.
struct Closed {
  double share, root;
};

Closed closed_at(double bed, double ratio) {
  const double root = std::sqrt(1 - (1 - bed) * (1 - ratio));
  return {(1 - ratio) / (1 + root), root};
}

Resultants pressed_in_part(const Bed& of, const Opening& opening) {
  const double bed = bed_of(of.lever);
  const double turn = std::abs(opening.turn);
  const double side = std::copysign(1, opening.turn);
  const double ratio = opening.mean / turn;
  const auto [closed, root] = closed_at(bed, ratio);
  const Share share = share_of(bed, of.spread, closed);
  const double unit = bed * 2 * of.stiffness;
  const double slope = share.slope / (2 * root);  // dn/du
  const double moment = 2 * share.stored + ratio * share.force;
  return {-unit * turn * share.force, side * unit * turn * moment, unit * slope,
          -side * unit * (share.force + ratio * slope), unit * (moment + ratio * (share.force + ratio * slope))};
}

// G/|T| at which so much is closed.
double ratio_at(double bed, double closed) { return 1 - closed * (2 - (1 - bed) * closed); }

// Gauss and Legendre's twelve places on a way of length 1.
struct PlaceOfQuadrature {
  double place, weight;
};
constexpr std::array<PlaceOfQuadrature, 12> quadrature{{
    {0.0092196828766403782, 0.023587668193255917},
    {0.047941371814762601, 0.053469662997659088},
    {0.11504866290284765, 0.080039164271673166},
    {0.20634102285669126, 0.10158371336153292},
    {0.31608425050090994, 0.11674626826917739},
    {0.43738329574426554, 0.12457352290670144},
    {0.56261670425573451, 0.12457352290670144},
    {0.68391574949909006, 0.11674626826917739},
    {0.79365897714330869, 0.10158371336153292},
    {0.88495133709715235, 0.080039164271673166},
    {0.95205862818523745, 0.053469662997659088},
    {0.99078031712335957, 0.023587668193255917},
}};

// Where the formula of the answer changes on a straight way of the gaps, as shares of the way: where the bed closes or
// opens, and where the closed part begins to spread its load.
class WayOverBed {
 public:
  WayOverBed(const Bed& of, const Opening& from, const Opening& to) {
    const double bed = bed_of(of.lever);
    add(from.turn, to.turn);
    for (const double ratio : {-bed, 1.0, ratio_at(bed, of.spread)})
      for (const double side : {ratio, -ratio}) add(from.mean - side * from.turn, to.mean - side * to.turn);
    grade(from, to);
    corners_[count_++] = 1;
    std::sort(corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(count_));
  }
  [[nodiscard]] std::size_t pieces() const { return count_; }
  [[nodiscard]] double corner(std::size_t i) const { return corners_[i]; }

 private:
  // A number that goes from one value to the other vanishes there.
  void add(double from, double to) {
    if ((from < 0) != (to < 0) && from != to) corners_[count_++] = std::clamp(from / (from - to), 0.0, 1.0);
  }

  // Near the gaps where nothing is left of the force its slopes change the faster the nearer the way passes: pieces are
  // shorter there.
  void grade(const Opening& from, const Opening& to) {
    const double mean = to.mean - from.mean, turn = to.turn - from.turn;
    const double square = mean * mean + turn * turn;
    if (square == 0) return;
    const double nearest = -(from.mean * mean + from.turn * turn) / square;
    const double distance = std::abs(from.mean * turn - from.turn * mean) / square;
    for (const double times : {-16.0, -4.0, -1.0, 0.0, 1.0, 4.0, 16.0}) {
      const double share = nearest + times * distance;
      if (share > 0 && share < 1) corners_[count_++] = share;
    }
  }

  std::array<double, 16> corners_{0};
  std::size_t count_ = 1;
};

// How far from the middle these forces of the points press, in half lengths, |M|/|N|.
double arm_of(double lever, const Vec2& force, double normal) { return lever * std::abs(force(1) - force(0)) / normal; }

// The closed part under a force with such an arm: (1 - arm) 3/2 in a column, all of it where the arm is a third or
// less. A stiffer bed has no closed form; the arm falls as more is closed, since the potential is convex.
double closed_under(const Bed& of, double arm) {
  const double column = 1.5 * (1 - arm);
  if (column >= of.spread) return column;
  const double bed = bed_of(of.lever);
  double low = 0, high = of.spread;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    const Share share = share_of(bed, of.spread, middle);
    (2 * share.stored + ratio_at(bed, middle) * share.force > arm * share.force ? low : high) = middle;
  }
  return high;
}

}  // namespace

BedAnswer press_bed(const Bed& bed, const Vec2& gaps) {
  const Opening opening = opening_of(bed.lever, gaps);
  // One that just touches at both points is closed: what is stacked without force would else have nothing to stand on
  // in the first pass of its first step, and lose digits on the way back from where that takes it.
  if (is_closed(opening, bed_of(bed.lever))) return {bed.stiffness * gaps, Vec2::Constant(bed.stiffness), 0};
  if (is_open(opening)) return {Vec2::Zero(), Vec2::Zero(), 0};
  const Resultants sum = pressed_in_part(bed, opening);
  const double by_turn = sum.by_turn / (bed.lever * bed.lever);
  const double mixed = 2 * sum.mixed / bed.lever;
  const double pair = sum.moment / bed.lever;
  return {Vec2(sum.normal - pair, sum.normal + pair) / 2,
          Vec2(sum.by_mean - mixed + by_turn, sum.by_mean + mixed + by_turn) / 4, (sum.by_mean - by_turn) / 4};
}

BedAnswer mean_of_bed(const Bed& bed, const Vec2& from, const Vec2& to) {
  BedAnswer mean{Vec2::Zero(), Vec2::Zero(), 0};
  const WayOverBed way(bed, opening_of(bed.lever, from), opening_of(bed.lever, to));
  for (std::size_t i = 0; i + 1 < way.pieces(); ++i) {
    const double start = way.corner(i), length = way.corner(i + 1) - start;
    for (const PlaceOfQuadrature& point : quadrature) {
      const double share = start + length * point.place, weight = length * point.weight;
      const BedAnswer there = press_bed(bed, from + share * (to - from));
      mean.force += weight * there.force;
      mean.slope += weight * share * there.slope;
      mean.coupling += weight * share * there.coupling;
    }
  }
  return mean;
}

Vec2 gaps_of_bed(const Bed& of, const Vec2& force) {
  const double normal = -force.sum();
  const double closed = closed_under(of, arm_of(of.lever, force, normal));
  if (closed >= 1) return force / of.stiffness;
  const double bed = bed_of(of.lever);
  const double turn = normal / (2 * bed * of.stiffness * share_of(bed, of.spread, closed).force);
  const double mean = turn * ratio_at(bed, closed);
  const double half = std::copysign(of.lever * turn, force(1) - force(0));
  return {mean - half, mean + half};
}

OpenEnds open_ends(double lever, const Vec2& gaps) {
  const Opening opening = opening_of(lever, gaps);
  if (is_closed(opening, bed_of(lever))) return {false, false};
  if (is_open(opening)) return {true, true};
  return {opening.turn<0, opening.turn> 0};
}

double closed_share(double lever, const Vec2& force) {
  const double normal = -force.sum();
  if (normal <= 0) return 0;
  return std::clamp(1.5 * (1 - arm_of(lever, force, normal)), 0.0, 1.0);
}

Vec2 closed_share_by_gaps(double lever, const Vec2& force, const Mat2& by_gaps) {
  const double normal = -force.sum();
  if (normal <= 0) return Vec2::Zero();
  const double arm = arm_of(lever, force, normal);
  if (arm <= 1 / 3.0 || arm >= 1) return Vec2::Zero();
  const Vec2 difference = by_gaps.row(1) - by_gaps.row(0), sum = by_gaps.colwise().sum();
  return -1.5 / normal * (std::copysign(lever, force(1) - force(0)) * difference + arm * sum);
}

double deepest_end(double lever, const Vec2& gaps) {
  const Opening opening = opening_of(lever, gaps);
  return std::abs(opening.turn) - opening.mean;
}

}  // namespace dda
