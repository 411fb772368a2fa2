// Names of blocks, bolts, ... in the order of their indices, which are found without looking at all of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace dda {

class Names {
 public:
  Names() = default;

  // Takes the names of things that have a member `name`.
  template <typename Thing>
  explicit Names(const std::vector<Thing>& things) {
    for (const Thing& thing : things) add(thing.name);
  }

  // Where several things have one name, it means the first of them.
  void add(const std::string& name) {
    index_.emplace(name, list_.size());
    list_.push_back(name);
  }

  [[nodiscard]] std::optional<int> find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? std::nullopt : std::optional(static_cast<int>(found->second));
  }

  // All of them, in the order of their indices.
  [[nodiscard]] const std::vector<std::string>& all() const { return list_; }

 private:
  std::vector<std::string> list_;
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace dda
