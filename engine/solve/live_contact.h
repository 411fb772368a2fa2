// A contact that the quick passes settle, and where they stand with it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/contact/contact_pieces.h"
#include "engine/contact/contact_sharing.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/point_kinematics.h"
#include "engine/core/parallel.h"

namespace dda {

struct LiveContact {
  std::size_t trial = 0;
  int block_a = 0, block_b = 0;
  ContactPieces pieces{};           // what the pass takes its ends to be
  bool between = false;             // its forces are not what it answers: keep_to_bordering_pieces
  bool changes = false;             // what it answers is on other pieces than the last pass took it to be on
  std::pair<double, double> depth;  // m: gaps of both ends and, where these are alike, how far they slid
  InterfaceSprings springs;
  PointKinematics points;

  // What the gaps change by with these increments of all blocks, m.
  [[nodiscard]] Vec4 gap(const Eigen::VectorXd& d) const {
    return points.gap(d.segment<6>(6 * block_a), d.segment<6>(6 * block_b));
  }

  // Adds what these forces of its four rows are on its blocks.
  void add_force(const Vec4& of_rows, Eigen::VectorXd& force) const {
    points.add_force(of_rows, force.segment<6>(6 * block_a), force.segment<6>(6 * block_b));
  }

  // Or on one of them alone.
  void add_force(const Vec4& of_rows, Eigen::VectorXd& force, bool on_a, bool on_b) const {
    if (on_a) points.add_force_on_a(of_rows, force.segment<6>(6 * block_a));
    if (on_b) points.add_force_on_b(of_rows, force.segment<6>(6 * block_b));
  }
};

// A point of the iteration that a step leads away from, to come back to.
struct PointLeft {
  std::vector<ContactPieces> pieces;  // of all live contacts there
  Eigen::VectorXd step;               // from there, 6 entries a block
  Eigen::VectorXd way;                // from there to where the iteration is

  void leave(const std::vector<LiveContact>& live, const Eigen::VectorXd& step_from_there) {
    step = step_from_there;
    way.setZero(step.size());
    pieces.resize(live.size());
    parallel_for_each(live.size(), contacts_worth_sharing, [&](std::size_t k) { pieces[k] = live[k].pieces; });
  }

  void put_back_pieces(std::vector<LiveContact>& live) const {
    for (std::size_t k = 0; k < live.size(); ++k) live[k].pieces = pieces[k];
  }
};

}  // namespace dda
