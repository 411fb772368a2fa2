// The elements of all interfaces of a scene.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/contact/interface_element.h"

namespace dda {

// Every interface has an element of its own, a kilobyte, until they are shared: those that differ in nothing but their
// blocks are then kept once, a handful in a grid of equal blocks. That is for scenes in which nothing can change.
class InterfaceElements {
 public:
  [[nodiscard]] std::size_t size() const { return places_.empty() ? kept_.size() : places_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }

  [[nodiscard]] InterfaceElement operator[](std::size_t i) const;  // a copy
  // The same for loops: a copy, in `room`, only where elements are shared.
  [[nodiscard]] const InterfaceElement& read(std::size_t i, InterfaceElement& room) const {
    return places_.empty() ? kept_[i] : fetched(i, room);
  }
  // What it is but for its blocks, which may be those of another.
  [[nodiscard]] const InterfaceElement& but_for_blocks(std::size_t i) const {
    return kept_[places_.empty() ? i : static_cast<std::size_t>(places_[i].kind)];
  }
  // All that are kept, without regard to blocks: of each kind one where they are shared.
  [[nodiscard]] std::span<const InterfaceElement> kinds() const { return kept_; }

  // Each has its own; throws std::logic_error where they are shared.
  [[nodiscard]] const std::vector<InterfaceElement>& own() const;
  // Makes it so.
  [[nodiscard]] std::vector<InterfaceElement>& edit();

  // Where that saves half of them at least; where the first thousands are mostly different all the others will be.
  void share();

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [kept, places] = self;
    archive.expect(places.empty());  // scenes that share them do not save them
    archive(kept);
  }

 private:
  struct Place {
    int block_a, block_b;
    int kind;  // of the kept ones
  };

  const InterfaceElement& fetched(std::size_t i, InterfaceElement& room) const;

  std::vector<InterfaceElement> kept_;  // one for each interface, or for each kind
  std::vector<Place> places_;           // of all interfaces where they are shared, else none
};

}  // namespace dda
