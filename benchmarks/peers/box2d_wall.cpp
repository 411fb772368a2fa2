// The wall of ci/compare-peers in Box2D: `box2d-wall SIDE DT STEPS ITERATIONS` prints bricks, CPU ms a step and the
// farthest way of a brick in m.
#include <box2d/box2d.h>

#include <cstdio>
#include <cstdlib>

#include "wall.h"

namespace {

b2Body* add_box(b2World& world, b2BodyType type, float x, float y, float width, float height) {
  b2BodyDef where;
  where.type = type;
  where.position.Set(x, y);
  where.allowSleep = false;
  b2Body* body = world.CreateBody(&where);
  b2PolygonShape box;
  box.SetAsBox(width / 2 - b2_polygonRadius, height / 2 - b2_polygonRadius);  // its skin comes around that
  b2FixtureDef what;
  what.shape = &box;
  what.density = static_cast<float>(peers::density);
  what.friction = static_cast<float>(peers::friction);
  body->CreateFixture(&what);
  return body;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const int side = std::atoi(argv[1]), steps = std::atoi(argv[3]), iterations = std::atoi(argv[4]);
  b2World world(b2Vec2(0, static_cast<float>(-peers::gravity)));
  add_box(world, b2_staticBody, static_cast<float>(side) / 2, -0.5F, static_cast<float>(side) + 2, 1);
  const std::vector<peers::Brick> bricks = peers::wall_of(side);
  std::vector<b2Body*> bodies;
  for (const peers::Brick& brick : bricks)
    bodies.push_back(add_box(world, b2_dynamicBody, static_cast<float>(brick.x), static_cast<float>(brick.y),
                             static_cast<float>(brick.width), static_cast<float>(peers::brick_height)));
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) world.Step(std::strtof(argv[2], nullptr), iterations, iterations);
  const double seconds = peers::seconds_since(begin);
  double drift = 0;
  for (std::size_t i = 0; i < bricks.size(); ++i)
    drift =
        std::max(drift, std::hypot(bodies[i]->GetPosition().x - bricks[i].x, bodies[i]->GetPosition().y - bricks[i].y));
  std::printf("%zu %.6g %.6g\n", bricks.size(), 1e3 * seconds / steps, drift);
  return 0;
}
