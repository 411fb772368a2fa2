#include "engine/core/printed.h"

#include <ostream>

namespace dda {

int exit_code_once_printed(int code, const std::string& program, std::ostream& out, std::ostream& errors) {
  if (out.flush()) return code;
  errors << program << ": standard output could not be written in full\n";
  return code == 0 ? 1 : code;
}

}  // namespace dda
