// What the programs of this folder share: the command line of `calibrate`, and how a command line becomes an exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "engine/core/error.h"
#include "engine/core/option_values.h"
#include "verification/thesis/calibrate_command.h"

namespace verify {

inline constexpr int failed = 1;
inline constexpr int bad_input = 2;

inline constexpr const char* calibrate_description =
    "The P wave of Zelig (2015), chapter 3: Tables 3.2 and 3.3 from this engine, beside the printed numbers, its "
    "accurate scheme and the closed form of the discrete problem.\nWrites calibration.json, calibration.md, "
    "calibration.html and plots/. Exit code 1 if a promised accuracy is not met.";

inline void add_calibrate_options(CLI::App& command, CalibrateCommand& calibrate) {
  command.add_option("--out", calibrate.folder, "folder of the report; made if it is not there")->required();
  command.add_flag("--quick", calibrate.quick, "the time step of 0.1 ms only, each run once");
}

// Parses the command line, calls carry_out() for the exit code, and answers what they throw with a sentence that begins
// with the program's name.
template <class CarryOut>
int run_program(CLI::App& app, int argc, char** argv, const CarryOut& carry_out) {
  const auto say = [&app](const std::string& why) { std::cerr << app.get_name() << ": " << why << "\n"; };
  dda::expect_values(app);
  try {
    dda::refuse_values_left_out(argc, argv);
    app.parse(argc, argv);
    return carry_out();
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    say(std::string(error.what()) + "; " + app.get_name() + " --help says more");
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

}  // namespace verify
