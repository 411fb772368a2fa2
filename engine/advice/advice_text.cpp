#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

#include "engine/advice/advice.h"
#include "engine/advice/advise.h"
#include "engine/model/step_choice.h"

namespace dda {
namespace {

// No sign before a zero.
std::string percent(double value) { return std::abs(value) < 5e-6 ? "0.000 %" : fmt::format("{:+.3f} %", 100 * value); }

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
  const std::string damping = terms.damping != 0 ? ", damping " + percent(terms.damping) : "";
  const std::string sides = terms.sides != 0 ? ", sides " + percent(terms.sides) : "";
  return fmt::format("{} = block size {}, interfaces {}, time steps {}{}{}", percent(terms.total()),
                     percent(terms.blocks), percent(terms.interfaces), percent(terms.time), damping, sides);
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

// Empty where what comes has kept its shape. Another summit of the correlation may be nearly as high as that of the
// delay otherwise, which another way of reading would take.
std::string unlike(const HistoryErrors& history) {
  constexpr double alike = 0.9;
  if (history.arrival.likeness >= alike) return "";
  return fmt::format("resembles what should come by {:.2f} alone (correlation), so that other readings give others",
                     history.arrival.likeness);
}

void add_history(const WaveAdvice& wave, Text& text) {
  if (!wave.asked_history) return;
  if (!wave.history) {
    text.line("  the load's history, after {:.4g} m: {}", wave.distance, wave.not_foretold);
    return;
  }
  const HistoryErrors& history = *wave.history;
  text.line("  the load's history, {} {:.4g} m",
            history.with_end ? "stress at the joint after" : "the way alone, after", history.place);
  text.line("    speed      {}   (by cross-correlation)", split(history.speed));
  text.line("    amplitude  {}   (least-squares fit)", split(history.amplitude));
  if (const std::string warning = unlike(history); !warning.empty()) text.line("    {}", warning);
  if (!history.arrival.has_peak) {
    text.line("    largest value {}; no peak to read: it stays at its largest value; speed by onset {}",
              percent(history.arrival.largest), percent(history.arrival.onset_speed));
    return;
  }
  text.line("    largest value {}; first peak {}; speed by first peak {}, by onset {}",
            percent(history.arrival.largest), percent(history.arrival.peak), percent(history.arrival.peak_speed),
            percent(history.arrival.onset_speed));
}

std::string blocks_of(const WaveAdvice& wave, double scale) {
  return fmt::format("{:.3g} m ({:.2g} times these)", scale * wave.block_size, scale);
}

// A limit that is the coarsest that was tried is not one of the mesh.
std::string limit_of(const std::string& value, double limit, double coarsest) {
  return value + (limit == coarsest ? ", the coarsest tried," : "");
}

std::string dt_of(const WaveLimits& limits) {
  if (!limits.dt) return fmt::format("no dt down to {:.3g} s is small enough", limits.finest.dt);
  return limit_of(fmt::format("dt up to {:.3g} s", *limits.dt), *limits.dt, limits.coarsest.dt);
}

std::string blocks_of(const WaveAdvice& wave, const WaveLimits& limits) {
  if (!limits.scale)
    return fmt::format("no blocks down to {:.3g} m are small enough", limits.finest.scale * wave.block_size);
  return limit_of("blocks up to " + blocks_of(wave, *limits.scale), *limits.scale, limits.coarsest.scale);
}

void add_limits(const Advice& advice, const WaveAdvice& wave, Text& text) {
  if (!wave.limits) return;
  const WaveLimits& limits = *wave.limits;
  const std::string wanted = fmt::format("  for {:.4g} %: ", 100 * advice.wanted_error);
  if (wave.own_layers) {
    text.line("{}{} with these layers", wanted, dt_of(limits));
  } else if (limits.dt || limits.scale) {
    text.line("{}{} with these blocks; {} with this dt", wanted, dt_of(limits), blocks_of(wave, limits));
  } else if (limits.both_dt) {
    text.line("{}smaller blocks and a smaller dt together: {} and {:.3g} s", wanted,
              blocks_of(wave, *limits.both_scale), *limits.both_dt);
  } else {
    text.line("{}no blocks down to {:.3g} m and dt down to {:.3g} s{}", wanted, limits.finest.scale * wave.block_size,
              limits.finest.dt, wave.asked_history ? "; what jumps or has kinks holds all frequencies" : "");
  }
}

// Damping in proportion to inertia holds on to the ground of 0 s: what is moved has to press its rock on against that,
// and so there is more stress than in rock without damping, and not less as in a wave that fades.
std::string cause_of(const WaveAdvice& wave) {
  std::string cause = wave.cause();
  const ErrorTerms* amplitude = wave.amplitude_error();
  if (cause != "damping" || amplitude == nullptr || amplitude->damping <= 0) return cause;
  return "damping, which brakes against the ground of 0 s: to move rock on against it takes more stress";
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
  if (const std::string cause = cause_of(wave); !cause.empty()) text.line("  mostly by: {}", cause);
  add_limits(advice, wave, text);
}

void add_cost(const StageCost& cost, Text& text) {
  if (cost.sliding) {
    text.line(
        "  cost: roughly {:.2g} s of CPU time while contacts rest; {:.2g} to {:.2g} s if they slide and open in every "
        "step",
        cost.seconds, cost.sliding->least, cost.sliding->most);
    return;
  }
  text.line("  cost: {} factorization{}{}; roughly {:.2g} s of CPU time", cost.factorizations,
            cost.factorizations == 1 ? "" : "s",
            cost.iterations > 0 ? fmt::format(", {} iterations", cost.iterations) : "", cost.seconds);
}

bool has_waves(const Advice& advice) {
  return std::any_of(advice.stages.begin(), advice.stages.end(),
                     [](const StageAdvice& stage) { return !stage.waves.empty(); });
}

std::string counted(std::int64_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

// A wave with the damping ratio r is exp(-2 pi r) of itself a wavelength further on.
std::string damping_sentence(const StageAdvice& stage, double frequency) {
  return fmt::format(
      "damping: {:.3g} % of critical at {:.6g} Hz; a wave loses {:.3g} % of its amplitude over a wavelength",
      100 * stage.damping_ratio, frequency, -100 * std::expm1(-2 * std::numbers::pi * stage.damping_ratio));
}

void add_stage(const Advice& advice, const StageAdvice& stage, Text& text) {
  text.line("");
  if (stage.dt == 0) {
    text.line("stage \"{}\": as many steps to equilibrium as it needs, {}", stage.name, stage.solver);
    return;
  }
  if (stage.stable_dt > 0) {
    text.line("stage \"{}\": {} steps of {:.6g} s, {}: explicit, stable up to {:.6g} s", stage.name, stage.cost.steps,
              stage.dt, stage.integrator, stage.stable_dt);
    text.line("  cost: roughly {:.2g} s of CPU time", stage.cost.seconds);
  } else {
    text.line("stage \"{}\": {} steps of {}, {}; {}, so {}", stage.name, stage.cost.steps,
              in_words(stage.first_dt, stage.dt), stage.integrator, in_words(stage.chi), stage.solver);
    add_cost(stage.cost, text);
  }
  if (!stage.why_integrator.empty()) text.line("  chosen: {}", stage.why_integrator);
  if (stage.explicit_instead)
    text.line(
        "  would help: \"integrator\": \"central_difference\" with dt up to {:.2g} s, roughly {:.2g} s of CPU time",
        stage.explicit_instead->dt, stage.explicit_instead->seconds);
  if (stage.damping_ratio > 0) text.line("  {}", damping_sentence(stage, *advice.frequency));
  for (const WaveAdvice& wave : stage.waves) add_wave(advice, wave, text);
}

void add_steady_in_short(const Advice& advice, const StageAdvice& stage, const WaveAdvice& wave,
                         std::vector<std::string>& lines) {
  const double frequency = *advice.frequency;
  const double theta = 2 * std::numbers::pi * frequency * stage.dt;
  lines.push_back(fmt::format("  {} wave in \"{}\", {}: {:.2f} m/s, wavelength {:.4g} m", wave.kind, wave.material,
                              wave.direction_name, wave.speed, wave.wavelength));
  lines.push_back(fmt::format("    block size/wavelength (eta) {:.3g} at {:.4g} m; omega dt (theta) {:.3g}",
                              wave.block_size / wave.wavelength, wave.block_size, theta));
  if (theta >= std::numbers::pi) {
    lines.push_back(fmt::format("    less than two steps a period: no such wave can be stepped; take dt below {:.2g} s",
                                1 / (20 * frequency)));
  } else if (!wave.steady) {
    lines.emplace_back("    blocks of this size do not carry it");
  } else {
    lines.push_back(fmt::format("    speed {}", split(wave.steady->speed)));
    lines.push_back(fmt::format("    amplitude after {:.4g} m {}", wave.distance, split(wave.steady->amplitude)));
  }
}

std::string history_in_short(const WaveAdvice& wave) {
  const std::string which = fmt::format("  {} wave in \"{}\", {}", wave.kind, wave.material, wave.direction_name);
  if (!wave.history) return fmt::format("{}: {}", which, wave.not_foretold);
  const std::string warning = unlike(*wave.history);
  return fmt::format("{}, after {:.4g} m: speed {}, amplitude {}, largest value {}; mostly by {}{}", which,
                     wave.history->place, percent(wave.history->speed.total()),
                     percent(wave.history->amplitude.total()), percent(wave.history->arrival.largest), cause_of(wave),
                     warning.empty() ? "" : "; " + warning);
}

}  // namespace

std::string to_text(const Advice& advice) {
  Text text;
  text.line("{}, {}, {}, {:.0f} numbers in a factor of the matrix", counted(advice.size.blocks, "block"),
            counted(advice.size.interfaces, "interface"), counted(advice.size.coupled_pairs, "coupled pair"),
            advice.size.factor.nonzeros);
  if (!advice.load.empty()) text.line("load {}", advice.load);
  for (const std::string& sentence : advice.unseen) text.line("note: {}", sentence);
  for (const std::string& sentence : advice.sudden) text.line("note: {}", sentence);
  if (!advice.frequency)
    text.line(
        "nothing is said of waves: give --frequency, or \"target_frequency\" or a load with a history in the scene");
  if (has_waves(advice) && advice.joints_may_open)
    text.line("waves are predicted as if all joints stayed closed and stuck");
  for (const StageAdvice& stage : advice.stages) add_stage(advice, stage, text);
  if (!advice.springs.empty()) text.line("note: {}", advice.springs);
  return text.take();
}

std::vector<std::string> to_short_text(const Advice& advice) {
  std::vector<std::string> lines;
  if (!advice.sudden.empty()) lines.emplace_back();
  for (const std::string& sentence : advice.sudden) lines.push_back("note: " + sentence);
  for (const StageAdvice& stage : advice.stages) {
    if (stage.waves.empty()) continue;
    lines.insert(lines.end(), {"", fmt::format("predicted for waves of {:.6g} Hz, stage \"{}\"; dda advise says more",
                                               *advice.frequency, stage.name)});
    if (stage.damping_ratio > 0) lines.push_back("  " + damping_sentence(stage, *advice.frequency));
    for (const WaveAdvice& wave : stage.waves) add_steady_in_short(advice, stage, wave, lines);
    if (!stage.waves.front().asked_history) continue;
    lines.insert(lines.end(),
                 {"", fmt::format("predicted for the whole history of the load, stage \"{}\"", stage.name)});
    for (const WaveAdvice& wave : stage.waves) lines.push_back(history_in_short(wave));
  }
  if (!advice.springs.empty()) lines.push_back("note: " + advice.springs);
  return lines;
}

}  // namespace dda
