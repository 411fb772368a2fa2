// The links of rock bolts in the course of a step's iteration, with the verbs of InterfaceTrials. Links answer as
// contacts do, but with bounds that do not depend on other forces.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"
#include "engine/solve/line_search.h"
#include "engine/terms/bolt.h"

namespace dda {

// A link of a bolt between steps: along and across it.
struct LinkState {
  Vec2 gap = Vec2::Zero();      // m, elastic, with what stands for the pretension
  Vec2 plastic = Vec2::Zero();  // m, since it was put in
  Vec2 force = Vec2::Zero();    // N per m of thickness; tension positive
  bool ruptured = false;
  bool waits = false;  // its bolt is put in at the start of a later stage: it carries nothing

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [gap, plastic, force, ruptured, waits] = self;
    archive(gap, plastic, force, ruptured, waits);
  }
};

struct LinkElement {
  int block_a = 0, block_b = 0;
  BoltLaw law;
  double rupture_elongation = 0;
  double pretension_gap = 0;  // m
  Vec2 start = Vec2::Zero();  // m, by how much the anchors had parted when it was put in
  double span = 0;            // m, between the anchors, where the rows were taken; 0: it turns with its blocks
  BoltRows rows;
  LinkState state;

  [[nodiscard]] bool carries_nothing() const { return state.ruptured || state.waits; }

  // Since it was put in, elastic and plastic, m, where the elastic gap is `gap`.
  [[nodiscard]] double elongation(const Vec2& gap) const { return gap(0) + state.plastic(0) - pretension_gap; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, law, rupture_elongation, pretension_gap, start, span, rows, state] = self;
    archive(start, span, rows.a, rows.b, state);  // the others are the model's
  }
};

// Adds a spring along the link and one across it, N/m per m of thickness.
void add_link(const LinkElement& link, const Vec2& stiffness, BlockMatrix& matrix);

BoltAnswer answer_of(const BoltLaw& law, const Vec2& gap, bool ruptured);

// A link at a trial gap.
struct LinkTrial {
  Vec2 gap = Vec2::Zero(), direction = Vec2::Zero(), force = Vec2::Zero(), active = Vec2::Ones();
  bool ruptures = false;
};

class BoltTrials {
 public:
  void start(std::span<const LinkElement> links);
  void look_at(std::span<const LinkElement> links) { links_ = links; }
  // Back to the start of the step, but for what broke since.
  void restart();

  [[nodiscard]] bool empty() const { return trials_.empty(); }
  [[nodiscard]] const LinkTrial& operator[](std::size_t k) const { return trials_[k]; }

  [[nodiscard]] bool rows_are_stale() const;  // take_up_rows() would change some
  [[nodiscard]] bool take_up_rows();
  void add_stiffness(double factor, BlockMatrix& matrix) const;
  void add_rhs(double factor, Eigen::VectorXd& rhs) const;

  void aim(const Eigen::VectorXd& newton_step);
  [[nodiscard]] double mismatch() const;
  [[nodiscard]] double largest_force() const;
  void take_out(double factor, LineSlope& line) const;
  void add_slope(double factor, double t, double& slope) const;
  void follow(double share);

  // Links beyond their rupture elongation break; appends their indices.
  void break_links(std::vector<int>& broken);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [links, trials, matrix_rows] = self;
    archive(matrix_rows);  // the others begin with every step
  }

 private:
  void respond(std::size_t k);

  std::span<const LinkElement> links_;
  std::vector<LinkTrial> trials_;
  std::vector<Vec2> matrix_rows_;  // active rows whose stiffness the matrix holds
};

}  // namespace dda
