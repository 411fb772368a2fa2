// A measured signal, such as the acceleration of an earthquake: straight lines through its samples, zero before the
// first and after the last of them.
#pragma once

#include <string>
#include <vector>

namespace dda {

class Recording {
 public:
  // `times` in s, strictly increasing, at least two; as many `values`. `name` is for people: the file it came from.
  // Throws InputError (without a file) when they are not so.
  Recording(std::string name, std::vector<double> times, std::vector<double> values);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

  [[nodiscard]] double duration() const { return times_.back() - times_.front(); }
  [[nodiscard]] double mean_interval() const { return duration() / static_cast<double>(times_.size() - 1); }
  [[nodiscard]] double peak() const;  // largest magnitude

  // The signal and its slope (to the right of a sample) at `time`.
  [[nodiscard]] double value(double time) const;
  [[nodiscard]] double slope(double time) const;

  // Integrals of the signal, and of that, from its first sample to `time`: quadratic and cubic between samples, exact
  // but for round-off. Zero before the first sample.
  [[nodiscard]] double integral(double time) const;
  [[nodiscard]] double second_integral(double time) const;

  // The same less the straight line that leaves both integrals zero at the last sample.
  [[nodiscard]] Recording corrected() const;

 private:
  // The sample at or before `time`, which lies within the recording.
  [[nodiscard]] std::size_t sample_before(double time) const;
  [[nodiscard]] double slope_after(std::size_t sample) const;

  std::string name_;
  std::vector<double> times_, values_;
  std::vector<double> integrals_, second_integrals_;  // at the samples
};

}  // namespace dda
