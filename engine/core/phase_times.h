// Where the time of a step goes.
#pragma once

#include <array>
#include <chrono>

namespace dda {

// Wall time in seconds.
struct PhaseTimes {
  double geometry = 0;       // blocks followed, contacts searched
  double assembly = 0;       // of the whole matrix
  double factorization = 0;  // or set-up of the preconditioner
  double solution = 0;       // of linear systems
};

struct PhaseField {
  const char* name;  // as in summary.json
  double PhaseTimes::*value;
};

inline constexpr std::array phase_fields{
    PhaseField{"geometry and contact search", &PhaseTimes::geometry}, PhaseField{"assembly", &PhaseTimes::assembly},
    PhaseField{"factorization", &PhaseTimes::factorization}, PhaseField{"solution", &PhaseTimes::solution}};

// Adds the time of a scope. Two looks at a clock: a tenth of a microsecond.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
  ~PhaseTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_;
};

}  // namespace dda
