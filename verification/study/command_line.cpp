#include "verification/study/command_line.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <ostream>

#include "engine/core/error.h"
#include "engine/core/option_values.h"
#include "engine/core/printed.h"

namespace verify {
namespace {

constexpr int failed = 1;
constexpr int bad_input = 2;

struct AddOption {
  CLI::App& app;
  const CommandOption& option;

  CLI::Option* operator()(bool* target) const { return app.add_flag(option.name, *target, option.help); }

  template <typename Value>
  CLI::Option* operator()(Value* target) const {
    return app.add_option(option.name, *target, option.help);
  }

  template <typename Value>
  CLI::Option* operator()(std::vector<Value>* target) const {
    return app.add_option(option.name, *target, option.help)->allow_extra_args(false);
  }
};

CLI::Range range_of(const CommandOption& option) {
  const auto [least, most] = *option.range;
  if (std::holds_alternative<double*>(option.target)) return {least, most};
  return {static_cast<int>(least), static_cast<int>(most)};
}

void require_one_of(CLI::App& app, CLI::Option* first, CLI::Option* second) {
  second->excludes(first);
  app.callback([first, second] {
    if (first->count() + second->count() == 0) throw CLI::RequiredError(first->get_name());
  });
}

void add_option(CLI::App& app, const CommandOption& option) {
  CLI::Option* added = std::visit(AddOption{app, option}, option.target);
  if (option.required) added->required();
  if (option.shows_default) added->capture_default_str();
  if (option.positive) added->check(CLI::PositiveNumber);
  if (option.range) added->check(range_of(option));
  if (!option.kind.empty()) added->type_name(option.kind);
  if (!option.instead_of.empty()) require_one_of(app, app.get_option(option.instead_of), added);
}

void add_options(CLI::App& app, const StudyCommand& command) {
  for (const CommandOption& option : command.options) add_option(app, option);
}

void add_commands(CLI::App& app, const std::vector<StudyCommand>& commands) {
  if (commands.size() == 1) return add_options(app, commands.front());
  app.require_subcommand(1);
  for (const StudyCommand& command : commands)
    add_options(*app.add_subcommand(command.name, command.description), command);
}

const StudyCommand& chosen(const CLI::App& app, const std::vector<StudyCommand>& commands) {
  for (const StudyCommand& command : commands)
    if (commands.size() > 1 && app.got_subcommand(command.name)) return command;
  return commands.front();
}

int obey(const std::string& name, const std::string& description, const std::vector<StudyCommand>& commands, int argc,
         const char* const* argv, std::ostream& out, std::ostream& errors) {
  CLI::App app(description, name);
  const auto say = [&](const std::string& why) { errors << name << ": " << why << "\n"; };
  add_commands(app, commands);
  dda::expect_values(app);
  try {
    dda::refuse_values_left_out(argc, argv);
    app.parse(argc, argv);
    return chosen(app, commands).carry_out({std::filesystem::canonical("/proc/self/exe"), out, errors});
  } catch (const CLI::Success& request) {
    return app.exit(request, out, errors);
  } catch (const CLI::ParseError& error) {
    say(std::string(error.what()) + "; " + name + " --help says more");
    return bad_input;
  } catch (const dda::InputError& error) {
    say(error.what());
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    say(error.path1().string() + ": " + error.code().message());
    return bad_input;
  } catch (const std::exception& error) {
    say(error.what());
    return failed;
  }
}

}  // namespace

int run_command_line(const std::string& name, const std::string& description, const std::vector<StudyCommand>& commands,
                     int argc, const char* const* argv, std::ostream& out, std::ostream& errors) {
  const int code = obey(name, description, commands, argc, argv, out, errors);
  return dda::exit_code_once_printed(code, name, out, errors);
}

}  // namespace verify
