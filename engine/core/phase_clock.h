// Where the time of a run goes: a stopwatch that knows the phases of the work, for `dda run --profile`.
//
// A measuring point is one line, `const PhaseScope scope(Phase::assembly);`, and costs one look at a pointer where no
// clock runs. Phases may lie within others, and each counts the time in which it is the innermost one: the seconds of
// all phases add up to those of the clock, and none is counted twice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dda {

enum class Phase : std::uint8_t {
  set_up,
  stage,
  geometry,
  search,
  right_hand_side,
  judging,
  assembly,
  factorization,
  solution,
  product,
  preconditioner,
  acceptance,
  rows,
  frames,
  checkpoint,
  other,  // whatever lies in none of these
};

struct PhaseName {
  Phase phase;
  const char* name;
};

inline constexpr std::array phase_names{
    PhaseName{Phase::set_up, "reading and setting up"},
    PhaseName{Phase::stage, "beginning of stages"},
    PhaseName{Phase::geometry, "geometry of blocks and contacts"},
    PhaseName{Phase::search, "contact search"},
    PhaseName{Phase::right_hand_side, "right-hand side"},
    PhaseName{Phase::judging, "contact judging"},
    PhaseName{Phase::assembly, "assembly"},
    PhaseName{Phase::factorization, "factorization or preconditioner"},
    PhaseName{Phase::solution, "solution, the rest of it"},
    PhaseName{Phase::product, "operator products"},
    PhaseName{Phase::preconditioner, "use of the preconditioner"},
    PhaseName{Phase::acceptance, "update and energies"},
    PhaseName{Phase::rows, "rows of histories"},
    PhaseName{Phase::frames, "frames"},
    PhaseName{Phase::checkpoint, "checkpoints"},
    PhaseName{Phase::other, "other"},
};
static_assert(phase_names.size() == static_cast<std::size_t>(Phase::other) + 1, "phase_names lists every phase");

struct PhaseCost {
  std::int64_t calls = 0;
  std::int64_t nanoseconds = 0;  // without the phases within
};

// One call of a phase, those within included.
struct PhaseEvent {
  Phase phase;
  std::int64_t begin, duration;  // ns, from the start of the clock
};

class PhaseClock {
 public:
  using Now = std::int64_t (*)();  // ns
  static std::int64_t steady_now();

  // Measures the thread that makes it, from now until it goes. Phases of other threads are not looked at.
  explicit PhaseClock(Now now = steady_now);
  ~PhaseClock() { running = nullptr; }
  PhaseClock(const PhaseClock&) = delete;
  PhaseClock& operator=(const PhaseClock&) = delete;

  // That of this thread; nullptr where none runs.
  [[nodiscard]] static PhaseClock* current() { return running; }

  void enter(Phase phase);
  void leave();

  // Up to now, with what is under way.
  [[nodiscard]] std::array<PhaseCost, phase_names.size()> costs() const;
  [[nodiscard]] std::int64_t nanoseconds() const { return now_() - start_; }

  // The first of them, in the order of their ends; as many as a viewer can show.
  static constexpr std::size_t most_events = 100'000;
  [[nodiscard]] const std::vector<PhaseEvent>& events() const { return events_; }
  [[nodiscard]] std::int64_t events_left_out() const { return events_left_out_; }

 private:
  struct Open {
    Phase phase;
    std::int64_t begin;
  };

  // Books the time since the last change on the innermost phase.
  std::int64_t book();

  static inline constinit thread_local PhaseClock* running = nullptr;

  Now now_;
  std::int64_t start_, last_change_;
  std::vector<Open> open_;  // from the outermost in
  std::array<PhaseCost, phase_names.size()> costs_{};
  std::vector<PhaseEvent> events_;
  std::int64_t events_left_out_ = 0;
};

// The rest of a block of code is this phase.
class PhaseScope {
 public:
  explicit PhaseScope(Phase phase) : clock_(PhaseClock::current()) {
    if (clock_ != nullptr) clock_->enter(phase);
  }
  ~PhaseScope() {
    if (clock_ != nullptr) clock_->leave();
  }
  PhaseScope(const PhaseScope&) = delete;
  PhaseScope& operator=(const PhaseScope&) = delete;

 private:
  PhaseClock* clock_;
};

}  // namespace dda
