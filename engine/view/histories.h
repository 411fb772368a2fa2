// The measurements of a run, read back from histories.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dda {

struct HistoryColumn {
  std::string name;
  std::string unit;  // "-" for a number without one
  std::vector<double> values;
};

struct Histories {
  std::vector<double> times;  // s
  std::vector<HistoryColumn> columns;
};

// InputError naming the file when it is not what HistoryWriter writes.
Histories read_histories(const std::filesystem::path& path);

// At most `rows` rows (an even number), for a plot: of every stretch of rows the least and the greatest value of each
// column in the order in which they came, so that no peak is lost; their times are moved within the stretch.
Histories thinned(const Histories& histories, std::size_t rows);

}  // namespace dda
