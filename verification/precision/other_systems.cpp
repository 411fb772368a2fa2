#include "verification/precision/other_systems.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace verify {
namespace {

constexpr std::size_t columns = 10;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

Problem problem_named(const std::string& name) {
  for (const Problem problem : {Problem::bar, Problem::bar_cycle, Problem::plane})
    if (name == name_of(problem)) return problem;
  throw std::invalid_argument(name);
}

Measured parse(const std::vector<std::string>& cells) {
  if (cells.size() != columns) throw std::invalid_argument("number of columns");
  Measured measured;
  measured.job.problem = problem_named(cells[0]);
  measured.job.scheme.law = cells[1];
  measured.job.scheme.integrator = cells[2];
  measured.job.size = std::stod(cells[3]);
  measured.job.dt = std::stod(cells[4]);
  measured.result.cells = std::stoi(cells[5]);
  measured.result.steps = std::stod(cells[6]);
  measured.result.error = std::stod(cells[7]);
  measured.result.reading = std::stod(cells[8]);
  measured.result.cpu_s = std::stod(cells[9]);
  measured.runs = 1;
  return measured;
}

}  // namespace

std::vector<Measured> read_other_systems(const std::filesystem::path& file) {
  std::vector<Measured> all;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    try {
      all.push_back(parse(cells_of(line)));
    } catch (const std::logic_error& reason) {
      throw std::runtime_error(fmt::format("{}: \"{}\" is no run: {}", file.string(), line, reason.what()));
    }
  }
  return all;
}

}  // namespace verify
