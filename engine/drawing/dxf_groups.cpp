#include "engine/drawing/dxf_groups.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/line_drawing.h"
#include "engine/drawing/number_text.h"

namespace dda {
namespace {

constexpr int comment = 999;
constexpr std::size_t most_shown = 40;  // bytes of a value, in a message

}  // namespace

DxfGroups::DxfGroups(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {
  constexpr const char* expected = "DXF as text; programs offer it as \"ASCII DXF\"";
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  if (rest_.starts_with("AutoCAD Binary DXF")) throw InputError("", name_, "binary DXF", expected);
  if (rest_.starts_with("AC10")) throw InputError("", name_, "a DWG file", expected);
}

DxfGroup DxfGroups::next() {
  while (true) {
    const std::string_view code_text = next_line();
    const std::optional<int> code = number_in<int>(code_text);
    if (!code)
      throw InputError("", place(line_), "\"" + readable(code_text.substr(0, most_shown)) + "\"",
                       "a group code of DXF, which is a whole number");
    const std::string_view value = next_line();
    if (*code != comment) return {*code, value, line_};
  }
}

std::string_view DxfGroups::next_line() {
  if (rest_.empty())
    throw InputError("", place(line_), "the last one", "more, up to EOF: the file is cut off, or no DXF");
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  return without_blanks(line);
}

std::string DxfGroups::place(std::size_t line) const { return fmt::format("{} line {}", name_, line); }

void DxfGroups::fail(const DxfGroup& group, const std::string& value, const std::string& expected) const {
  throw InputError("", place(group.line), value, expected);
}

}  // namespace dda
