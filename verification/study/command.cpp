#include "verification/study/command.h"

namespace verify {

CommandOption out_folder(std::filesystem::path& target, const std::string& help) {
  return {.name = "--out", .target = &target, .help = help, .required = true};
}

CommandOption jobs_at_once(int& target, const std::string& help) {
  return {.name = "--jobs", .target = &target, .help = help, .positive = true};
}

void add_lots(std::uint64_t& seed, const std::string& one, int& count, std::vector<CommandOption>& options) {
  options.push_back({.name = "--seed",
                     .target = &seed,
                     .help = "of the first " + one + "; the others follow",
                     .shows_default = true});
  options.push_back({.name = "--count", .target = &count, .help = one + "s", .shows_default = true, .positive = true});
}

}  // namespace verify
