// `dda advise`: what a scene will be worth, before it is run.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "engine/advice/advice.h"

namespace dda {

struct AdviseOptions {
  std::filesystem::path scene;
  AdviceQuestion question;
  bool json = false;
};

// Throws InputError for what is wrong with scene or question.
void advise_scene(const AdviseOptions& options, std::ostream& out);

}  // namespace dda
