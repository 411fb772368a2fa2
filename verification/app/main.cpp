// dda-verify: the verification studies from the command line.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "verification/app/program.h"
#include "verification/cases/all_cases.h"
#include "verification/chapters/thesis_command.h"
#include "verification/differential/differential_command.h"
#include "verification/precision/precision_command.h"
#include "verification/rocks/rocks_command.h"
#include "verification/stability/stability_command.h"
#include "verification/suite/run_command.h"
#include "verification/suite/table_command.h"
#include "verification/sweep/sweep_command.h"
#include "verification/thesis/blast_command.h"

namespace {

struct Arguments {
  verify::CalibrateCommand calibrate;
  verify::RunCommand run;
  verify::TableCommand table;
  bool list = false;
  verify::SweepCommand sweep;
  verify::JobCommand job;
  std::filesystem::path collected;
  std::filesystem::path blast, blast_page;
  verify::PrecisionCommand precision;
  verify::ThesisCommand thesis;
  verify::StabilityCommand stability;
  verify::DifferentialCommand differential;
  verify::RocksCommand rocks;
};

void add_calibrate(CLI::App& app, Arguments& arguments) {
  verify::add_calibrate_options(*app.add_subcommand("calibrate", verify::calibrate_description), arguments.calibrate);
}

void add_selection(CLI::App& command, verify::Selection& selection) {
  command.add_option("--case", selection.ids, "only the case of this id; may be given several times")
      ->type_name("ID")
      ->allow_extra_args(false);
  command.add_option("--label", selection.labels, "only cases of this label, fast or slow")
      ->type_name("LABEL")
      ->allow_extra_args(false);
}

void require_one_of(CLI::App& command, CLI::Option* first, CLI::Option* second) {
  second->excludes(first);
  command.callback([first, second] {
    if (first->count() + second->count() == 0) throw CLI::RequiredError(first->get_name());
  });
}

void add_run(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand(
      "run",
      "Runs the cases of the verification catalogue, all of them or those asked for, and writes verification.json: "
      "one entry per asserted quantity with its reference, error and tolerance.\nExit code 1 if an assertion fails; "
      "each is told on standard error.");
  add_selection(*run, arguments.run.selection);
  require_one_of(
      *run, run->add_option("--out", arguments.run.folder, "folder for verification.json; made if it is not there"),
      run->add_flag("--list", arguments.list, "list catalogue numbers, label, id and title of the cases"));
}

void add_table(CLI::App& app, Arguments& arguments) {
  CLI::App* table = app.add_subcommand(
      "table",
      "Makes docs/verification.md from what `run` has written. Cases without results keep the table "
      "that the page has.\nExit code 1 if an assertion failed, or with --check if the page is stale.");
  table->add_option("results", arguments.table.results, "folder with verification.json, or with one for each case")
      ->required()
      ->type_name("DIR");
  add_selection(*table, arguments.table.selection);
  CLI::Option* check = table->add_option("--check", arguments.table.page, "page to compare; nothing is written");
  require_one_of(*table, table->add_option("--out", arguments.table.page, "page to write"), check);
  table->parse_complete_callback([check, &arguments] { arguments.table.check = check->count() > 0; });
}

void add_sweep(CLI::App& app, Arguments& arguments) {
  CLI::App* sweep =
      app.add_subcommand("sweep",
                         "Runs a grid of parameters over the thesis' bar, each job a process of its own: results.csv "
                         "and plots/ of measured and predicted errors.\nExit code 1 if a job failed; each is told on "
                         "standard error.");
  sweep->add_option("spec", arguments.sweep.spec, "JSON file of the grid; verification/sweep/README.md")
      ->required()
      ->type_name("SPEC");
  sweep->add_option("--out", arguments.sweep.folder, "folder for all files; made if it is not there")->required();
  sweep->add_option("--jobs", arguments.sweep.jobs, "jobs at once; default: as many as there are cores")
      ->check(CLI::PositiveNumber);
  sweep->add_flag("--resume", arguments.sweep.resume, "go on in a folder that has jobs, and keep those that are done");
  sweep->add_flag("--job-list", arguments.sweep.job_list,
                  "run nothing: write jobs.txt, a command a line, and slurm.sh, a job array");
}

void add_job(CLI::App& app, Arguments& arguments) {
  CLI::App* job = app.add_subcommand(
      "job", "Runs one job of a sweep and writes DIR/jobs/INDEX.json.\nExit code 1 if it failed; the file says why.");
  job->add_option("spec", arguments.job.spec, "JSON file of the sweep")->required()->type_name("SPEC");
  job->add_option("index", arguments.job.index, "which job, from 0")->required()->type_name("INDEX");
  job->add_option("--out", arguments.job.folder, "folder of the sweep")->required()->type_name("DIR");
}

void add_collect(CLI::App& app, Arguments& arguments) {
  CLI::App* collect = app.add_subcommand(
      "collect", "Makes results.csv and plots/ from the jobs of a sweep that are done.\nExit code 1 if some are not.");
  collect->add_option("folder", arguments.collected, "folder of the sweep")->required()->type_name("DIR");
}

void add_blast(CLI::App& app, Arguments& arguments) {
  CLI::App* blast = app.add_subcommand(
      "blast",
      "The blast of Zelig (2015), chapter 4, as far as its text defines it: Table 4.1 and peak stresses beside this "
      "engine's, with three kinds of joints and by the radial wave equation.\nWrites blast.md; about a minute. Exit "
      "code 1 with --check if the page is stale.");
  require_one_of(*blast, blast->add_option("--out", arguments.blast, "folder of the page; made if it is not there"),
                 blast->add_option("--check", arguments.blast_page, "page to compare; nothing is written"));
}

void add_precision(CLI::App& app, Arguments& arguments) {
  CLI::App* precision = app.add_subcommand(
      "work-precision",
      "Error against CPU time: every interface law and integrator over block size and time step, for the thesis' bar "
      "and a pulse in a plate, beside plain explicit finite elements.\nWrites work_precision.csv, work_precision.md "
      "and plots/. Exit code 1 if a run failed.");
  precision->add_option("--out", arguments.precision.folder, "folder for all files; made if it is not there")
      ->required();
  precision->add_option("--rounds", arguments.precision.rounds, "runs of every job, of which the least CPU time counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  precision->add_flag("--resume", arguments.precision.resume, "go on in a folder that has runs, and keep them");
}

void add_thesis(CLI::App& app, Arguments& arguments) {
  CLI::App* thesis = app.add_subcommand(
      "thesis",
      "What Zelig (2015) says in chapters 3 to 6, statement by statement, and what this engine says to it, in all "
      "readings of what the text leaves open.\nWrites thesis.json and chapter_N.md, for chapters 5 and 6 also scenes/ "
      "and runs/; runs that are done there are kept. Exit code 1 if a run failed.");
  thesis->add_option("--chapter", arguments.thesis.chapters, "3, 4, 5 or 6; may be given several times; default: all")
      ->check(CLI::Range(3, 6))
      ->allow_extra_args(false);
  thesis->add_option("--out", arguments.thesis.folder, "folder for all files; made if it is not there")->required();
  thesis->add_option("--jobs", arguments.thesis.jobs, "runs at once; default: as many as there are cores")
      ->check(CLI::PositiveNumber);
  thesis->add_flag("--quick", arguments.thesis.quick,
                   "small readings of section 6.1, in seconds, and no runs of chapter 5 and section 6.2");
}

void add_stability(CLI::App& app, Arguments& arguments) {
  CLI::App* stability = app.add_subcommand(
      "stability",
      "Penalty, time step, mass ratio and aspect of blocks at their extremes, in four small problems under every "
      "integrator: which runs are right, which refuse, warn or stop.\nWrites stability.json, stability.md and images/; "
      "some minutes. Exit code 1 if a run is wrong and says nothing.");
  stability->add_option("--out", arguments.stability.folder, "folder for all files; made if it is not there")
      ->required();
  stability->add_flag("--quick", arguments.stability.quick,
                      "the corners of the chart under two integrators, in seconds");
}

// Of what is drawn by lot: `first` and `many` say what it is.
template <typename Command>
void add_seeds(CLI::App& app, Command& command, const std::string& first, const std::string& many) {
  app.add_option("--seed", command.seed, "of the first " + first + "; the others follow")->capture_default_str();
  app.add_option("--count", command.count, many)->check(CLI::PositiveNumber)->capture_default_str();
}

void add_rocks(CLI::App& app, Arguments& arguments) {
  CLI::App* rocks = app.add_subcommand(
      "rocks",
      "Rock cut by lot - joint sets, traces, grains, openings, excavations, slopes, shaken walls - settles and moves, "
      "and is judged by outlines, weights, Coulomb's law and speeds.\nWrites rocks.json, rocks.md, images/ and the "
      "scenes that are not right. Exit code 1 if a rock is wrong in silence.");
  rocks->add_option("--out", arguments.rocks.folder, "folder for all files; made if it is not there")->required();
  add_seeds(*rocks, arguments.rocks, "rock", "rocks");
  rocks->add_flag_callback(
      "--dilating", [&arguments] { arguments.rocks.family.joints = verify::RockJoints::dilating; },
      "smaller rocks, with joints that ride up as they slide");
  rocks->add_flag_callback(
      "--projected", [&arguments] { arguments.rocks.family.joints = verify::RockJoints::projected; },
      "joints of the projected law");
  rocks
      ->add_option("--extent", arguments.rocks.family.extent,
                   "times as wide and high, with joints as far apart: its square times as many blocks")
      ->check(CLI::Range(0.5, 20.0))
      ->capture_default_str();
  rocks->add_option("--seconds", arguments.rocks.seconds, "of CPU time, the most that a rock is given")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void add_differential(CLI::App& app, Arguments& arguments) {
  CLI::App* differential = app.add_subcommand(
      "differential",
      "Random small scenes of mixed features, run with each linear solver, with a stop half-way and with two threads: "
      "they must agree to 1e-9, or it is said why not.\nExit code 1 if runs of a scene differ; each is told with its "
      "seed.");
  add_seeds(*differential, arguments.differential, "scene", "scenes");
  differential->add_option("--out", arguments.differential.folder, "folder for scenes whose runs differ");
  differential->add_flag("--verbose", arguments.differential.verbose, "a line for every scene");
}

int carry_out(const CLI::App& app, const Arguments& arguments) {
  if (app.got_subcommand("calibrate")) return verify::calibrate(arguments.calibrate);
  if (app.got_subcommand("blast")) {
    if (!arguments.blast_page.empty()) return verify::check_blast_page(arguments.blast_page, std::cerr);
    verify::report_blast(arguments.blast);
    return 0;
  }
  if (app.got_subcommand("thesis"))
    return verify::judge_thesis(arguments.thesis, std::filesystem::canonical("/proc/self/exe").replace_filename("dda"),
                                std::cout, std::cerr);
  if (app.got_subcommand("table"))
    return verify::make_table(verify::all_cases(), arguments.table, std::cout, std::cerr);
  if (app.got_subcommand("sweep"))
    return verify::sweep(arguments.sweep, std::filesystem::canonical("/proc/self/exe"), std::cout, std::cerr);
  if (app.got_subcommand("job")) return verify::job(arguments.job, std::cout);
  if (app.got_subcommand("work-precision")) return verify::work_precision(arguments.precision, std::cout, std::cerr);
  if (app.got_subcommand("differential")) return verify::compare_scenes(arguments.differential, std::cout, std::cerr);
  if (app.got_subcommand("rocks")) return verify::run_rocks(arguments.rocks, std::cout, std::cerr);
  if (app.got_subcommand("stability")) return verify::chart_stability(arguments.stability, std::cout, std::cerr);
  if (app.got_subcommand("collect")) return verify::collect(arguments.collected, std::cout, std::cerr);
  if (!arguments.list) return verify::run_cases(verify::all_cases(), arguments.run, std::cout, std::cerr);
  verify::list_cases(verify::select(verify::all_cases(), arguments.run.selection), std::cout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Verification studies of the dda engine.", "dda-verify");
  app.require_subcommand(1);
  Arguments arguments;
  add_calibrate(app, arguments);
  add_blast(app, arguments);
  add_run(app, arguments);
  add_table(app, arguments);
  add_sweep(app, arguments);
  add_job(app, arguments);
  add_collect(app, arguments);
  add_precision(app, arguments);
  add_thesis(app, arguments);
  add_stability(app, arguments);
  add_differential(app, arguments);
  add_rocks(app, arguments);
  return verify::run_program(app, argc, argv, [&app, &arguments] { return carry_out(app, arguments); });
}
