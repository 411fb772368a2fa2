// A way to the answer of a step that does not depend on how many contacts change: an interior-point method.
//
// With friction capacities given a step minimizes a convex, piecewise quadratic function (convex_passes.h). Newton's
// method on its pieces is stopped at every contact that closes, and a rock of some hundred blocks takes hundreds of
// passes. Here no contact is on a piece before the end. With gaps of an end g (normal) and u (tangential, slip of the
// step included), springs k and capacity c,
//   normal:      pressure f > 0, opening s > 0,    g + f/k = s,             f s = mu
//   tangential:  -c < t < c, slips z, y > 0,       u - t/k = z - y,         z (c - t) = mu,  y (c + t) = mu
// which for mu = 0 are what the ends answer. A pass is a step of Newton's method on balance and products, predicted and
// corrected (Mehrotra 1992), with mu falling from pass to pass; f, t, s, z and y are eliminated end by end, so that its
// matrix is that of every other pass with rows active by shares between 0 and 1. What is left is near enough for the
// quick passes to end. Where capacities follow the pressures there is no potential, and no proof; the same passes take
// that in as well (interior_friction.h), and mostly arrive. A projected stretch on its bed has two normal rows, of its
// ends, that know of each other (bed_ends.h).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "engine/core/status.h"
#include "engine/solve/contact_rows.h"
#include "engine/solve/interior_friction.h"
#include "engine/solve/interior_rows.h"
#include "engine/solve/iterate.h"

namespace dda {

class InteriorPasses {
 public:
  // False where some contact or bolt answers otherwise than above, or the linear solver does not factor.
  [[nodiscard]] static bool serve(const Iterate& at);

  // Begins at rest. False where nothing moves.
  [[nodiscard]] bool begin(Iterate& at);
  // Goes on from where it stands until forces are off what the ends answer by no more than this share of the largest,
  // then moves the iterate there. False where that is not reached.
  [[nodiscard]] bool approach(Iterate& at, double share_off);

 private:
  void list_rows(const Iterate& at);
  void start_at_rest(const Iterate& at);
  [[nodiscard]] double start_products(Iterate& at);
  [[nodiscard]] double take_answers(const Iterate& at);
  static void move_inside(double product, double gap, InteriorRow& row);
  void take_forces_of_rows(const Iterate& at);
  void measure(const Iterate& at);
  [[nodiscard]] double off_answers(const Iterate& at) const;
  [[nodiscard]] double mean_product(double share) const;
  [[nodiscard]] Status factorize(Iterate& at);
  void take_shares(const Iterate& at);
  [[nodiscard]] double find_step(Iterate& at);
  [[nodiscard]] Status solve(Iterate& at, double product, bool corrects);
  static void eliminate_lengths(double gap, double product, bool corrects, InteriorRow& row);
  static void follow(double along, InteriorRow& row);
  [[nodiscard]] double longest_step() const;
  void move(double share);

  // interior_beds.cpp
  void list_beds();
  [[nodiscard]] double take_answer_of_bed(const InterfaceSprings& springs, InteriorBed& ends);
  void move_beds_inside(const Iterate& at, double product);
  [[nodiscard]] Vec2 openings_of(const Iterate& at, const InteriorBed& ends) const;
  void take_forces_of_beds(const Iterate& at);
  [[nodiscard]] double beds_off_answers(const Iterate& at) const;
  void take_rows_of_beds();
  void take_stiffness_of_beds(const Iterate& at);
  void eliminate_beds(const Iterate& at, double product, bool corrects);
  void follow_beds(const Iterate& at);

  InteriorFriction friction_;
  std::vector<InteriorRow> rows_;
  std::vector<InteriorBed> beds_;
  std::vector<Vec4> gaps_;           // m, of all contacts
  std::vector<ContactRows> active_;  // of all contacts, as the matrix sees them
  std::vector<Vec4> forces_;         // N per m of thickness: of linear rows, and of all others by their rows
  Eigen::VectorXd increment_, rhs_, step_, image_;
  double imbalance_ = 0;  // largest entry of what the balance leaves
  int passes_left_ = 0;
  int short_steps_ = 0;  // one after the other, up to now
};

}  // namespace dda
