// Yardstick: a rectangular plate of equal square 4-node elements in plane stress, full integration, lumped mass,
// stepped by central differences (Hughes 1987, sections 3.3 and 9).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace yardstick {

struct Plate {
  double density = 0;  // kg/m3
  double young = 0;    // Pa
  double poisson = 0;  // -
  double side = 0;     // m, of an element
  int columns = 0;
  int rows = 0;

  [[nodiscard]] int node(int column, int row) const { return row * (columns + 1) + column; }
  [[nodiscard]] int nodes() const { return (columns + 1) * (rows + 1); }
};

// A force that acts at a node with the time function of the step.
struct NodeForce {
  int node = 0;
  Eigen::Vector2d force;  // N per m of thickness
};

using Stiffness = Eigen::Matrix<double, 8, 8>;

// Nodes counter-clockwise from below left, (x, y) each; N/m per m of thickness. It does not depend on the side.
[[nodiscard]] Stiffness square_stiffness(double young, double poisson);

// All four edges are free. A step is stable up to about c_p dt = side.
class ExplicitPlate {
 public:
  ExplicitPlate(const Plate& plate, double dt, std::vector<NodeForce> forces);

  // One step of dt from time t, the forces times their factor at time t.
  void step(double factor);

  // m and m/s, (x, y) of each node; the velocity is that of half a step before.
  [[nodiscard]] Eigen::Matrix2Xd& displacement() { return displacement_; }
  [[nodiscard]] Eigen::Matrix2Xd& velocity() { return velocity_; }

 private:
  void add_elements();

  Plate plate_;
  double dt_;
  std::vector<NodeForce> forces_;
  Stiffness stiffness_;
  Eigen::Matrix2Xd displacement_, velocity_, force_;
  Eigen::VectorXd step_over_mass_;
};

}  // namespace yardstick
