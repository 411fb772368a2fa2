// The lowest level of a DXF file: pairs of lines, a code that says what it is and a value.
#pragma once

#include <string>
#include <string_view>

namespace dda {

struct DxfGroup {
  int code = 0;
  std::string_view value;  // without blanks around it
  std::size_t line = 0;    // of the value, from 1
};

class DxfGroups {
 public:
  // `text` must outlive the groups; `name` is that of the file, for messages.
  DxfGroups(std::string_view text, std::string name);

  // The next group; comments are passed over. Throws InputError at the end of the text: a DXF file ends with EOF.
  DxfGroup next();

  // "NAME line LINE"
  [[nodiscard]] std::string place(std::size_t line) const;
  [[noreturn]] void fail(const DxfGroup& group, const std::string& value, const std::string& expected) const;

 private:
  std::string_view next_line();

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 0;
};

}  // namespace dda
