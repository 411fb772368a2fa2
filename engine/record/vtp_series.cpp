#include "engine/record/vtp_series.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>
#include <utility>

#include "engine/record/atomic_file.h"

namespace dda {
namespace {

void create_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directory(path, error);
  if (error) throw std::runtime_error("cannot create folder " + path.string() + ": " + error.message());
}

}  // namespace

VtpSeries::VtpSeries(std::filesystem::path index) : index_(std::move(index)) {
  create_folder(index_.parent_path() / index_.stem());
}

void VtpSeries::add(const PolyData& data) {
  write_vtp(index_.parent_path() / next_path(), data);
  const std::string latest = entry(data.time);
  write_file(index_, "<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n" + entries_ + latest +
                         "  </Collection>\n</VTKFile>\n");
  entries_ += latest;
  ++size_;
}

void VtpSeries::go_on_after(std::span<const double> times) {
  for (const double time : times) {
    entries_ += entry(time);
    ++size_;
  }
}

// From the folder of the index.
std::filesystem::path VtpSeries::next_path() const { return index_.stem() / fmt::format("{:06}.vtp", size_); }

std::string VtpSeries::entry(double time) const {
  return fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                     xml_escaped(next_path().generic_string()));
}

}  // namespace dda
