#include "engine/scene/place_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dda {

GridAxis::GridAxis(const Field& field) {
  for (const Field& item : field.items()) {
    const double coordinate = item.quantity(Dimension::length);
    if (!coordinates_.empty() && coordinate <= coordinates_.back()) item.fail("more than the one before");
    coordinates_.push_back(coordinate);
  }
}

std::optional<GridAxis::Place> GridAxis::find(double wanted, double slack) const {
  if (coordinates_.size() == 1) return Place{0, 0};
  const double coordinate = std::clamp(wanted, coordinates_.front(), coordinates_.back());
  if (std::abs(wanted - coordinate) > slack) return {};
  const auto above = std::upper_bound(coordinates_.begin() + 1, coordinates_.end() - 1, coordinate);
  const double last = *(above - 1);
  return Place{static_cast<std::size_t>(above - coordinates_.begin()) - 1, (coordinate - last) / (*above - last)};
}

PlaceTable::PlaceTable(const Field& field, const GridAxis& x, const GridAxis& y, Dimension dimension) {
  const std::vector<Field> rows = field.items();
  if (rows.size() != y.size())
    field.fail(fmt::format("{} rows", rows.size()), fmt::format("one for each of the {} values of y", y.size()));
  for (const Field& row : rows) {
    const std::vector<Field> values = row.items();
    if (values.size() != x.size())
      row.fail(fmt::format("{} values", values.size()), fmt::format("one for each of the {} values of x", x.size()));
    std::vector<double>& own = rows_.emplace_back();
    for (const Field& value : values) own.push_back(value.quantity(dimension));
  }
}

double PlaceTable::at(const GridAxis::Place& x, const GridAxis::Place& y) const {
  const auto along_row = [&](const std::vector<double>& row) {
    return x.share == 0 ? row[x.index] : std::lerp(row[x.index], row[x.index + 1], x.share);
  };
  const double below = along_row(rows_[y.index]);
  return y.share == 0 ? below : std::lerp(below, along_row(rows_[y.index + 1]), y.share);
}

}  // namespace dda
