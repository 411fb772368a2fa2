// Recordings from files: CSV with a header, one row a sample.
//
//   # lines that start with # and blank lines are skipped
//   t [s], ax [g], ay [g]
//   0, 0, 0
//   0.005, 0.0012, -0.0003
//
// Columns are separated by commas, semicolons or tabs, whichever the header has; where not by commas, numbers may have
// decimal commas. A column's unit may stand behind its
// name in [] or (). Line ends of either kind, a byte order mark and quotes around names are accepted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

#include "engine/core/quantity.h"
#include "engine/model/recording.h"

namespace dda {

// The unit of plain factors.
inline constexpr auto no_unit = "-";

// What to take out of a file.
struct RecordRequest {
  std::filesystem::path file = {};
  std::string time = {};        // name of the column; empty: the first
  std::string value = {};       // name of the column; empty: the second, where there are just two
  std::string time_unit = {};   // empty: as in the header, or else s
  std::string value_unit = {};  // empty: as in the header, or else values are plain factors, as by "-"
  Dimension dimension = Dimension::dimensionless;  // of the values, where they have a unit
  double scale = 1;
  bool correct_baseline = false;
  double acts_from = -std::numeric_limits<double>::infinity();  // s on its clock: what comes before has no baseline
  std::size_t most_samples = 10'000'000;                        // which take 320 MB
};

// Reads a recording, in SI where it has a unit. Throws InputError (without a file) whose field is `place` followed by
// the file's name, line and column: for files that are missing, empty, too large or no CSV, columns that are missing or
// named twice, unknown units, values that are no finite number, times that do not increase, and fewer than two samples.
Recording read_record(const RecordRequest& request, const std::string& place);

}  // namespace dda
