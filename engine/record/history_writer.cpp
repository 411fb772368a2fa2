#include "engine/record/history_writer.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <exception>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/csv.h"

namespace dda {
namespace {

constexpr std::size_t buffer_size = 1 << 16;
constexpr auto flush_interval = std::chrono::seconds(1);

std::string header(const std::vector<Column>& columns) {
  std::string line = "time [s]";
  for (const Column& column : columns) {
    line += ',' + csv_cell(column.name + " [" + (column.unit.empty() ? "-" : column.unit) + "]");
  }
  return line + '\n';
}

// Bytes of the header and the first `rows` rows of the file, or nothing when it has not got them.
std::optional<std::int64_t> beginning_of(const std::filesystem::path& path, const std::string& header,
                                         std::int64_t rows) {
  if (!why_unwritable(path).empty() || !why_unreadable(path).empty()) return std::nullopt;
  const std::string text = read_file(path);
  if (!text.starts_with(header)) return std::nullopt;
  std::size_t end = header.size();
  for (std::int64_t row = 0; row < rows; ++row) {
    const std::size_t line_break = text.find('\n', end);
    if (line_break == std::string::npos) return std::nullopt;
    end = line_break + 1;
  }
  return static_cast<std::int64_t>(end);
}

// Bytes of NAME.tmp to go on behind. Of a run that was stopped in order the rows are in NAME, which becomes NAME.tmp
// again; of one broken off after that, NAME holds the rows of a part of the run and goes. So a kill at any moment
// leaves a file with the rows that the checkpoint counts.
std::int64_t kept_bytes(const std::filesystem::path& path, const std::string& header, std::int64_t rows) {
  std::filesystem::path left_over = path;
  left_over += ".tmp";
  if (const auto bytes = beginning_of(left_over, header, rows)) {
    std::filesystem::remove(path);
    return *bytes;
  }
  const auto bytes = beginning_of(path, header, rows);
  if (!bytes)
    throw InputError(path.string(), "the history to go on with", "missing, of other measurements or too short",
                     fmt::format("a file with {} rows of this scene's measurements", rows));
  std::filesystem::rename(path, left_over);
  return *bytes;
}

}  // namespace

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::vector<Column>& columns)
    : file_(std::move(path)), columns_(columns.size()) {
  reserve_buffer();
  file_.write(header(columns));
}

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<Column>& columns, std::int64_t rows)
    : file_(path, kept_bytes(path, header(columns), rows)), columns_(columns.size()), rows_(rows) {
  reserve_buffer();
}

void HistoryWriter::reserve_buffer() { buffer_.reserve(buffer_size + 32 * (columns_ + 1)); }

HistoryWriter::~HistoryWriter() {
  if (closed_) return;
  try {
    flush();
  } catch (const std::exception&) {  // the rows already in the file can still be kept
  }
  try {
    file_.commit();
  } catch (const std::exception&) {  // nothing more can be done here; who wants to know calls close()
  }
}

void HistoryWriter::append(double time, std::span<const double> values) {
  if (closed_) throw std::logic_error("HistoryWriter: append after close");
  if (values.size() != columns_) throw std::invalid_argument("HistoryWriter: number of values and columns differ");
  write_number(time);
  for (const double value : values) {
    buffer_ += ',';
    write_number(value);
  }
  buffer_ += '\n';
  ++rows_;
  flush_when_due();
}

void HistoryWriter::write_number(double value) {
  std::array<char, 32> text;  // the longest double is -2.2250738585072014e-308
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  buffer_.append(text.data(), end);
}

void HistoryWriter::flush_when_due() {
  if (buffer_.size() < buffer_size && std::chrono::steady_clock::now() - last_flush_ < flush_interval) return;
  flush();
}

void HistoryWriter::flush() {
  file_.write(buffer_);
  buffer_.clear();
  last_flush_ = std::chrono::steady_clock::now();
}

void HistoryWriter::close() {
  if (closed_) return;
  flush();
  file_.commit();
  closed_ = true;
}

}  // namespace dda
