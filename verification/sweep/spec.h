// A sweep as its file describes it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/sweep/parameters.h"

namespace verify {

// Errors over x, or over x and y as contours, for every choice of the other parameters.
struct SweepPlot {
  std::string x;
  std::string y;  // empty: lines over x
};

struct SweepSpec {
  std::string title;
  bool closed_form = true;  // compare every job with the closed form of the same discrete problem
  std::vector<SweepPlot> plots;
  std::vector<JobParameters> jobs;
};

// Both throw dda::InputError for the first thing that is wrong.
[[nodiscard]] SweepSpec parse_spec(std::string_view text, const std::string& name_for_errors);
[[nodiscard]] SweepSpec read_spec(const std::filesystem::path& file);

// The text of a spec's file; dda::InputError if it cannot be read.
[[nodiscard]] std::string spec_text(const std::filesystem::path& file);

}  // namespace verify
