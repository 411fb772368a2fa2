// dda-calibrate: what `dda-verify calibrate` does, in a program that needs no verification case and is soon compiled.
#include "verification/app/program.h"

int main(int argc, char** argv) {
  CLI::App app(verify::calibrate_description, "dda-calibrate");
  verify::CalibrateCommand calibrate;
  verify::add_calibrate_options(app, calibrate);
  return verify::run_program(app, argc, argv, [&calibrate] { return verify::calibrate(calibrate); });
}
