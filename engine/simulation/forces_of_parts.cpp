#include "engine/simulation/forces_of_parts.h"

#include <algorithm>

namespace dda {

void ForcesOfParts::begin_part(double dt) {
  if (length_ == 0)
    for (std::vector<double>& means : means_) std::ranges::fill(means, 0.0);
  length_ += dt;
  share_ = dt / length_;
}

void ForcesOfParts::add(std::size_t measurement, std::span<const double> values) {
  if (measurement >= means_.size()) means_.resize(measurement + 1);
  std::vector<double>& means = means_[measurement];
  means.resize(values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) means[i] += share_ * (values[i] - means[i]);
}

std::span<const double> ForcesOfParts::mean(std::size_t measurement) const {
  if (length_ == 0) return {};
  return means_[measurement];
}

}  // namespace dda
