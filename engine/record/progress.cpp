#include "engine/record/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

namespace dda {
namespace {

constexpr double interval = 0.1;  // s between drawings
constexpr int bar_width = 10;
constexpr auto clear_to_end = "\x1b[K";

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::ostream* terminal() { return ::isatty(STDERR_FILENO) == 1 ? &std::cerr : nullptr; }

PassingLine::PassingLine(const std::string& text, std::ostream* output) : output_(output) {
  if (output_ != nullptr) *output_ << text << std::flush;
}

PassingLine::~PassingLine() {
  if (output_ != nullptr) *output_ << '\r' << clear_to_end << std::flush;
}

Progress::Progress(double start_time, double end_time, std::ostream* output, Clock clock)
    : output_(output),
      clock_(clock ? std::move(clock) : Clock(steady_seconds)),
      start_time_(start_time),
      end_time_(end_time) {
  if (output_ == nullptr) return;
  began_ = clock_();
  next_ = began_ + interval;
  draw(began_, start_time_, 0);
}

Progress::~Progress() { end_line(); }

void Progress::draw_when_due(double time, std::int64_t step) {
  if (!first_step_) first_step_ = step - 1;
  const double now = clock_();
  if (now < next_) return;
  next_ = now + interval;
  draw(now, time, step);
}

void Progress::draw(double now, double time, std::int64_t step) {
  const double elapsed = now - began_;
  const double pace = elapsed > 0 ? static_cast<double>(step - first_step_.value_or(step)) / elapsed : 0;
  const std::string line = end_time_ > start_time_ ? along_the_time(time, elapsed, pace)
                                                   : fmt::format("step {}  {:.3g} steps/s", step, pace);
  *output_ << '\r' << line << clear_to_end << std::flush;
  line_begun_ = true;
}

std::string Progress::along_the_time(double time, double elapsed, double pace) const {
  const double done = std::clamp((time - start_time_) / (end_time_ - start_time_), 0.0, 1.0);
  const std::string bar(static_cast<std::size_t>(done * bar_width), '#');
  return fmt::format("[{:<{}}] {:3.0f} %  {:.4g} of {:.4g} s  {:.3g} steps/s  {} left", bar, bar_width,
                     std::floor(100 * done), time, end_time_, pace, clock_text(elapsed * (1 / done - 1)));
}

void Progress::finish(double time, std::int64_t step) {
  if (output_ == nullptr) return;
  draw(clock_(), time, step);
  end_line();
}

void Progress::end_line() {
  if (line_begun_) *output_ << '\n' << std::flush;
  line_begun_ = false;
}

std::string clock_text(double seconds) {
  constexpr double longest = 100 * 3600.0;  // s; what is longer, or infinite, says nothing
  if (!(seconds >= 0 && seconds < longest)) return "--:--";
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace dda
