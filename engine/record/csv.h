// Cells of comma-separated tables, as RFC 4180 quotes them: written and read back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dda {

// The text as a cell: in quotation marks where it holds a comma, a quotation mark or the end of a line.
[[nodiscard]] std::string csv_cell(const std::string& text);

// Takes the next cell of a line that ends in '\n' off `text`. True when it is the line's last.
bool take_csv_cell(std::string_view& text, std::string& cell);

// Takes the next line off `text`.
[[nodiscard]] std::vector<std::string> take_csv_row(std::string_view& text);

// Nothing if the cell holds anything but one number.
[[nodiscard]] std::optional<double> csv_number(std::string_view cell);

}  // namespace dda
