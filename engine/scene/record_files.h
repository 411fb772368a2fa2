// The "record" of histories, read once each: places that use the same one share its samples.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "engine/core/quantity.h"
#include "engine/model/time_function.h"
#include "engine/scene/field.h"

namespace dda {

class RecordFiles {
 public:
  // Names of files are relative to `folder`, that of the scene.
  explicit RecordFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The "record" at `field`. Its values may have a unit of `dimension`; a baseline is corrected in accelerations only.
  Recorded read(const Field& field, Dimension dimension);

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::shared_ptr<const Recording>> known_;  // by everything that was asked for
};

}  // namespace dda
