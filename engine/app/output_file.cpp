#include "engine/app/output_file.h"

#include <string>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"

namespace dda {

void expect_output(const std::filesystem::path& file, const std::filesystem::path& folder_of_run) {
  const bool lies_in_run = file == folder_of_run / file.filename();
  if (!lies_in_run && !std::filesystem::is_directory(std::filesystem::absolute(file).parent_path()))
    throw InputError("", "--out", file.string(), "a name in a folder that exists");
  if (const std::string kind = why_unwritable(file); !kind.empty())
    throw InputError("", "--out", file.string() + ", which is " + kind, "a file, or a name that is free");
}

}  // namespace dda
