// Errors of input: one sentence naming file, field, value and what was expected. The programs print it and exit with 2.
#pragma once

#include <stdexcept>
#include <string>

#include "engine/core/types.h"

namespace dda {

class InputError : public std::runtime_error {
 public:
  // The sentence reads "FILE: FIELD is VALUE, expected EXPECTED"; leave `file` empty where it is not known yet.
  InputError(const std::string& file, std::string field, std::string value, std::string expected);

  // The same error, now that the file it came from is known.
  [[nodiscard]] InputError in_file(const std::string& file) const;

  [[nodiscard]] const std::string& field() const { return field_; }
  [[nodiscard]] const std::string& value() const { return value_; }
  [[nodiscard]] const std::string& expected() const { return expected_; }

 private:
  std::string field_;
  std::string value_;
  std::string expected_;
};

// A point as a sentence writes it: "(1, 2.5) m".
std::string written(const Vec2& point);

}  // namespace dda
