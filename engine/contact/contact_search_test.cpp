#include "engine/contact/contact_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/narrow_phase.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/overlap.h"

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
      NarrowPhase(outlines).find(a, b, {ContactSearch::reach * smaller, 0.1 * smaller, 1e-9 * smaller}, found);
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

// ---- What a step can miss.

// Two blocks as they move in a step, to first order.
struct MovingPair {
  Model model;
  Eigen::VectorXd d = Eigen::VectorXd::Zero(12);

  [[nodiscard]] Vec2 displacement(int block, const Vec2& place) const {
    const Vec6 own = d.segment<6>(6 * block);
    return displacement_of(own, place - model.blocks[static_cast<std::size_t>(block)].moments.centroid);
  }
  [[nodiscard]] Polygon shape_at(int block, double share) const {
    Polygon shape = model.blocks[static_cast<std::size_t>(block)].shape;
    for (Vec2& vertex : shape.outer) vertex += share * displacement(block, vertex);
    return shape;
  }
  // Whether they are in each other by more than this at some time.
  [[nodiscard]] bool meet(double depth) const {
    constexpr int times = 50;
    for (int i = 1; i <= times; ++i)
      if (interiors_overlap(shape_at(0, i / double{times}), shape_at(1, i / double{times}), depth)) return true;
    return false;
  }
  [[nodiscard]] bool closes(const VertexContact& contact, const Outlines& outlines) const {
    const Vec2 vertex = model.origin + outlines.current[static_cast<std::size_t>(contact.vertex)];
    const Vec2 opening = displacement(contact.vertex_block, vertex) - displacement(contact.edge_block, vertex);
    return contact.gap + contact.normal.dot(opening) < 0;
  }
};

// Neighbours of a rock that was cut by lot, apart by up to a fifth of their size, which go any way by up to `far` of
// it.
MovingPair pair_by_lot(SeededNumbers& random, double far) {
  const std::vector<Ring> rock = random_blocks(random, 5, 1e-3);
  if (rock.size() < 2) return pair_by_lot(random, far);
  Polygon a{rock[0], {}}, b{rock[1], {}};
  const double size = std::sqrt(std::min(signed_area(a.outer), signed_area(b.outer)));
  const Vec2 apart = (area_moments(b).centroid - area_moments(a).centroid).normalized();
  const double gap = random.magnitude(-5, -0.7) * size;
  for (Vec2& vertex : b.outer) vertex += gap * apart;
  if (interiors_overlap(a, b, 1e-9)) return pair_by_lot(random, far);  // concave ones that were apart
  MovingPair pair;
  pair.model = model_of({a, b});
  for (int block = 0; block < 2; ++block) {
    pair.d.segment<2>(6 * block) = random.magnitude(-3, std::log10(far)) * size * random.direction();
    pair.d(6 * block + 2) = random.number(-0.005, 0.005);
  }
  return pair;
}

// Steps that move blocks far, but close no contact that was not looked for, need not be solved again. The oracle sees
// the blocks on their way at fifty moments, and knows nothing of contacts.
TEST(ContactSearch, MissesNothingThatBlocksMeetInAStep) {
  SeededNumbers random(1);
  int far = 0, wider = 0, meet = 0;
  for (int scene = 0; scene < 20000; ++scene) {
    const MovingPair pair = pair_by_lot(random, 2);
    const State state = initial_state(pair.model);
    ContactSearch search(pair.model, state);
    const std::vector<VertexContact> seen = search.find({});
    if (std::ranges::any_of(seen, [&](const VertexContact& c) { return pair.closes(c, search.outlines()); })) continue;
    const double size = std::min(search.size_of(0), search.size_of(1));
    const double relative = (pair.d.segment<2>(0) - pair.d.segment<2>(6)).norm();
    // Gaps of first order leave out what normals that turn by up to 0.01 make of the way.
    const bool meets = pair.meet(1e-3 * size + 0.01 * relative);
    const bool is_wider = search.widen(pair.model, state, pair.d, {seen, {}});
    far += relative > ContactSearch::reach * size ? 1 : 0;
    wider += is_wider ? 1 : 0;
    meet += meets ? 1 : 0;
    EXPECT_TRUE(is_wider || !meets) << "scene " << scene;
  }
  EXPECT_GT(meet, 1000);
  EXPECT_LT(wider, 1.3 * meet);
  EXPECT_GT(far, 5 * wider);
}

// A box falls by more than its size onto a floor that is far below it.
TEST(ContactSearch, WhatAStretchHoldsOrASolutionKnowsIsNotMissed) {
  const Model model = model_of({{box_ring(0, 0, 3, 1), {}}, {box_ring(1, 1.5, 1.2, 1.7), {}}});
  const State state = initial_state(model);
  Eigen::VectorXd d = Eigen::VectorXd::Zero(12);
  d(7) = -0.51;
  ContactSearch search(model, state);
  for (int looks = 0; looks < 2; ++looks) {  // the first makes them a pair
    EXPECT_TRUE(search.widen(model, state, d, {}));
    search.update(model, state);
  }
  const std::vector<VertexContact> found = search.find({});
  EXPECT_EQ(found.size(), 2U);
  EXPECT_FALSE(search.widen(model, state, d, {found, {}}));
  const std::vector<std::pair<int, int>> held = {{0, 1}};
  EXPECT_FALSE(search.widen(model, state, d, {{}, held}));
  d(7) = -0.49;
  EXPECT_FALSE(search.widen(model, state, d, {}));
}

}  // namespace
}  // namespace dda
