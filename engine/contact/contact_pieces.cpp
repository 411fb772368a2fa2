#include "engine/contact/contact_pieces.h"

#include <cmath>
#include <cstddef>

#include "engine/contact/bond_strength.h"
#include "engine/contact/end_answer.h"
#include "engine/contact/open_close.h"
#include "engine/contact/projected_law.h"

namespace dda {
namespace {

// The piece that an end passes through from one on the way to another: open - sliding - stuck - sliding the other way.
ContactPiece piece_between(ContactPiece from, ContactPiece to, double slide) {
  if (slides(from) && slides(to)) return from == to ? to : ContactPiece::stuck;
  const bool open_and_stuck = (from == ContactPiece::open && to == ContactPiece::stuck) ||
                              (from == ContactPiece::stuck && to == ContactPiece::open);
  if (!open_and_stuck) return to;
  return slide < 0 ? ContactPiece::slides_back : ContactPiece::slides_forth;
}

// True where ends have no dashpots, press each for itself, and have the friction that sliding ends have, as lay_on
// makes them slide.
bool has_linear_pieces(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  return springs.law == InterfaceLaw::classical && !trial.rule.sticks && !trial.rule.conserves_energy &&
         springs.dashpot.isZero(0) && trial.hardening[0] == 0 && trial.hardening[1] == 0;
}

// The shear force at which the end slides, N per m of thickness, under the normal force that the trial has.
double sliding_shear(const EndStrength& strength, int end, const InterfaceTrial& trial) {
  const auto e = static_cast<std::size_t>(end);
  if (trial.rule.capacity_is_given) return trial.capacity[e];
  const double cohesion = trial.residual[e] ? strength.residual_cohesion : 0;
  return cohesion - strength.friction_now(trial.residual[e]) * trial.force(2 * end);
}

// What an end that is laid on a piece presses with, pulling where that is what the piece goes on to. Means go on to
// nothing.
end_answer::Answer pressed_on_piece(const InterfaceSprings& springs, const InterfaceTrial& trial, int end) {
  const Eigen::Index n = 2 * end;
  const double gap = trial.normal_gap(end);
  if (!trial.rule.conserves_energy) return {springs.stiffness(n) * gap, 1};
  return end_answer::press(trial.rule, end_answer::row_of(springs, trial, n), gap);
}

// Forces and slopes as if the end were on that piece. Where pieces are not linear, of ends that touch and only to
// stick.
void lay_on(ContactPiece piece, const InterfaceSprings& springs, const EndStrength& strength, int end,
            InterfaceTrial& trial) {
  const Eigen::Index n = 2 * end;
  if (piece == ContactPiece::open) {
    trial.force.segment<2>(n).setZero();
    trial.active.segment<2>(n).setZero();
    return;
  }
  if (trial.active(n) == 0 || piece != ContactPiece::stuck || strength.dilation > 0) {
    trial.dilation[static_cast<std::size_t>(end)] = -trial.owed[static_cast<std::size_t>(end)];
    const end_answer::Answer pressed = pressed_on_piece(springs, trial, end);
    trial.force(n) = pressed.force;
    trial.active(n) = pressed.slope;
  }
  if (piece == ContactPiece::stuck) {
    if (ends_of(springs) == 1) trial.coupling = 0;
    respond_as_stuck(springs, end, trial);
    return;
  }
  trial.force(n + 1) = direction_of(piece) * sliding_shear(strength, end, trial);
  trial.active(n + 1) = 0;
}

// How both normal forces (rows) follow both normal gaps (columns), N/m per m of thickness.
Mat2 normal_slopes(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  Mat2 slopes = Mat2::Constant(trial.coupling);
  slopes(0, 0) = trial.active(0) * springs.stiffness(0);
  slopes(1, 1) = trial.active(2) * springs.stiffness(2);
  return slopes;
}

// How the capacity of an end follows both normal gaps, N/m per m of thickness.
Vec2 capacity_by_gaps(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                      int end) {
  const Mat2 by_gaps = normal_slopes(springs, trial);
  if (springs.law == InterfaceLaw::projected) return stretch_capacity_by_gaps(springs, strength, trial, by_gaps, end);
  return -strength.friction_now(trial.residual[static_cast<std::size_t>(end)]) * by_gaps.row(end);
}

// By how much forces differ at an end.
double difference(const InterfaceTrial& one, const InterfaceTrial& other, int end) {
  return (one.force - other.force).segment<2>(2 * end).cwiseAbs().maxCoeff();
}

}  // namespace

ContactPieces pieces_of(const InterfaceTrial& trial) {
  ContactPieces pieces{ContactPiece::stuck, ContactPiece::stuck};
  for (int end = 0; end < 2; ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = 2 * end;
    if (!trial.broken[e]) continue;
    const bool has_no_shear = trial.capacity[e] == 0 && trial.active(n + 1) == 0;
    if (trial.active(n) == 0 || has_no_shear) {
      pieces[e] = ContactPiece::open;
    } else if (trial.active(n + 1) < 1) {
      pieces[e] = std::signbit(trial.force(n + 1) + trial.before(n + 1)) ? ContactPiece::slides_back
                                                                         : ContactPiece::slides_forth;
    }
  }
  return pieces;
}

bool keep_to_bordering_pieces(const InterfaceSprings& springs, const EndStrength& strength, const PieceRule& rule,
                              InterfaceTrial& trial, ContactPieces& pieces) {
  const ContactPieces before = pieces;
  pieces = pieces_of(trial);
  if (pieces == before) return false;
  const bool linear = has_linear_pieces(springs, trial);
  bool kept = false;
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (pieces[e] == before[e]) continue;
    const auto laid_on = [&](ContactPiece piece) {
      InterfaceTrial laid = trial;
      lay_on(piece, springs, strength, end, laid);
      return laid;
    };
    if (linear) {
      const InterfaceTrial as_before = laid_on(before[e]);
      if (difference(as_before, trial, end) <= rule.negligible_force) {
        trial = as_before;
        pieces[e] = before[e];
        continue;
      }
    }
    const ContactPiece between = piece_between(before[e], pieces[e], trial.gap(2 * end + 1));
    const bool is_above_ground = strength.dilation > 0 && trial.gap(2 * end) >= 0;  // stuck, it would be open
    if (between == pieces[e] || is_above_ground || (between != ContactPiece::stuck && !(rule.strict && linear)))
      continue;
    const InterfaceTrial laid = laid_on(between);
    if (difference(laid, trial, end) > rule.negligible_force) kept = true;
    trial = laid;
    pieces[e] = between;
  }
  return kept;
}

bool stay_on_pieces(const InterfaceSprings& springs, const EndStrength& strength, const PieceRule& rule,
                    InterfaceTrial& trial, ContactPieces& pieces) {
  if (!has_linear_pieces(springs, trial)) {
    pieces = pieces_of(trial);
    return false;
  }
  respond_with_friction(springs, strength, trial);
  bool differs = false;
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    if (!trial.broken[e]) continue;
    const InterfaceTrial answer = trial;
    lay_on(pieces[e], springs, strength, end, trial);
    differs = differs || difference(answer, trial, end) > rule.negligible_force;
  }
  return differs;
}

Mat2 shear_by_normal_gap(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                         const ContactPieces& pieces) {
  Mat2 slopes = Mat2::Zero();
  if (trial.rule.capacity_is_given) return slopes;
  for (int end = 0; end < ends_of(springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const Eigen::Index n = 2 * end;
    if (!slides(pieces[e]) || trial.rule.sticks || trial.active(n + 1) != 0) continue;
    slopes.row(end) = direction_of(pieces[e]) * capacity_by_gaps(springs, strength, trial, end).transpose();
  }
  return slopes;
}

}  // namespace dda
