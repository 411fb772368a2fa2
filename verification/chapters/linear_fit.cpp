#include "verification/chapters/linear_fit.h"

#include <numeric>

namespace verify {
namespace {

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double covariance(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean(x)) * (y[i] - mean(y));
  return sum;
}

}  // namespace

LinearFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double xy = covariance(x, y);
  const double xx = covariance(x, x);
  const double yy = covariance(y, y);
  return {xy / xx, yy > 0 ? xy * xy / (xx * yy) : 1};
}

}  // namespace verify
