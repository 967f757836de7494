// Steps every sample of Box2D's testbed without a window, and prints a line on each: its bodies and joints,
// how many bodies are awake in the end, how many are nowhere, whether polygons met in it, and a hash of where
// all bodies are.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "draw.h"
#include "settings.h"
#include "test.h"

// What the testbed draws goes nowhere, and nobody presses a key.
DebugDraw g_debugDraw;
Camera g_camera;
GLFWwindow* g_mainWindow = nullptr;

DebugDraw::DebugDraw() {}
DebugDraw::~DebugDraw() {}
void DebugDraw::DrawPolygon(const b2Vec2*, int32, const b2Color&) {}
void DebugDraw::DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) {}
void DebugDraw::DrawCircle(const b2Vec2&, float, const b2Color&) {}
void DebugDraw::DrawSolidCircle(const b2Vec2&, float, const b2Vec2&, const b2Color&) {}
void DebugDraw::DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) {}
void DebugDraw::DrawTransform(const b2Transform&) {}
void DebugDraw::DrawPoint(const b2Vec2&, float, const b2Color&) {}
void DebugDraw::DrawString(int, int, const char*, ...) {}
void DebugDraw::DrawString(const b2Vec2&, const char*, ...) {}
void DebugDraw::DrawAABB(b2AABB*, const b2Color&) {}
void DebugDraw::Flush() {}
extern "C" int glfwGetKey(GLFWwindow*, int) { return GLFW_RELEASE; }

namespace {

/// The world of a sample, which is protected in its base.
struct Opened : Test {
  static b2World& world_of(Test& sample) { return *(sample.*&Opened::m_world); }
};

std::uint64_t mixed(std::uint64_t hash, float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (hash ^ bits) * 0x100000001b3u;
}

bool is_polygon(const b2Fixture& fixture) { return fixture.GetType() == b2Shape::e_polygon; }

bool do_polygons_meet(b2World& world) {
  for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext()) {
    if (is_polygon(*contact->GetFixtureA()) && is_polygon(*contact->GetFixtureB())) return true;
  }
  return false;
}

void report(const TestEntry& entry, b2World& world, bool polygons_met) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  int awake = 0, nowhere = 0;
  for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    const b2Vec2 at = body->GetPosition();
    hash = mixed(mixed(mixed(hash, at.x), at.y), body->GetAngle());
    awake += body->GetType() == b2_dynamicBody && body->IsAwake();
    nowhere += !at.IsValid();
  }
  std::printf("%s, %s: %d bodies, %d joints, %d awake, %d nowhere; polygons %s, %016llx\n", entry.category,
              entry.name, world.GetBodyCount(), world.GetJointCount(), awake, nowhere,
              polygons_met ? "met" : "never met", static_cast<unsigned long long>(hash));
}

}  // namespace

int main(int, char** arguments) {
  const int steps = std::atoi(arguments[1]);
  for (int i = 0; i < g_testCount; ++i) {
    std::srand(1);
    const std::unique_ptr<Test> sample(g_testEntries[i].createFcn());
    b2World& world = Opened::world_of(*sample);
    Settings settings;
    bool polygons_met = false;
    for (int step = 0; step < steps; ++step) {
      sample->Step(settings);
      polygons_met = polygons_met || do_polygons_meet(world);
    }
    report(g_testEntries[i], world, polygons_met);
  }
}
