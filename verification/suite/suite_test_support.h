// Cases for the tests of this folder.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/suite/case.h"

namespace verify {

inline Assertion assertion_of(double value, double reference, double tolerance) {
  return {"slip", "m", value, reference, "g t^2/2", relative_error(value, reference), tolerance, "theory"};
}

inline Case case_of(const std::string& id, const std::vector<Assertion>& assertions, CaseLabel label = CaseLabel::fast,
                    std::vector<int> catalogue = {9}) {
  dda::Counters counters;
  counters.steps = 7;
  counters.contact_state_changes = 3;
  return {id, "Title of " + id, std::move(catalogue), label, [assertions, counters] {
            return Outcome{assertions, counters};
          }};
}

// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dda_suite_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace verify
