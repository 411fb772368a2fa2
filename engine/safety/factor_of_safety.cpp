#include "engine/safety/factor_of_safety.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <future>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/safety/reduced_strength.h"

namespace dda {
namespace {

// Asks to stop when it goes.
struct StopAtEnd {
  std::stop_source source;
  StopAtEnd() = default;
  StopAtEnd(const StopAtEnd&) = delete;
  StopAtEnd& operator=(const StopAtEnd&) = delete;
  ~StopAtEnd() { source.request_stop(); }
};

class Search {
 public:
  Search(const Model& model, const SafetyQuestion& question, const std::function<void(const SafetyTrial&)>& progress)
      : model_(model), question_(question), progress_(progress) {}

  // `first` is the factor that is tried first.
  SafetyReport find(double first) {
    try_first(first);
    bracket(first);
    return narrow();
  }

  // Looks no further where the rock fails at the first one.
  SafetyReport find_above(double first) {
    try_first(first);
    if (report_.stands > 0) bracket(first);
    return narrow();
  }

 private:
  void try_first(double factor) { note(factor, run(factor)); }

  SafetyReport narrow() {
    if (report_.is_bracketed())
      while (report_.fails / report_.stands > 1 + question_.width) part();
    return std::move(report_);
  }

  [[nodiscard]] Standing run(double factor, const std::stop_token& stop = {}) const {
    return standing_of(with_strength_over(factor, model_), question_.time, stop);
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
  void bracket(double first) {
    const double ratio = report_.stands > 0 ? 2 : 0.5;
    double factor = first * ratio;
    while (!report_.is_bracketed() && within_reach(factor) && can_stand()) {
      std::vector<double> factors;
      for (; factors.size() < jobs() && within_reach(factor); factor *= ratio) factors.push_back(factor);
      run_until([this] { return report_.is_bracketed() || !can_stand(); }, factors);
    }
  }

  [[nodiscard]] bool within_reach(double factor) const {
    return factor <= question_.most && factor >= 1 / question_.most;
  }

  [[nodiscard]] bool can_stand() const { return report_.stands > 0 || report_.failure.is_loaded; }

  // A run that stands above one that fails, as where blocks find another hold, counts as failed: the factor is that of
  // the first failure.
  void part() {
    const std::size_t inner = std::max<std::size_t>(2, jobs());
    const double ratio = inner == 2 ? std::cbrt(report_.fails / report_.stands)
                                    : std::pow(report_.fails / report_.stands, 1.0 / static_cast<double>(inner + 1));
    std::vector<double> factors{report_.stands * ratio};
    while (factors.size() < inner) factors.push_back(factors.back() * ratio);
    const double end = report_.fails;
    run_until([&] { return report_.fails < end; }, factors);
  }

  [[nodiscard]] std::size_t jobs() const { return static_cast<std::size_t>(std::max(1, question_.jobs)); }

  // Notes runs of these factors, one after the other, until `is_enough`. Several jobs run all of them at once, this
  // thread the first, and those that are not needed are given up; one job runs what is asked for.
  void run_until(const std::function<bool()>& is_enough, const std::vector<double>& factors) {
    std::vector<std::future<Standing>> runs;
    const StopAtEnd end;  // before the runs go, which wait for their threads
    for (const double factor : factors)
      runs.push_back(std::async(jobs() == 1 || runs.empty() ? std::launch::deferred : std::launch::async,
                                [this, factor, stop = end.source.get_token()] { return run(factor, stop); }));
    for (std::size_t i = 0; i < factors.size() && !is_enough(); ++i) note(factors[i], runs[i].get());
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
  return Search(model, question, progress).find(1);
}

SafetyReport factor_of_kept_strength(const Model& model, const SafetyQuestion& question, const SafetyReport& lost,
                                     const std::function<void(const SafetyTrial&)>& progress) {
  if (!lost.is_bracketed() || !loses_strength(model)) return {};
  const Model kept = with_strength_kept(model);
  return Search(kept, question, progress).find_above(lost.fails * (1 + question.width));
}

}  // namespace dda
