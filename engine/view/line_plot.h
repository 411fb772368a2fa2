// Histories as plots (SVG), for documents.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/histories.h"

namespace dda {

struct PlottedLine {
  std::string name;
  std::vector<double> values;  // at the plot's times; what is no number leaves a gap
};

struct LinePlot {
  std::string title;
  std::string unit;           // SI, of all lines
  std::vector<double> times;  // s, ascending
  std::vector<PlottedLine> lines;
  bool logarithmic = false;  // sizes, over powers of ten; zero is not drawn
};

// The text of the plot, as wide as the element around it.
std::string svg_plot(const LinePlot& plot);

}  // namespace dda
