// Yardstick: a bar of equal 2-node elements with lumped mass, stepped by central differences (Hughes 1987, section 9).
#pragma once

#include <vector>

namespace yardstick {

struct Bar {
  double density = 0;  // kg/m3
  double young = 0;    // Pa
  double area = 1;     // m2
  double length = 0;   // m
  int elements = 0;

  [[nodiscard]] double element_length() const { return length / elements; }
};

// A step is stable up to sqrt(E/rho) dt = element length.
class ExplicitBar {
 public:
  ExplicitBar(const Bar& bar, double dt);

  // One step of dt from time t under `force` (N) at time t, which pushes the left end in +x.
  void step(double force);

  // Pa, tension positive: mean of the two elements that meet at an inner node.
  [[nodiscard]] double stress_at_node(int node) const;

  // m and m/s, at the nodes; the velocity is that of half a step before.
  [[nodiscard]] std::vector<double>& displacement() { return displacement_; }
  [[nodiscard]] std::vector<double>& velocity() { return velocity_; }

 private:
  double dt_, young_over_length_, area_;
  std::vector<double> displacement_, velocity_, stress_, step_over_mass_;
};

}  // namespace yardstick
