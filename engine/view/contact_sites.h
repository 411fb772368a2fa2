// Where contacts are, told by the blocks that they lie on: a place on the outline of block b, touched by block a. The
// same site serves every frame, whatever the blocks do.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "engine/view/run_results.h"

namespace dda {

struct ContactSite {
  std::uint32_t block_a = 0;
  std::uint32_t block_b = 0;
  std::uint32_t from = 0;  // vertices of the Drawing: the ends of an edge of block b
  std::uint32_t to = 0;
  std::uint32_t fraction = 0;  // of the way from `from` to `to`, in 1/65536; 0 at a vertex
};

class ContactSites {
 public:
  explicit ContactSites(const Drawing& drawing) : drawing_(drawing) {}

  // The number of the contact's site, a new one if it has none yet.
  std::uint32_t number_of(const DrawnContact& contact);

  [[nodiscard]] const std::vector<ContactSite>& sites() const { return sites_; }

 private:
  [[nodiscard]] ContactSite site_of(const DrawnContact& contact) const;

  const Drawing& drawing_;
  std::vector<ContactSite> sites_;
  std::map<std::array<std::uint32_t, 4>, std::uint32_t> numbers_;
};

}  // namespace dda
