#include "engine/cutting/cell_sites.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/cutting/cell_size.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int samples_in_a_cell = 32;

struct Sample {
  Vec2 place;
  double weight = 0;
  int site = 0;  // nearest
};

// Sites that share an edge of the triangulation.
class Neighbours {
 public:
  Neighbours(const Delaunay& delaunay, std::size_t sites) : starts_(sites + 1, 0) {
    const auto visit = [&](auto&& each) {
      for (const DelaunayTriangle& triangle : delaunay.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
          const int from = triangle.corners[i];
          const int to = triangle.corners[(i + 1) % 3];
          if (delaunay.is_site(from) && delaunay.is_site(to)) each(from, to);
        }
      }
    };
    visit([&](int from, int) { ++starts_[at(from) + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    others_.resize(at(starts_.back()));
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    visit([&](int from, int to) { others_[at(next[at(from)]++)] = to; });
  }

  [[nodiscard]] std::span<const int> of(int site) const {
    return {others_.data() + starts_[at(site)], others_.data() + starts_[at(site) + 1]};
  }

 private:
  std::vector<int> starts_, others_;
};

// As many in each part as cells have room there, spread evenly over the list of parts and by lot within each.
std::vector<Sample> draw_samples(const std::vector<FillPart>& parts, double cells, int count, RandomStream& random) {
  std::vector<Sample> samples;
  double passed = 0;
  const double share = cells / count;
  for (const FillPart& part : parts) {
    passed += part.cells;
    while (static_cast<int>(samples.size()) < count && (static_cast<double>(samples.size()) + 0.5) * share < passed) {
      const double root = std::sqrt(random.uniform());
      const double other = random.uniform();
      const Vec2 place =
          (1 - root) * part.corners[0] + root * (1 - other) * part.corners[1] + root * other * part.corners[2];
      samples.push_back({place, 1 / (part.size * part.size), 0});
    }
  }
  return samples;
}

class Relaxer {
 public:
  Relaxer(std::vector<Sample> samples, const SiteGrid& grid, RandomStream& random)
      : samples_(std::move(samples)), grid_(grid) {
    const std::size_t sites = samples_.size() / samples_in_a_cell;
    for (std::size_t i = 0; i < sites; ++i) {
      const auto lot = static_cast<std::size_t>(samples_in_a_cell * random.uniform());
      pixels_.push_back(grid_.pixel_of(samples_[samples_in_a_cell * i + lot].place));
      for (std::size_t k = 0; k < samples_in_a_cell; ++k)
        samples_[samples_in_a_cell * i + k].site = static_cast<int>(i);
    }
  }

  void move_to_centroids() {
    const Delaunay delaunay(pixels_);
    const Neighbours neighbours(delaunay, pixels_.size());
    std::vector<Vec2> sums(pixels_.size(), Vec2::Zero());
    std::vector<double> weights(pixels_.size(), 0);
    for (Sample& sample : samples_) {
      sample.site = nearest(sample, neighbours);
      sums[at(sample.site)] += sample.weight * sample.place;
      weights[at(sample.site)] += sample.weight;
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      if (weights[i] > 0) pixels_[i] = grid_.pixel_of(sums[i] / weights[i]);
    }
  }

  std::vector<Pixel> take() { return std::move(pixels_); }

 private:
  // From one site to a neighbour that is nearer, until there is none: then it is the nearest of all, as in every
  // Delaunay triangulation. A sample starts at the site that it had before.
  [[nodiscard]] int nearest(const Sample& sample, const Neighbours& neighbours) const {
    int site = sample.site;
    double least = squared_distance(sample, site);
    for (bool moved = true; moved;) {
      moved = false;
      for (const int other : neighbours.of(site)) {
        const double distance = squared_distance(sample, other);
        if (distance >= least) continue;
        least = distance;
        site = other;
        moved = true;
        break;
      }
    }
    return site;
  }

  [[nodiscard]] double squared_distance(const Sample& sample, int site) const {
    const Pixel& pixel = pixels_[at(site)];
    const Vec2 place = grid_.place_of({static_cast<double>(pixel.x), static_cast<double>(pixel.y)});
    return (place - sample.place).squaredNorm();
  }

  std::vector<Sample> samples_;
  const SiteGrid& grid_;
  std::vector<Pixel> pixels_;
};

}  // namespace

SiteGrid::SiteGrid(const Box& box)
    : middle_((box.lower + box.upper) / 2),
      step_((box.upper - box.lower).maxCoeff() / 2 / static_cast<double>(farthest_site)) {}

Pixel SiteGrid::pixel_of(const Vec2& place) const {
  const auto whole = [&](int axis) {
    const auto steps = static_cast<std::int64_t>(std::llround((place(axis) - middle_(axis)) / step_));
    return std::clamp(steps, -farthest_site, farthest_site);
  };
  return {whole(0), whole(1)};
}

std::vector<Pixel> sites_of(const Polygon& block, const PlanFill& fill, const SiteGrid& grid, RandomStream& random) {
  const std::vector<FillPart> parts = parts_of(block, fill);
  double cells = 0;
  for (const FillPart& part : parts) cells += part.cells;
  const int sites = static_cast<int>(std::lround(cells));
  if (sites < 2) return {};
  std::vector<Sample> samples = draw_samples(parts, cells, samples_in_a_cell * sites, random);
  Relaxer relaxer(std::move(samples), grid, random);
  for (int sweep = 0; sweep < fill.relax; ++sweep) relaxer.move_to_centroids();
  return relaxer.take();
}

}  // namespace dda
