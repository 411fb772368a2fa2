// How a study says what it is on the command line: a name, what it does, its options, and what carries it out. It says
// so beside its code; the programs list their commands and know no option.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace verify {

// What a command is given besides its options.
struct Surroundings {
  std::filesystem::path program;  // the file that runs
  std::ostream& out;
  std::ostream& errors;
};

// Where the value of an option goes. A flag is a bool that becomes true.
using OptionTarget = std::variant<bool*, int*, std::uint64_t*, double*, std::filesystem::path*, std::vector<int>*,
                                  std::vector<std::string>*>;

struct CommandOption {
  std::string
      name;  // "--out", or "spec" for what is told by its place; what comes in a list may be given several times
  OptionTarget target;
  std::string help;

  bool required = false;
  bool shows_default = false;
  bool positive = false;                                // a number above zero
  std::optional<std::pair<double, double>> range = {};  // of a number, both ends included
  std::string kind = {};                                // what --help calls the value, if anything special
  std::string instead_of = {};                          // an earlier option: one of the two must be given, not both
};

// The folder that all files of a study go to.
[[nodiscard]] CommandOption out_folder(std::filesystem::path& target,
                                       const std::string& help = "folder for all files; made if it is not there");

// How many jobs run at once.
[[nodiscard]] CommandOption jobs_at_once(int& target, const std::string& help);

// What is drawn by lot, a `one` for each seed: the first of them and how many.
void add_lots(std::uint64_t& seed, const std::string& one, int& count, std::vector<CommandOption>& options);

struct StudyCommand {
  std::string name;
  std::string description;
  std::vector<CommandOption> options;
  std::function<int(const Surroundings&)> carry_out;  // gives the exit code: 0, or 1 if the study finds something wrong
};

// A command whose options fill `Arguments`: `options_of(arguments)` lists them, and `carry_out(arguments,
// surroundings)` is called when they are read.
template <typename Arguments, typename OptionsOf, typename CarryOut>
[[nodiscard]] StudyCommand study_command(std::string name, std::string description, const OptionsOf& options_of,
                                         const CarryOut& carry_out) {
  const auto arguments = std::make_shared<Arguments>();
  return {std::move(name), std::move(description), options_of(*arguments),
          [arguments, carry_out](const Surroundings& surroundings) { return carry_out(*arguments, surroundings); }};
}

}  // namespace verify
