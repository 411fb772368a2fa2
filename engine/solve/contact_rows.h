// Which rows of a contact carry stiffness in the matrix.
#pragma once

#include "engine/contact/interface_element.h"

namespace dda {

// The rows of a contact that carry stiffness, as InterfaceTrial has them.
struct ContactRows {
  Vec4 active = Vec4::Ones();
  double coupling = 0;

  bool operator==(const ContactRows& other) const { return active == other.active && coupling == other.coupling; }
  ContactRows operator-(const ContactRows& other) const { return {active - other.active, coupling - other.coupling}; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [active, coupling] = self;
    archive(active, coupling);
  }
};

}  // namespace dda
