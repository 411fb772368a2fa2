#include "engine/safety/factor_of_safety.h"

#include <array>
#include <cmath>
#include <future>
#include <utility>

#include "engine/safety/reduced_strength.h"

namespace dda {
namespace {

class Search {
 public:
  Search(const Model& model, const SafetyQuestion& question, const std::function<void(const SafetyTrial&)>& progress)
      : model_(model), question_(question), progress_(progress) {}

  SafetyReport find() {
    note(1, run(1));
    bracket();
    if (report_.is_bracketed())
      while (report_.fails / report_.stands > 1 + question_.width) part();
    return std::move(report_);
  }

 private:
  [[nodiscard]] Standing run(double factor) const {
    return standing_of(with_strength_over(factor, model_), question_.time);
  }

  void note(double factor, Standing standing) {
    report_.trials.push_back({factor, standing.stands, standing.status, standing.reason, standing.largest_movement});
    if (progress_) progress_(report_.trials.back());
    if (standing.stands) {
      report_.stands = std::max(report_.stands, factor);
    } else if (report_.fails == 0 || factor < report_.fails) {
      report_.fails = factor;
      report_.failure = std::move(standing);
    }
  }

  // Rock that does not carry its loads while contacts stick stands at no strength: there is nothing to look for.
  void bracket() {
    const double ratio = report_.stands > 0 ? 2 : 0.5;
    for (double factor = ratio; !report_.is_bracketed() && within_reach(factor) && can_stand(); factor *= ratio)
      note(factor, run(factor));
  }

  [[nodiscard]] bool within_reach(double factor) const {
    return factor <= question_.most && factor >= 1 / question_.most;
  }

  [[nodiscard]] bool can_stand() const { return report_.stands > 0 || report_.failure.is_loaded; }

  // A run that stands above one that fails, as where blocks find another hold, counts as failed: the factor is that of
  // the first failure.
  void part() {
    const double third = std::cbrt(report_.fails / report_.stands);
    const std::array<double, 2> factors{report_.stands * third, report_.stands * third * third};
    std::future<Standing> other = std::async(std::launch::async, [&] { return run(factors[1]); });
    Standing lower = run(factors[0]);
    const bool lower_stands = lower.stands;
    note(factors[0], std::move(lower));
    Standing upper = other.get();
    if (lower_stands) note(factors[1], std::move(upper));
  }

  const Model& model_;
  const SafetyQuestion& question_;
  const std::function<void(const SafetyTrial&)>& progress_;
  SafetyReport report_;
};

}  // namespace

double SafetyReport::factor() const { return is_bracketed() ? std::sqrt(stands * fails) : 0; }

SafetyReport factor_of_safety(const Model& model, const SafetyQuestion& question,
                              const std::function<void(const SafetyTrial&)>& progress) {
  return Search(model, question, progress).find();
}

}  // namespace dda
