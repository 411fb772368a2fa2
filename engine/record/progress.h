// A progress bar for the terminal.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace dda {

// Standard error when it is a terminal, else nullptr.
std::ostream* terminal();

// A line that says what goes on while there is no progress to show yet, and is gone with this object.
class PassingLine {
 public:
  explicit PassingLine(const std::string& text, std::ostream* output = terminal());
  ~PassingLine();
  PassingLine(const PassingLine&) = delete;
  PassingLine& operator=(const PassingLine&) = delete;

 private:
  std::ostream* output_;
};

// One line that is drawn over: a bar, per cent, simulated time, steps per second and the time left at that pace. Runs
// of stages that take no time have no share and no time left, and show the number of the step. Drawn at most ten times
// a second; update() costs one look at the clock, and nothing without an output.
class Progress {
 public:
  using Clock = std::function<double()>;  // s, from any origin

  // From `start_time` to `end_time`, in s of the simulation. No `output`: does nothing. No `clock`: steady_clock. Draws
  // at once, as the first step may take long.
  Progress(double start_time, double end_time, std::ostream* output = terminal(), Clock clock = nullptr);

  // Ends the line if it was begun.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // To be called after every step with the simulated time (s) and the number of the step.
  void update(double time, std::int64_t step) {
    if (output_ != nullptr) draw_when_due(time, step);
  }

  // Draws the last state, whenever the line was drawn last, and ends the line.
  void finish(double time, std::int64_t step);

 private:
  void draw_when_due(double time, std::int64_t step);
  void draw(double now, double time, std::int64_t step);
  [[nodiscard]] std::string along_the_time(double time, double elapsed, double pace) const;
  void end_line();

  std::ostream* output_;
  Clock clock_;
  double start_time_;
  double end_time_;
  double began_ = 0;  // s of the clock
  double next_ = 0;
  std::optional<std::int64_t> first_step_;  // before the first update
  bool line_begun_ = false;
};

// "m:ss" or "h:mm:ss", and "--:--" for what is negative, not a number, or 100 hours and more.
std::string clock_text(double seconds);

}  // namespace dda
