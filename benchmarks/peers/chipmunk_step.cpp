// SPDX-License-Identifier: BSL-1.0
// chipmunk_step PACKING  times steps of Chipmunk.

#include <chipmunk/chipmunk.h>

#include "impulse_engine.hpp"

namespace peers {
namespace {

class Chipmunk {
 public:
  explicit Chipmunk(const Packing& packing) : space_(cpSpaceNew()), widening_(packing) {
    cpSpaceSetIterations(space_, 10);
    cpSpaceSetCollisionSlop(space_, 0.005);  // of the size; the default is meant for pixels
    for (const PlacedParticle& grain : packing.assembly.particles) add(grain, packing);
    drive();
  }
  // The process ends with the engine: nothing is freed.

  void step() { cpSpaceStep(space_, frame); }

  void steer() {
    widening_.steer(contacts().coordination());
    drive();
  }

  // Those that carry a load, from the side of each free grain.
  [[nodiscard]] ContactCount contacts() {
    ContactCount count;
    for (cpBody* body : bodies_) {
      if (cpBodyGetType(body) != CP_BODY_TYPE_DYNAMIC) continue;
      count.grain(true);
      cpBodyEachArbiter(
          body,
          [](cpBody*, cpArbiter* arbiter, void* data) {
            const cpVect impulse = cpArbiterTotalImpulse(arbiter);
            if (cpvdot(impulse, impulse) == 0) return;
            double depth = 0;
            for (int i = 0; i < cpArbiterGetCount(arbiter); ++i)
              depth = std::max(depth, -cpArbiterGetDepth(arbiter, i));
            static_cast<ContactCount*>(data)->contact(true, false, depth);
          },
          &count);
    }
    return count;
  }

 private:
  void add(const PlacedParticle& grain, const Packing& packing) {
    const std::vector<Vec2> ring = scaled(grain.polygon.ring(), packing.mean_diameter);
    const AreaProperties properties = area_properties(ring);
    std::vector<cpVect> corners;
    for (const Vec2& v : ring) {
      const Vec2 x = v - properties.centroid;
      corners.push_back(cpv(x.x(), x.y()));
    }
    cpBody* body =
        is_free(grain) ? cpBodyNew(properties.area, properties.polar_moment) : cpBodyNewKinematic();
    cpBodySetPosition(body, cpv(properties.centroid.x(), properties.centroid.y()));
    cpSpaceAddBody(space_, body);
    cpShape* shape = cpPolyShapeNew(body, static_cast<int>(corners.size()), corners.data(),
                                    cpTransformIdentity, 0);
    cpShapeSetFriction(shape, std::sqrt(packing.friction));  // of a pair: the product of the two
    cpShapeSetElasticity(shape, 0);
    // Grains of the ring do not meet each other.
    if (!is_free(grain))
      cpShapeSetFilter(shape, cpShapeFilterNew(1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
    cpSpaceAddShape(space_, shape);
    bodies_.push_back(body);
  }

  void drive() {
    for (cpBody* body : bodies_) {
      if (cpBodyGetType(body) != CP_BODY_TYPE_KINEMATIC) continue;
      const cpVect x = cpBodyGetPosition(body);
      const Vec2 v = widening_.field({x.x, x.y});
      cpBodySetVelocity(body, cpv(v.x(), v.y()));
    }
  }

  cpSpace* space_;
  Widening widening_;
  std::vector<cpBody*> bodies_;
};

}  // namespace
}  // namespace peers

int main(int count, char** arguments) {
  return peers::time_engine<peers::Chipmunk>("chipmunk_step", "Chipmunk", count, arguments);
}
