// The folder of a sweep: its spec, a file for every job that has ended, and what is collected from them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/sweep/parameters.h"
#include "verification/sweep/spec.h"

namespace verify {

// status of a job: ok, not_measurable and failed are its own words; crashed is what the driver saw; missing: no file.
struct JobFile {
  std::string status = "missing";
  std::string message;
  nlohmann::ordered_json parameters;
  nlohmann::ordered_json result = nlohmann::ordered_json::object();  // empty unless ok

  [[nodiscard]] bool ended_by_itself() const { return status != "missing" && status != "crashed"; }
  [[nodiscard]] bool failed() const { return status != "ok" && status != "not_measurable"; }
};

class SweepFolder {
 public:
  explicit SweepFolder(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path spec_file() const { return path_ / "sweep.json"; }
  [[nodiscard]] std::filesystem::path job_file(std::size_t index) const;

  // Makes the folder and keeps the spec's text in it, so that jobs and collecting need nothing else.
  void prepare(std::string_view spec_text) const;
  [[nodiscard]] bool has_jobs() const;  // of whatever sweep, whole or not

  void write(std::size_t index, const JobFile& job) const;
  // What is no whole job file, or one of other parameters, is missing.
  [[nodiscard]] JobFile read(std::size_t index, const JobParameters& parameters) const;

  // Indices of the jobs that have not ended by themselves.
  [[nodiscard]] std::vector<std::size_t> open_jobs(const SweepSpec& spec) const;

 private:
  std::filesystem::path path_;
};

}  // namespace verify
