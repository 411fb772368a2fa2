// A contact that the quick passes settle, and where they stand with it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/contact/contact_pieces.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/point_kinematics.h"

namespace dda {

struct LiveContact {
  std::size_t trial;
  int block_a, block_b;
  ContactPieces pieces;  // what the pass takes its ends to be
  bool between;          // its forces are not what it answers: keep_to_bordering_pieces
  bool changes;          // what it answers is on other pieces than the last pass took it to be on
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
};

// A point of the iteration that a step leads away from, to come back to.
struct PointLeft {
  std::vector<ContactPieces> pieces;  // of all live contacts there
  Eigen::VectorXd step;               // from there, 6 entries a block
  Eigen::VectorXd way;                // from there to where the iteration is

  void leave(const std::vector<LiveContact>& live, const Eigen::VectorXd& step_from_there) {
    step = step_from_there;
    way.setZero(step.size());
    pieces.clear();
    for (const LiveContact& contact : live) pieces.push_back(contact.pieces);
  }

  void put_back_pieces(std::vector<LiveContact>& live) const {
    for (std::size_t k = 0; k < live.size(); ++k) live[k].pieces = pieces[k];
  }
};

}  // namespace dda
