#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "dda/advice/advice.h"

namespace dda {
namespace {

std::string percent(double value) { return fmt::format("{:+.3f} %", 100 * value); }

class Text {
 public:
  template <typename... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string split(const ErrorTerms& terms) {
  return fmt::format("{} = block size {}, interfaces {}, time steps {}", percent(terms.total()), percent(terms.blocks),
                     percent(terms.interfaces), percent(terms.time));
}

void add_steady(const Advice& advice, const WaveAdvice& wave, Text& text) {
  if (!wave.steady) {
    text.line("  a steady wave of {:.6g} Hz: not carried, by blocks or by time steps", *advice.frequency);
    return;
  }
  text.line("  a steady wave of {:.6g} Hz, after {:.4g} m", *advice.frequency, wave.distance);
  text.line("    speed      {}", split(wave.steady->speed));
  text.line("    amplitude  {}", split(wave.steady->amplitude));
}

void add_history(const WaveAdvice& wave, Text& text) {
  if (!wave.asked_history) return;
  if (!wave.history) {
    text.line("  the load's history, after {:.4g} m: nothing that resembles it, or half a period off its time",
              wave.distance);
    return;
  }
  const HistoryErrors& history = *wave.history;
  text.line("  the load's history, {} {:.4g} m",
            history.with_end ? "stress at the joint after" : "the way alone, after", history.place);
  text.line("    speed      {}   (by cross-correlation)", split(history.speed));
  text.line("    amplitude  {}   (least-squares fit)", split(history.amplitude));
  text.line("    peak {}; speed by peak {}, by onset {}", percent(history.arrival.peak),
            percent(history.arrival.peak_speed), percent(history.arrival.onset_speed));
}

std::string or_none(const std::optional<double>& value, double unit_value, const char* format_unit) {
  return value ? fmt::format("{:.3g} {}", *value * unit_value, format_unit) : "none";
}

void add_limits(const Advice& advice, const WaveAdvice& wave, Text& text) {
  if (!wave.limits) return;
  const WaveLimits& limits = *wave.limits;
  const auto blocks = [&](const std::optional<double>& scale) { return or_none(scale, wave.block_size, "m"); };
  text.line("  for {:.4g} %: largest dt with these blocks {}; largest blocks with this dt {}",
            100 * advice.wanted_error, or_none(limits.dt, 1, "s"), blocks(limits.scale));
  if (limits.both_dt)
    text.line("    neither alone is enough; both: blocks of {} and dt of {}", blocks(limits.both_scale),
              or_none(limits.both_dt, 1, "s"));
}

void add_wave(const Advice& advice, const WaveAdvice& wave, Text& text) {
  text.line("");
  text.line(
      "{} wave in \"{}\", {} [{:.3g}, {:.3g}]: {:.2f} m/s; blocks of {:.4g} m, {:.3g} in a wavelength of {:.4g} m",
      wave.kind, wave.material, wave.direction_name, wave.direction.x(), wave.direction.y(), wave.speed,
      wave.block_size, wave.wavelength / wave.block_size, wave.wavelength);
  text.line("  mesh: {}", wave.mesh);
  add_steady(advice, wave, text);
  add_history(wave, text);
  if (const std::string cause = wave.cause(); !cause.empty()) text.line("  mostly by: {}", cause);
  add_limits(advice, wave, text);
}

void add_stage(const Advice& advice, const StageAdvice& stage, Text& text) {
  text.line("");
  text.line("stage \"{}\": {} steps of {:.6g} s, {}; chi = {:.3g}, so {}", stage.name, stage.cost.steps, stage.dt,
            stage.integrator, stage.chi, stage.solver);
  text.line("  cost: {}{} factorization{}{}; roughly {:.2g} s of CPU time{}", stage.cost.at_least ? "at least " : "",
            stage.cost.factorizations, stage.cost.factorizations == 1 ? "" : "s",
            stage.cost.iterations > 0 ? fmt::format(", {} iterations", stage.cost.iterations) : "", stage.cost.seconds,
            stage.cost.at_least ? " while contacts rest, many times that while they slide and open" : "");
  for (const WaveAdvice& wave : stage.waves) add_wave(advice, wave, text);
}

}  // namespace

std::string to_text(const Advice& advice) {
  Text text;
  text.line("{} blocks, {} interfaces, {} coupled pairs, {:.0f} numbers in a factor", advice.size.blocks,
            advice.size.interfaces, advice.size.coupled_pairs, advice.size.factor.nonzeros);
  if (!advice.load.empty()) text.line("load {}", advice.load);
  if (!advice.frequency)
    text.line("no frequency: give --frequency, or \"target_frequency\" or a load with a history in the scene");
  if (advice.joints_may_open) text.line("waves are predicted as if all joints stayed closed and stuck");
  if (advice.damped) text.line("damping of velocities is not counted");
  for (const StageAdvice& stage : advice.stages) add_stage(advice, stage, text);
  return text.take();
}

std::vector<std::string> to_short_text(const Advice& advice) {
  std::vector<std::string> lines;
  for (const StageAdvice& stage : advice.stages) {
    const std::string where = advice.stages.size() > 1 ? fmt::format("stage \"{}\": ", stage.name) : "";
    for (const WaveAdvice& wave : stage.waves) {
      if (!wave.asked_history) continue;
      if (!wave.history) {
        lines.push_back(fmt::format("{}{} wave in \"{}\", {}: does not arrive in its shape", where, wave.kind,
                                    wave.material, wave.direction_name));
        continue;
      }
      lines.push_back(fmt::format(
          "{}{} wave in \"{}\", {}, after {:.4g} m: speed {}, amplitude {}, peak {}; mostly by {}", where, wave.kind,
          wave.material, wave.direction_name, wave.history->place, percent(wave.history->speed.total()),
          percent(wave.history->amplitude.total()), percent(wave.history->arrival.peak), wave.cause()));
    }
  }
  return lines;
}

}  // namespace dda
