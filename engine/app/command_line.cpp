#include "engine/app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "engine/app/advise_command.h"
#include "engine/app/command_details.h"
#include "engine/app/cut_command.h"
#include "engine/app/fos_command.h"
#include "engine/app/keyblocks_command.h"
#include "engine/app/reaction_command.h"
#include "engine/app/report_command.h"
#include "engine/app/run_command.h"
#include "engine/app/run_options.h"
#include "engine/app/scene_report.h"
#include "engine/app/spectrum_command.h"
#include "engine/app/view_command.h"
#include "engine/core/error.h"
#include "engine/core/option_values.h"
#include "engine/core/quantity.h"
#include "engine/core/read_file.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_parts.h"
#include "engine/scene/scene_schema.h"

namespace dda {
namespace {

constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

// In SI units. Far beyond what is of use, and near enough that what is computed from it, such as the size of a block
// for a wavelength, stays a sensible number.
struct Range {
  double least, greatest;
};
constexpr Range frequencies{1e-6, 1e9};
constexpr Range lengths{1e-6, 1e9};
constexpr Range times{1e-12, 1e12};
// Errors of waves that are asked for: what is predicted of a wave that is all wrong says nothing.
constexpr Range errors_wanted{1e-9, 0.99};

// A positive number in SI or with a unit, as in scenes.
double positive_quantity(const std::string& text, Dimension dimension, const Range& range, const char* option) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool plain = error == std::errc() && end == text.data() + text.size();
  if (!plain) value = parse_quantity(text, dimension, option);
  if (value >= range.least && value <= range.greatest) return value;
  const std::string_view unit = si_unit(dimension);
  throw InputError("", option, text,
                   fmt::format("{}, from {:g} to {:g}{}{}", expected_quantity(dimension), range.least, range.greatest,
                               unit.empty() ? "" : " ", unit));
}

// For options that count; the library's own range check prints the limits of its number type.
CLI::Validator whole_number(std::int64_t most, const std::string& expected) {
  return CLI::Validator(
      [=](const std::string& text) {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = error == std::errc() && end == text.data() + text.size() && value >= 1 && value <= most;
        return good ? std::string() : "is \"" + text + "\", expected a whole number " + expected;
      },
      "");
}
const CLI::Validator positive_count = whole_number(std::numeric_limits<std::int64_t>::max(), "above 0");
// More than any machine has would only be a slip.
const CLI::Validator number_of_threads = whole_number(1024, "from 1 to 1024");

// A finite number within bounds, which also keep what is computed from it within the range of its type.
CLI::Validator number_from(double least, double greatest) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good =
            error == std::errc() && end == text.data() + text.size() && value >= least && value <= greatest;
        return good ? std::string()
                    : fmt::format("is \"{}\", expected a number from {:g} to {:g}", text, least, greatest);
      },
      "");
}

struct Arguments {
  std::string scene;
  std::string folder;
  std::string frequency;
  std::string frame_interval;
  std::string checkpoint_interval;
  std::int64_t frames = 0;
  std::string distance;
  std::string wanted_error;
  bool json = false;
  RunOptions run;
  CutRequest cut;
  ViewOptions view;
  ReportOptions report;
  SpectrumRequest spectrum;
  KeyBlocksRequest key_blocks;
  FosRequest fos;
  ReactionRequest reaction;
};

void add_check(CLI::App& app, Arguments& arguments) {
  CLI::App* check = app.add_subcommand("check", "Validate a scene and print what will be run")->footer(check_details);
  check->add_option("scene", arguments.scene, "scene file (JSON)")->required()->type_name("SCENE.json");
  check
      ->add_option("--frequency", arguments.frequency,
                   "of the waves to predict, e.g. 100Hz; default: target_frequency, or the highest sine")
      ->type_name("FREQUENCY");
}

void add_advise(CLI::App& app, Arguments& arguments) {
  CLI::App* advise =
      app.add_subcommand("advise", "Say how wrong waves will be and why, and what it costs")->footer(advise_details);
  advise->add_option("scene", arguments.scene, "scene file (JSON)")->required()->type_name("SCENE.json");
  advise
      ->add_option("--frequency", arguments.frequency,
                   "of a steady wave, e.g. 100Hz; default: the history of the first load that has one")
      ->type_name("FREQUENCY");
  advise
      ->add_option("--distance", arguments.distance,
                   "that the wave runs, e.g. 50m; default: to the farthest measurement, or a wavelength")
      ->type_name("LENGTH");
  advise->add_option("--error", arguments.wanted_error, "error of speed and amplitude to be kept; default 1%")
      ->type_name("SHARE");
  advise->add_flag("--json", arguments.json, "write JSON for programs");
}

void add_run(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand("run", "Run a scene into a folder of results")->footer(run_details);
  run->add_option("scene", arguments.scene, "scene file (JSON)")->required()->type_name("SCENE.json");
  run->add_option("--out", arguments.folder, "folder for the results; made if need be")->required()->type_name("DIR");
  CLI::Option* frames =
      run->add_option("--frames", arguments.frames, "number of frames over the run, besides that of the start")
          ->type_name("N")
          ->check(positive_count);
  run->add_option("--frame-interval", arguments.frame_interval, "simulated time between frames, e.g. 5ms")
      ->type_name("TIME")
      ->excludes(frames);
  run->add_option("--every", arguments.run.rows_every,
                  "steps between the rows of histories.csv, which has the end of each stage too; default 1")
      ->type_name("K")
      ->check(positive_count);
  run->add_option("--checkpoint-interval", arguments.checkpoint_interval,
                  "time on the clock between checkpoints; default 10s")
      ->type_name("TIME");
  run->add_option("--from", arguments.run.from,
                  "begin where a run of the same blocks was at the end of a stage, its last by default")
      ->type_name("DIR[:STAGE]");
  run->add_flag("--resume", arguments.run.resume, "go on from DIR/checkpoint.bin, to the last bit as if never stopped");
  run->add_option("--threads", arguments.run.threads, "that share the work; default one a core; same results with any")
      ->type_name("N")
      ->check(number_of_threads);
  run->add_flag("--profile", arguments.run.profile,
                "say where the time went, and write DIR/profile.json for trace viewers");
  run->add_flag("--quiet", arguments.run.quiet, "no progress bar, and nothing on standard output");
}

void add_view(CLI::App& app, Arguments& arguments) {
  ViewOptions& options = arguments.view;
  CLI::App* view = app.add_subcommand("view", "Show a run that has frames, as a page or a picture, or a scene")
                       ->footer(view_details);
  view->add_option("folder", options.folder, "what dda run --frames wrote; a scene file or a drawing is drawn as it is")
      ->required()
      ->type_name("DIR|SCENE.json|DRAWING");
  view->add_option("--out", options.file, "the file to write; default DIR/view.html, of a scene SCENE.view.svg")
      ->type_name("FILE");
  view->add_option("--quantity", options.quantity, "what blocks are coloured by; default mean_stress")
      ->type_name("NAME");
  view->add_option("--max-size", options.most_megabytes, "largest page in MB; default 50; longer runs are thinned")
      ->type_name("MB")
      ->check(number_from(0.01, 1e6));
  view->add_option("--svg", options.svg_frame, "a picture (SVG) of this frame, from 0, or last")->type_name("FRAME");
  view->add_option("--forces", options.forces, "contact forces in the picture: joints (default), contacts, none")
      ->type_name("KIND");
  view->add_flag("--crosses", options.crosses, "principal stresses in the picture");
  view->add_option("--deformation-scale", options.deformation_scale, "factor on all motion in the picture; default 1")
      ->type_name("FACTOR")
      ->check(number_from(0, 1e12));
  view->add_option("--window", options.window, "part of the plane in the picture, m; default: all blocks")
      ->type_name("LEFT,BOTTOM,RIGHT,TOP")
      ->delimiter(',');
  add_drawing_options(*view, options.drawing);
}

// The names of the options that stand on the command line.
std::vector<std::string> given_options(const CLI::App& command) {
  std::vector<std::string> given;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0) given.push_back(option->get_name());
  return given;
}

void add_report(CLI::App& app, ReportOptions& options) {
  CLI::App* report = app.add_subcommand("report", "Write what came of a run on one page")->footer(report_details);
  report->add_option("folder", options.folder, "what dda run wrote")->required()->type_name("DIR");
  report->add_option("--out", options.file, "the file to write; default DIR/report.html")->type_name("FILE");
}

void add_cut(CLI::App& app, Arguments& arguments) {
  CLI::App* cut = app.add_subcommand("cut", "Cut the rock of a scene or a drawing into blocks")->footer(cut_details);
  cut->add_option("scene", arguments.scene,
                  "scene file (JSON) with rock, or a drawing (.dxf, .csv, .xlsx, .geojson, .dc, .blck)")
      ->required()
      ->type_name("SCENE.json|DRAWING");
  cut->add_option("--out", arguments.folder, "folder for the results; made if need be")->required()->type_name("DIR");
  cut->add_option("--export", arguments.cut.exported, "the blocks as a drawing, too: .dxf, .geojson or .dc")
      ->type_name("FILE");
  cut->add_option("--threads", arguments.cut.threads, "that share the work; default one a core; same results with any")
      ->type_name("N")
      ->check(number_of_threads);
  add_drawing_options(*cut, arguments.cut.drawing);
}

void check_scene(const Arguments& arguments, std::ostream& out) {
  std::optional<double> frequency;
  if (!arguments.frequency.empty())
    frequency = positive_quantity(arguments.frequency, Dimension::frequency, frequencies, "--frequency");
  const SceneParts scene = read_scene_parts(arguments.scene);
  try {
    out << describe_scene(scene.model, frequency, scene.remarks);
  } catch (const InputError& error) {
    throw error.in_file(arguments.scene);
  }
}

void advise_scene(const Arguments& arguments, std::ostream& out) {
  AdviseOptions options;
  options.scene = arguments.scene;
  options.json = arguments.json;
  if (!arguments.frequency.empty())
    options.question.frequency =
        positive_quantity(arguments.frequency, Dimension::frequency, frequencies, "--frequency");
  if (!arguments.distance.empty())
    options.question.distance = positive_quantity(arguments.distance, Dimension::length, lengths, "--distance");
  if (!arguments.wanted_error.empty())
    options.question.error =
        positive_quantity(arguments.wanted_error, Dimension::dimensionless, errors_wanted, "--error");
  advise_scene(options, out);
}

int run(Arguments& arguments, std::ostream& out, std::ostream& errors) {
  RunOptions& options = arguments.run;
  options.scene = arguments.scene;
  options.folder = arguments.folder;
  if (arguments.frames > 0) options.frames = arguments.frames;
  if (!arguments.frame_interval.empty())
    options.frame_interval = positive_quantity(arguments.frame_interval, Dimension::time, times, "--frame-interval");
  if (!arguments.checkpoint_interval.empty())
    options.checkpoint_interval =
        positive_quantity(arguments.checkpoint_interval, Dimension::time, times, "--checkpoint-interval");
  return run_scene(options, out, errors);
}

// What is wrong with the command line. The library says of an unknown command only that one is required.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
  const auto is_meant = [argv](const CLI::App* command) { return command->get_name() == argv[1]; };
  const bool unknown_command = argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_meant).empty();
  if (unknown_command)
    return "the command is \"" + std::string(argv[1]) +
           "\", expected check, advise, cut, keyblocks, fos, reaction, run, view, report, spectrum or schema";
  return error.what();
}

int carry_out(const CLI::App& app, Arguments& arguments, std::ostream& out, std::ostream& errors) {
  if (app.got_subcommand("check")) {
    check_scene(arguments, out);
    return 0;
  }
  if (app.got_subcommand("advise")) {
    advise_scene(arguments, out);
    return 0;
  }
  if (app.got_subcommand("cut")) {
    arguments.cut.scene = arguments.scene;
    arguments.cut.folder = arguments.folder;
    cut_into_folder(arguments.cut, out);
    return 0;
  }
  if (app.got_subcommand("keyblocks")) {
    find_key_blocks(arguments.key_blocks, out);
    return 0;
  }
  if (app.got_subcommand("fos")) {
    find_factor_of_safety(arguments.fos, out, errors);
    return 0;
  }
  if (app.got_subcommand("reaction")) return find_ground_reaction(arguments.reaction, out, errors);
  if (app.got_subcommand("run")) return run(arguments, out, errors);
  if (app.got_subcommand("view")) {
    arguments.view.given = given_options(*app.get_subcommand("view"));
    view_run(arguments.view, out);
    return 0;
  }
  if (app.got_subcommand("report")) {
    report_run(arguments.report, out);
    return 0;
  }
  if (app.got_subcommand("spectrum")) {
    write_spectrum(arguments.spectrum, out);
    return 0;
  }
  out << scene_schema();
  return 0;
}

}  // namespace

int run_command_line(int argc, const char* const* argv, std::ostream& out, std::ostream& errors) {
  CLI::App app("Two-dimensional Discontinuous Deformation Analysis", "dda");
  app.footer(program_details);
  Arguments arguments;
  app.set_version_flag("--version", "dda " DDA_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  add_check(app, arguments);
  add_advise(app, arguments);
  add_cut(app, arguments);
  add_keyblocks(app, arguments.key_blocks);
  add_fos(app, arguments.fos);
  add_reaction(app, arguments.reaction);
  add_run(app, arguments);
  add_view(app, arguments);
  add_report(app, arguments.report);
  add_spectrum(app, arguments.spectrum);
  app.add_subcommand("schema", "Print the JSON Schema of scene files")->footer(schema_details);
  expect_values(app);
  try {
    refuse_values_left_out(argc, argv);
    app.parse(argc, argv);
    return carry_out(app, arguments, out, errors);
  } catch (const CLI::Success& request) {
    return app.exit(request, out, errors);
  } catch (const CLI::ParseError& error) {
    errors << "dda: " << complaint(app, error, argc, argv) << "; dda --help says more\n";
    return exit_bad_input;
  } catch (const InputError& error) {
    errors << "dda: " << error.what() << '\n';
    return exit_bad_input;
  } catch (const UnreadableFile& error) {  // such as a folder in the place of a run's summary
    errors << "dda: " << error.what() << '\n';
    return exit_bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    errors << "dda: " << error.path1().string() << ": " << error.code().message() << '\n';
    return exit_failed;
  } catch (const std::bad_alloc&) {
    errors << "dda: out of memory\n";
    return exit_failed;
  } catch (const std::exception& error) {
    errors << "dda: " << error.what() << '\n';
    return exit_failed;
  }
}

}  // namespace dda
