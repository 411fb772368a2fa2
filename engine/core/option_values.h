// Values of options on a command line, for the programs of this project.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace dda {

// What is wrong with `text` as a value, in words that end a sentence "--out: ...", or nothing.
inline std::string why_no_value(const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return "is empty, expected a value";
  if (text.starts_with("--")) return "is \"" + text + "\", which looks like an option, expected a value";
  return "";
}

// A shell makes an empty value of a variable that is not set, or leaves none, so that the next option is taken for it.
// Refuses both for every option and every name of a file of all commands; to be called when all of them are there.
inline void expect_values(CLI::App& app) {
  const CLI::Validator is_given([](std::string& text) { return why_no_value(text); }, "");
  for (CLI::Option* option : app.get_options()) {
    const bool takes_values = option->get_items_expected_max() > 0;
    if (takes_values) option->transform(is_given);  // comes before all else that is asked of a value
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) expect_values(*command);
}

// "--out=" with nothing behind it, for which the library would take the next argument. Throws CLI::ValidationError.
inline void refuse_values_left_out(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (!argument.starts_with("--") || argument.find('=') + 1 != argument.size()) continue;
    throw CLI::ValidationError(std::string(argument.substr(0, argument.size() - 1)), "is empty, expected a value");
  }
}

}  // namespace dda
