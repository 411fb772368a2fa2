// The gap rows of a classical interface in a few numbers, by its normal and by where its ends lie as seen from either
// centroid, for loops over many contacts that would be busy fetching rows. Gaps of projected stretches follow stresses
// too: for these it is the rows themselves, and the element must live, in place, as long as this.
#pragma once

#include <array>
#include <cstddef>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"

namespace dda {

class PointKinematics {
 public:
  PointKinematics() = default;

  // The element must have no stress rows.
  explicit PointKinematics(const InterfaceElement& element)
      : normal_(element.rows_b.block<1, 2>(0, 0).transpose()),
        ends_(ends_of(element)),
        rows_(element.law == InterfaceLaw::projected ? &element : nullptr) {
    if (rows_ != nullptr) return;
    for (int end = 0; end < ends_; ++end) {
      arm_a_[index(end)] = -arm(element.rows_a, end);
      arm_b_[index(end)] = arm(element.rows_b, end);
    }
  }

  // Gaps that increments of blocks a and b make; zero where there is no second end.
  template <typename Six>
  [[nodiscard]] Vec4 gap(const Six& of_a, const Six& of_b) const {
    if (rows_ != nullptr) return rows_->rows_a * of_a + rows_->rows_b * of_b;
    Vec4 gap = Vec4::Zero();
    for (int end = 0; end < ends_; ++end) {
      const Vec2 apart = moved(arm_b_[index(end)], of_b) - moved(arm_a_[index(end)], of_a);
      gap(2 * end) = normal_.dot(apart);
      gap(2 * end + 1) = normal_.x() * apart.y() - normal_.y() * apart.x();
    }
    return gap;
  }

  // By how much the increments of the normal and the shear gap at a vertex grow while the blocks go once through these
  // increments as rigid bodies: n . w and t . w of the relative motion w = w_b - w_a at the vertex, where n and t turn
  // with block a and the vertex goes with b.
  template <typename Six>
  [[nodiscard]] Vec2 gap_change(const Six& of_a, const Six& of_b) const {
    const double turn_a = of_a(2);
    const double turn_b = of_b(2);
    const auto rigid = [](const Vec2& arm, const Six& d) { return Vec2(d(0) - arm.y() * d(2), d(1) + arm.x() * d(2)); };
    const Vec2 apart = rigid(arm_b_[0], of_b) - rigid(arm_a_[0], of_a);
    const Vec2 across(-apart.y(), apart.x());
    const Vec2 change = turn_a * turn_a * arm_a_[0] - turn_b * turn_b * arm_b_[0] - 2 * turn_a * across;
    return {normal_.dot(change), normal_.x() * change.y() - normal_.y() * change.x()};
  }

  // Adds what interface forces do to either block, as add_interface_force.
  template <typename Six>
  void add_force(const Vec4& force, Six on_a, Six on_b) const {
    add_force_on_a(force, on_a);
    add_force_on_b(force, on_b);
  }

  // The same for one block alone.
  template <typename Six>
  void add_force_on_a(const Vec4& force, Six on_a) const {
    if (rows_ != nullptr) {
      on_a += rows_->rows_a.transpose() * force;
      return;
    }
    for (int end = 0; end < ends_; ++end) add(-at_end(force, end), arm_a_[index(end)], on_a);
  }
  template <typename Six>
  void add_force_on_b(const Vec4& force, Six on_b) const {
    if (rows_ != nullptr) {
      on_b += rows_->rows_b.transpose() * force;
      return;
    }
    for (int end = 0; end < ends_; ++end) add(at_end(force, end), arm_b_[index(end)], on_b);
  }

 private:
  static std::size_t index(int end) { return static_cast<std::size_t>(end); }

  // Column 2 of the rows is what a rotation makes: (n_y x - n_x y, n_x x + n_y y).
  [[nodiscard]] Vec2 arm(const Mat46& rows, int end) const {
    const double across = rows(2 * end, 2);
    const double along = rows(2 * end + 1, 2);
    return {normal_.y() * across + normal_.x() * along, normal_.y() * along - normal_.x() * across};
  }

  // The force on block b at an end, by the forces of the rows.
  [[nodiscard]] Vec2 at_end(const Vec4& force, int end) const {
    const double across = force(2 * end);
    const double along = force(2 * end + 1);
    return {normal_.x() * across - normal_.y() * along, normal_.y() * across + normal_.x() * along};
  }

  // displacement_rows(arm) * d
  template <typename Six>
  static Vec2 moved(const Vec2& arm, const Six& d) {
    return {d(0) - arm.y() * d(2) + arm.x() * d(3) + arm.y() / 2 * d(5),
            d(1) + arm.x() * d(2) + arm.y() * d(4) + arm.x() / 2 * d(5)};
  }

  // on += displacement_rows(arm)^T * force
  template <typename Six>
  static void add(const Vec2& force, const Vec2& arm, Six& on) {
    on(0) += force.x();
    on(1) += force.y();
    on(2) += arm.x() * force.y() - arm.y() * force.x();
    on(3) += arm.x() * force.x();
    on(4) += arm.y() * force.y();
    on(5) += (arm.y() * force.x() + arm.x() * force.y()) / 2;
  }

  Vec2 normal_ = Vec2::Zero();  // unit, from block a into block b
  std::array<Vec2, 2> arm_a_{Vec2::Zero(), Vec2::Zero()}, arm_b_{Vec2::Zero(), Vec2::Zero()};
  int ends_ = 0;
  const InterfaceElement* rows_ = nullptr;
};

}  // namespace dda
