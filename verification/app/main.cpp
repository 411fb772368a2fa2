// dda-verify: the verification studies from the command line.
#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>

#include "dda/core/error.h"
#include "verification/thesis/calibrate_command.h"

namespace {

constexpr int failed = 1;
constexpr int bad_input = 2;

int run(int argc, char** argv) {
  CLI::App app("Verification studies of the dda engine.", "dda-verify");
  app.require_subcommand(1);
  verify::CalibrateCommand command;
  CLI::App* calibrate = app.add_subcommand(
      "calibrate",
      "The P wave of Zelig (2015), chapter 3: Tables 3.2 and 3.3 from this engine, beside the printed numbers, its "
      "accurate scheme and the closed form of the discrete problem.\nWrites calibration.json, calibration.md, "
      "calibration.html and plots/. Exit code 1 if a promised accuracy is not met.");
  calibrate->add_option("--out", command.folder, "folder of the report; made if it is not there")->required();
  calibrate->add_flag("--quick", command.quick, "the time step of 0.1 ms only, each run once");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  }
  return verify::calibrate(command);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const dda::InputError& error) {
    std::cerr << "dda-verify: " << error.what() << "\n";
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "dda-verify: " << error.path1().string() << ": " << error.code().message() << "\n";
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << "dda-verify: " << error.what() << "\n";
    return failed;
  }
}
