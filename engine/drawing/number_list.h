// Numbers of a text, one after the other, with blanks, commas or ends of lines between them, and on which line each is:
// what the programs of the original DDA read and write.
#pragma once

#include <string>
#include <string_view>

namespace dda {

class NumberList {
 public:
  // Keeps references to both.
  NumberList(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  // "plan.dc line 3", of what was read last.
  [[nodiscard]] std::string here() const;

  [[nodiscard]] bool at_end();

  // Up to the next blank; empty at the end.
  std::string_view word();

  // Throws InputError, as do the next two, where the text ends or another word stands; `what` is what is read, for the
  // message.
  double number(const char* what);

  // From `least` to 1,000,000.
  int whole(const char* what, int least = 0);

  void expect_end(const char* behind, const char* expected);

 private:
  void skip_blanks();

  std::string_view rest_;
  const std::string& name_;
  int line_ = 1;
};

}  // namespace dda
