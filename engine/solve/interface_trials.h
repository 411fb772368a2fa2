// The contacts of a step that can open, slide or break, in the course of its iteration. The verbs are those of
// BoltTrials: start, aim, follow, mismatch, break.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/contact/open_close.h"
#include "engine/linear/block_matrix.h"
#include "engine/solve/contact_rows.h"
#include "engine/solve/line_search.h"

namespace dda {

// Where the contacts that can change lie among all interfaces of a problem. Their laws are classical: interfaces that
// carry their blocks' stresses (has_stress_rows) are linear until they break, and belong to the constant matrix.
struct ChangingContacts {
  std::span<const int> places;  // ascending, in the arrays below
  std::span<const InterfaceElement> elements;
  std::span<const EndStrength> strengths;
  std::span<const InterfaceState> states;  // at the start of the step
  ContactRule rule;
};

class InterfaceTrials {
 public:
  // The start of a step.
  void start(const ChangingContacts& contacts);
  // The same contacts after their arrays may have moved, or with those that admit() is to add.
  void look_at(const ChangingContacts& contacts) { contacts_ = contacts; }
  // Back to the start of the step, but for what broke since.
  void restart();
  // The contact at index k of `places` takes part from now on, with these ends broken, at the increments `d`.
  void admit(std::size_t k, const std::array<bool, 2>& broken, const Eigen::VectorXd& d);

  [[nodiscard]] std::size_t size() const { return trials_.size(); }
  [[nodiscard]] bool empty() const { return trials_.empty(); }
  [[nodiscard]] InterfaceTrial& operator[](std::size_t k) { return trials_[k]; }
  [[nodiscard]] const InterfaceTrial& operator[](std::size_t k) const { return trials_[k]; }
  [[nodiscard]] const InterfaceElement& element(std::size_t k) const { return contacts_.elements[place(k)]; }
  [[nodiscard]] const EndStrength& strength(std::size_t k) const { return contacts_.strengths[place(k)]; }
  [[nodiscard]] const InterfaceState& state(std::size_t k) const { return contacts_.states[place(k)]; }
  // Index in the arrays of all interfaces.
  [[nodiscard]] std::size_t place(std::size_t k) const { return static_cast<std::size_t>(contacts_.places[k]); }
  // Neither end is broken: linear in its gaps, whatever they are.
  [[nodiscard]] bool is_whole(std::size_t k) const { return !trials_[k].broken[0] && !trials_[k].broken[1]; }

  // The active rows whose stiffness the matrix holds; taken up from the trials. Returns how many contacts changed.
  [[nodiscard]] const ContactRows& matrix_rows(std::size_t k) const { return matrix_rows_[k]; }
  std::int64_t take_up_rows();
  [[nodiscard]] bool take_up_rows(std::size_t k);
  void add_stiffness(double factor, BlockMatrix& matrix) const;

  // Forces at the end of the step are force + K_active (gap at the end - gap reached). What of that does not depend on
  // the unknowns goes to the right, beside the forces of the start.
  void add_rhs(double factor, Eigen::VectorXd& rhs) const;
  [[nodiscard]] Vec4 constant_force(std::size_t k, const InterfaceSprings& springs) const;
  // What the matrix makes of a change of the gaps.
  [[nodiscard]] Vec4 force_in_matrix(std::size_t k, const InterfaceSprings& springs, const Vec4& gap_change) const {
    return force_change(springs, matrix_rows_[k].active, matrix_rows_[k].coupling, gap_change);
  }

  void aim(const Eigen::VectorXd& newton_step);
  // Largest difference between a force after the whole Newton step and what the rows active now make of it. (Rows
  // alone cannot tell whether statuses have settled: where blocks just touch they come and go with round-off.)
  [[nodiscard]] double mismatch() const;
  [[nodiscard]] double largest_force() const;
  // Takes `factor` times the part of the active rows out of what the whole matrix and right-hand side make.
  void take_out(double factor, LineSlope& line) const;
  // Adds `factor` times the slope at the share t of the Newton step.
  void add_slope(double factor, double t, double& slope) const;
  void follow(double share);
  // Gaps anew from the increments of the whole step.
  void measure(std::size_t k, const Eigen::VectorXd& d);

  // Coulomb friction as a fixed point of given capacities, and dilation as one of given slips: they follow the forces
  // reached. Returns the largest change of a force.
  double follow_capacities();
  double follow_dilations();

  // Ends beyond their strength break; appends the places of their contacts.
  void break_ends_beyond_strength(std::vector<int>& broken);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [contacts, trials, matrix_rows, some_can_break] = self;
    archive(matrix_rows);  // the others begin with every step
  }

 private:
  [[nodiscard]] InterfaceTrial started(std::size_t k) const;

  ChangingContacts contacts_;
  std::vector<InterfaceTrial> trials_;
  std::vector<ContactRows> matrix_rows_;
  bool some_can_break_ = false;  // an end, in the step
};

}  // namespace dda
