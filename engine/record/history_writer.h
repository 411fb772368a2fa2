// Time histories as CSV.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/record/atomic_file.h"

namespace dda {

struct Column {
  std::string name;
  std::string unit;  // empty for a number without one, shown as [-]
};

// Writes a header "time [s],NAME [UNIT],..." and one row for each sample. Numbers are the shortest that read back as
// the same double; names with commas, quotes or line breaks are quoted (RFC 4180). Rows are buffered and reach
// NAME.tmp, whole, at least once a second of appending; close() gives the file its name. A writer destroyed without
// close(), because the run failed, does so too: what was measured up to then is the user's. Warm, append() does not
// allocate.
class HistoryWriter {
 public:
  // Opens the file; std::runtime_error naming path and reason when that fails.
  HistoryWriter(std::filesystem::path path, const std::vector<Column>& columns);

  // Goes on with the file of a run that stopped or was broken off (NAME.tmp is then what it left): keeps its header and
  // first `rows` rows, and drops later ones. InputError naming the file when there is none with these columns and as
  // many rows.
  HistoryWriter(const std::filesystem::path& path, const std::vector<Column>& columns, std::int64_t rows);

  ~HistoryWriter();
  HistoryWriter(const HistoryWriter&) = delete;
  HistoryWriter& operator=(const HistoryWriter&) = delete;

  // One row: time in s and a value for every column, else std::invalid_argument. std::runtime_error when the disk is
  // full; the rows before are then kept.
  void append(double time, std::span<const double> values);

  // Puts all rows so far into NAME.tmp.
  void flush();

  void close();

  [[nodiscard]] std::int64_t rows() const { return rows_; }

 private:
  void reserve_buffer();
  void write_number(double value);
  void flush_when_due();

  AtomicFile file_;
  std::size_t columns_;
  std::string buffer_;  // whole rows that are not in the file yet
  std::int64_t rows_ = 0;
  bool closed_ = false;
  std::chrono::steady_clock::time_point last_flush_ = std::chrono::steady_clock::now();
};

}  // namespace dda
