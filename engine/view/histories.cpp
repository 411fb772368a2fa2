#include "engine/view/histories.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/csv.h"

namespace dda {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& value) {
  throw InputError(path.string(), "the file", value, "the measurements that dda run writes; run the scene again");
}

// "NAME [UNIT]".
HistoryColumn column_of(const std::string& heading) {
  const std::size_t bracket = heading.rfind(" [");
  if (bracket == std::string::npos || !heading.ends_with(']')) return {heading, "-", {}};
  return {heading.substr(0, bracket), heading.substr(bracket + 2, heading.size() - bracket - 3), {}};
}

}  // namespace

Histories read_histories(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  std::string_view text = file;
  if (!text.starts_with("time [s]")) refuse(path, "without the header \"time [s],...\"");
  Histories histories;
  std::string cell;
  for (bool last = take_csv_cell(text, cell); !last;) {
    last = take_csv_cell(text, cell);
    histories.columns.push_back(column_of(cell));
  }
  while (!text.empty()) {
    std::size_t place = 0;
    for (bool last = false; !last; ++place) {
      last = take_csv_cell(text, cell);
      const auto value = csv_number(cell);
      if (!value || std::isinf(*value)) refuse(path, "damaged (\"" + cell + "\")");
      if (place > histories.columns.size()) refuse(path, "damaged (a row is too long)");
      (place == 0 ? histories.times : histories.columns[place - 1].values).push_back(*value);
    }
    if (place != histories.columns.size() + 1) refuse(path, "damaged (a row is too short)");
  }
  return histories;
}

Histories thinned(const Histories& histories, std::size_t rows) {
  const std::size_t all = histories.times.size();
  if (all <= rows) return histories;
  const std::size_t stretches = rows / 2;
  Histories result;
  for (const HistoryColumn& column : histories.columns) result.columns.push_back({column.name, column.unit, {}});
  for (std::size_t i = 0; i < stretches; ++i) {
    const std::size_t begin = i * all / stretches;
    const std::size_t end = (i + 1) * all / stretches;
    result.times.insert(result.times.end(), {histories.times[begin], histories.times[end - 1]});
    for (std::size_t c = 0; c < histories.columns.size(); ++c) {
      const auto& values = histories.columns[c].values;
      const auto [least, greatest] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                         values.begin() + static_cast<std::ptrdiff_t>(end));
      result.columns[c].values.insert(result.columns[c].values.end(),
                                      {least < greatest ? *least : *greatest, least < greatest ? *greatest : *least});
    }
  }
  return result;
}

}  // namespace dda
