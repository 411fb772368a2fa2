#include "engine/solve/live_contacts.h"

#include <cmath>

#include "engine/contact/contact_sharing.h"
#include "engine/core/parallel.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

LiveContact live_contact(const InterfaceTrials& contacts, std::size_t k) {
  const InterfaceElement& element = contacts.element(k);
  const InterfaceSprings& springs = element;
  return {k,  element.block_a, element.block_b,         pieces_of(contacts[k]), false, false,
          {}, springs,         PointKinematics(element)};
}

}  // namespace

void list_live(const InterfaceTrials& contacts, std::vector<std::size_t>& places, std::vector<LiveContact>& live) {
  places.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (!contacts.is_whole(k)) places.push_back(k);
  live.resize(places.size());
  parallel_for_each(live.size(), contacts_worth_sharing,
                    [&](std::size_t i) { live[i] = live_contact(contacts, places[i]); });
}

void note_depths(const InterfaceTrials& contacts, std::vector<LiveContact>& live) {
  for (LiveContact& contact : live) {
    const Vec4& gap = contacts[contact.trial].gap;
    contact.depth = {gap(0) + gap(2), std::abs(gap(1)) + std::abs(gap(3))};
  }
}

double largest_elastic_force(const std::vector<LiveContact>& live, const Eigen::VectorXd& increment) {
  double largest = 0;
  for (const LiveContact& contact : live)
    largest = larger(largest, contact.springs.stiffness.cwiseProduct(contact.gap(increment)).cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace dda
