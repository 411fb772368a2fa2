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

namespace dda {
namespace {

constexpr std::size_t buffer_size = 1 << 16;
constexpr auto flush_interval = std::chrono::seconds(1);

std::string quoted_if_needed(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string header(const std::vector<Column>& columns) {
  std::string line = "time [s]";
  for (const Column& column : columns) {
    line += ',' + quoted_if_needed(column.name + " [" + (column.unit.empty() ? "-" : column.unit) + "]");
  }
  return line + '\n';
}

// Header and first `rows` rows of the file, or nothing when it has not got them.
std::optional<std::string> beginning_of(const std::filesystem::path& path, const std::string& header,
                                        std::int64_t rows) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
  std::string text = read_file(path);
  if (!text.starts_with(header)) return std::nullopt;
  std::size_t end = header.size();
  for (std::int64_t row = 0; row < rows; ++row) {
    const std::size_t line_break = text.find('\n', end);
    if (line_break == std::string::npos) return std::nullopt;
    end = line_break + 1;
  }
  text.resize(end);
  return text;
}

std::string kept_beginning(const std::filesystem::path& path, const std::string& header, std::int64_t rows) {
  std::filesystem::path left_over = path;
  left_over += ".tmp";
  for (const auto& candidate : {left_over, path}) {
    if (auto beginning = beginning_of(candidate, header, rows)) return *std::move(beginning);
  }
  throw InputError(path.string(), "the history to go on with", "missing, of other measurements or too short",
                   fmt::format("a file with {} rows of this scene's measurements", rows));
}

}  // namespace

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::vector<Column>& columns)
    : HistoryWriter(std::move(path), columns.size(), header(columns), 0) {}

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<Column>& columns, std::int64_t rows)
    : HistoryWriter(path, columns.size(), kept_beginning(path, header(columns), rows), rows) {}

HistoryWriter::HistoryWriter(std::filesystem::path path, std::size_t columns, const std::string& beginning,
                             std::int64_t rows)
    : file_(std::move(path)), columns_(columns), rows_(rows), last_flush_(std::chrono::steady_clock::now()) {
  buffer_.reserve(buffer_size + 32 * (columns_ + 1));
  file_.write(beginning);
}

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
