#include "engine/contact/contact_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/narrow_phase.h"

namespace dda {
namespace {

// Boxes of all sizes in disorder; overlaps are of no matter here.
Model random_boxes(int count, double least, double most, double room, std::mt19937& generator) {
  const auto number = [&](double lower, double upper) {
    return std::uniform_real_distribution<>(lower, upper)(generator);
  };
  Model model;
  for (int i = 0; i < count; ++i) {
    const double size = least * std::pow(most / least, number(0, 1));
    const Vec2 place(number(0, room), number(0, room));
    Block& block = model.blocks.emplace_back();
    block.shape.outer = box_ring(place.x(), place.y(), place.x() + size, place.y() + number(0.5, 2) * size);
    block.moments = area_moments(block.shape);
  }
  return model;
}

Ring turned(Ring ring, double angle) {
  for (Vec2& vertex : ring) vertex = rotation(angle) * vertex;
  return ring;
}

// Slabs, 5 to 100 times as long as thick, in disorder and in every direction.
Model random_slabs(int count, double room, std::mt19937& generator) {
  const auto number = [&](double lower, double upper) {
    return std::uniform_real_distribution<>(lower, upper)(generator);
  };
  Model model;
  for (int i = 0; i < count; ++i) {
    const double length = number(0.5, 2), thickness = length / std::pow(10, number(0.7, 2));
    const Vec2 place(number(0, room), number(0, room));
    Block& block = model.blocks.emplace_back();
    block.shape.outer = turned(box_ring(0, 0, length, thickness), number(0, 4));
    for (Vec2& vertex : block.shape.outer) vertex += place;
    block.moments = area_moments(block.shape);
  }
  return model;
}

// Beds of 0.3 m, cut every 10 m, all of them turned.
Model dipping_beds(int beds, double angle) {
  Model model;
  for (int bed = 0; bed < beds; ++bed) {
    for (int k = 0; k < 4; ++k) {
      Block& block = model.blocks.emplace_back();
      const double left = 10 * k + 3.7 * (bed % 3);
      block.shape.outer = turned(box_ring(left, 0.3 * bed, left + 10, 0.3 * (bed + 1)), angle);
      block.moments = area_moments(block.shape);
    }
  }
  return model;
}

using Pairs = std::set<std::pair<int, int>>;
using Keys = std::vector<std::pair<int, int>>;  // edge, vertex

Keys keys_of(const std::vector<VertexContact>& contacts) {
  Keys keys;
  for (const VertexContact& contact : contacts) keys.emplace_back(contact.edge, contact.vertex);
  return keys;
}

// Every pair of blocks put to the narrow phase, wherever they are.
Keys all_contacts(const Model& model, const State& state, const ContactSearch& search) {
  const Outlines outlines = make_outlines(model, state);
  std::vector<VertexContact> found;
  for (int a = 0; a < outlines.blocks(); ++a) {
    for (int b = a + 1; b < outlines.blocks(); ++b) {
      const double smaller = std::min(search.size_of(a), search.size_of(b));
      find_vertex_contacts(outlines, a, b, ContactSearch::reach * smaller, 0.1 * smaller, 1e-9 * smaller, found);
    }
  }
  std::sort(found.begin(), found.end());
  return keys_of(found);
}

void move_at_random(const ContactSearch& search, double share, State& state, std::mt19937& generator) {
  std::uniform_real_distribution<> number(-1, 1);
  for (std::size_t i = 0; i < state.displacement.size(); ++i) {
    const double length = share * search.size_of(static_cast<int>(i));
    state.displacement[i].head<2>() += length * Vec2(number(generator), number(generator));
    state.deformation[i] = rotation(share * number(generator)) * state.deformation[i];
  }
}

void follow_random_motion(Model model, int steps, double share, std::mt19937& generator) {
  State state = initial_state(model);
  ContactSearch search(model, state);
  int lists = 0;
  std::size_t contacts = 0;
  for (int step = 0; step < steps; ++step) {
    move_at_random(search, share, state, generator);
    lists += search.update(model, state) ? 1 : 0;
    const Keys expected = all_contacts(model, state, search);
    ASSERT_EQ(keys_of(search.find({})), expected) << "step " << step;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, static_cast<std::size_t>(steps));  // the boxes do meet
  EXPECT_GT(lists, 0);                                   // the list went out of date
  EXPECT_LT(lists, steps);                               // and held in between
}

TEST(ContactSearch, FindsWhatBruteForceFindsWhileBlocksMove) {
  std::mt19937 generator(3);
  follow_random_motion(random_boxes(60, 0.5, 1, 6, generator), 200, 0.01, generator);
}

TEST(ContactSearch, SizesThatDifferTenThousandfold) {
  std::mt19937 generator(5);
  Model model = random_boxes(80, 1e-3, 10, 6, generator);
  // Grains strewn over the outline of a big block, where they touch it.
  Block& big = model.blocks.emplace_back();
  big.shape.outer = box_ring(0, -10, 10, 0);
  big.moments = area_moments(big.shape);
  for (int i = 0; i < 40; ++i) {
    Block& grain = model.blocks.emplace_back();
    const double left = 0.1 * i;
    grain.shape.outer = box_ring(left, 1e-6, left + 1e-3, 1e-3);
    grain.moments = area_moments(grain.shape);
  }
  follow_random_motion(model, 100, 0.005, generator);
}

// Pairs are kept at least as long as their blocks can come within reach before the list is made anew.
TEST(ContactSearch, ListedPairsHoldAllThatAreNear) {
  std::mt19937 generator(7);
  const Model model = random_boxes(50, 0.1, 1, 5, generator);
  State state = initial_state(model);
  ContactSearch search(model, state);
  for (int step = 0; step < 100; ++step) {
    move_at_random(search, 0.01, state, generator);
    search.update(model, state);
    const Outlines now = make_outlines(model, state);
    const Pairs listed(search.pairs().begin(), search.pairs().end());
    for (int a = 0; a < now.blocks(); ++a) {
      for (int b = a + 1; b < now.blocks(); ++b) {
        const double near = ContactSearch::reach * std::min(search.size_of(a), search.size_of(b));
        const Box grown = expanded(now.boxes[static_cast<std::size_t>(a)], near);
        const bool is_near = overlap(grown, now.boxes[static_cast<std::size_t>(b)]);
        ASSERT_TRUE(!is_near || listed.contains({a, b})) << step;
      }
    }
  }
}

TEST(ContactSearch, FindsWhatBruteForceFindsBetweenSlabsInEveryDirection) {
  for (unsigned seed = 11; seed < 15; ++seed) {
    std::mt19937 generator(seed);
    follow_random_motion(random_slabs(60, 5, generator), 100, 0.003, generator);
  }
}

// However rock is turned it has the same pairs, and beds those that touch: at 35 degrees twenty beds cross the upright
// box of each block.
TEST(ContactSearch, BedsHaveTheirNeighboursWhateverTheirDip) {
  const auto pairs_at = [](double angle) {
    const Model model = dipping_beds(30, angle);
    return ContactSearch(model, initial_state(model)).pairs();
  };
  const std::vector<std::pair<int, int>> level = pairs_at(0);
  for (const auto& [a, b] : level) EXPECT_LE(b / 4 - a / 4, 1);
  for (const double angle : {0.1, 0.61, -1.2, 1.4}) EXPECT_EQ(pairs_at(angle), level) << angle;
}

TEST(ContactSearch, BondedPairsAreLeftOut) {
  const Model model = model_of({{box_ring(0, 0, 3, 1), {}}, {box_ring(0, 1, 1, 2), {}}, {box_ring(2, 1, 3, 2), {}}});
  const State state = initial_state(model);
  const ContactSearch search(model, state);
  EXPECT_EQ(search.find({}).size(), 4U);
  const std::vector<VertexContact> rest = search.find({{0, 2}});
  ASSERT_EQ(rest.size(), 2U);
  for (const VertexContact& contact : rest) EXPECT_EQ(std::min(contact.edge_block, contact.vertex_block), 0);
  for (const VertexContact& contact : rest) EXPECT_EQ(std::max(contact.edge_block, contact.vertex_block), 1);
  EXPECT_TRUE(search.find({{0, 1}, {0, 2}}).empty());
}

}  // namespace
}  // namespace dda
