// A series of .vtp files in time, and the .pvd file that lists them for ParaView.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/record/vtp_file.h"

namespace dda {

// Writes DIR/NAME/000000.vtp, 000001.vtp, ... and the index DIR/NAME.pvd with their times, rewritten with each file, so
// that a run that is going on or was broken off can be looked at.
class VtpSeries {
 public:
  // `index` is DIR/NAME.pvd; DIR must exist. std::runtime_error naming path and reason.
  explicit VtpSeries(std::filesystem::path index);

  // Adds a file of data.time; std::runtime_error naming path and reason, with all earlier files and their index left as
  // they were.
  void add(const PolyData& data);

  // Goes on behind the files that an earlier run wrote at these times (s), which stay as they are.
  void go_on_after(std::span<const double> times);

  [[nodiscard]] int size() const { return size_; }

 private:
  [[nodiscard]] std::filesystem::path next_path() const;
  [[nodiscard]] std::string entry(double time) const;

  std::filesystem::path index_;
  std::string entries_;
  int size_ = 0;
};

}  // namespace dda
