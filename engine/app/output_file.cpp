#include "engine/app/output_file.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"

namespace dda {
namespace {

// A folder may be there in which no file can be made, as those below /proc: only trying tells.
void try_to_write(const std::filesystem::path& file) {
  try {
    const AtomicFile trial(file);
  } catch (const std::runtime_error& error) {
    throw InputError("", "--out", fmt::format("{}, where nothing can be written ({})", file.string(), error.what()),
                     "a name in a folder that can be written to");
  }
}

}  // namespace

void expect_output(const std::filesystem::path& file, const std::filesystem::path& folder_of_run) {
  const bool lies_in_run = file == folder_of_run / file.filename();
  if (!lies_in_run && !std::filesystem::is_directory(std::filesystem::absolute(file).parent_path()))
    throw InputError("", "--out", file.string(), "a name in a folder that exists");
  if (const std::string kind = why_unwritable(file); !kind.empty())
    throw InputError("", "--out", file.string() + ", which is " + kind, "a file, or a name that is free");
  if (!lies_in_run || std::filesystem::is_directory(folder_of_run)) try_to_write(file);
}

}  // namespace dda
