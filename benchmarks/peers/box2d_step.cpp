// SPDX-License-Identifier: BSL-1.0
// box2d_step PACKING  times steps of Box2D.

#include <box2d/box2d.h>

#include "impulse_engine.hpp"

namespace peers {
namespace {

[[nodiscard]] b2Vec2 to_box2d(const Vec2& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

class Box2D {
 public:
  explicit Box2D(const Packing& packing) : world_({0, 0}), widening_(packing) {
    world_.SetAllowSleeping(false);
    for (const PlacedParticle& grain : packing.assembly.particles) add(grain, packing);
    drive();
  }

  void step() { world_.Step(static_cast<float>(frame), 8, 3); }

  void steer() {
    widening_.steer(contacts().coordination());
    drive();
  }

  // Those that carry a load.
  [[nodiscard]] ContactCount contacts() {
    ContactCount count;
    for (const b2Body* body : bodies_) count.grain(body->GetType() == b2_dynamicBody);
    for (b2Contact* contact = world_.GetContactList(); contact; contact = contact->GetNext()) {
      const b2Manifold& manifold = *contact->GetManifold();
      b2WorldManifold placed;
      contact->GetWorldManifold(&placed);
      bool loaded = false;
      float depth = 0;
      for (int i = 0; i < manifold.pointCount; ++i) {
        loaded |= manifold.points[i].normalImpulse > 0;
        depth = std::max(depth, -placed.separations[i]);
      }
      if (contact->IsTouching() && loaded)
        count.contact(contact->GetFixtureA()->GetBody()->GetType() == b2_dynamicBody,
                      contact->GetFixtureB()->GetBody()->GetType() == b2_dynamicBody,
                      static_cast<double>(depth));
    }
    return count;
  }

 private:
  void add(const PlacedParticle& grain, const Packing& packing) {
    const std::vector<Vec2> ring = scaled(grain.polygon.ring(), packing.mean_diameter);
    const Vec2 centre = area_properties(ring).centroid;
    b2BodyDef definition;
    definition.type = is_free(grain) ? b2_dynamicBody : b2_kinematicBody;
    definition.position = to_box2d(centre);
    b2Body* body = world_.CreateBody(&definition);
    std::vector<b2Vec2> corners;
    // Box2D adds a skin to every polygon.
    for (const Vec2& v : inset(ring, static_cast<double>(b2_polygonRadius)))
      corners.push_back(to_box2d(v - centre));
    b2PolygonShape shape;
    shape.Set(corners.data(), static_cast<int32>(corners.size()));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = static_cast<float>(packing.friction);
    fixture.restitution = 0;
    body->CreateFixture(&fixture);
    bodies_.push_back(body);
  }

  void drive() {
    for (b2Body* body : bodies_) {
      if (body->GetType() != b2_kinematicBody) continue;
      const b2Vec2 x = body->GetPosition();
      body->SetLinearVelocity(
          to_box2d(widening_.field({static_cast<double>(x.x), static_cast<double>(x.y)})));
    }
  }

  b2World world_;
  Widening widening_;
  std::vector<b2Body*> bodies_;
};

}  // namespace
}  // namespace peers

int main(int count, char** arguments) {
  return peers::time_engine<peers::Box2D>("box2d_step", "Box2D", count, arguments);
}
