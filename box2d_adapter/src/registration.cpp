#include "registration.h"

#include <box2d/b2_block_allocator.h>

#include <map>
#include <mutex>
#include <utility>

#include "contact.h"

namespace halfspace::box2d {
namespace {

/// Box2D's table is protected, so access needs a class derived from b2Contact. It has no instances.
class ContactTable : b2Contact {
 public:
  /// Box2D fills its table at its first contact, and would overwrite earlier entries.
  static b2ContactCreateFcn* exchange_polygons(b2ContactCreateFcn* create) {
    if (!s_initialized) InitializeRegisters();
    s_initialized = true;
    return std::exchange(s_registers[b2Shape::e_polygon][b2Shape::e_polygon].createFcn, create);
  }
};

/// The narrow phases of the process.
struct Register {
  std::mutex mutex;
  std::map<const b2World*, NarrowPhase::Installation*> installations;
  b2ContactCreateFcn* create_of_box2d = nullptr;
};
/// Created by the first narrow phase, so that it outlives narrow phases in global variables of the host.
Register& known() {
  static Register made;
  return made;
}

NarrowPhase::Installation* installation_in(const b2World* world) {
  const std::lock_guard lock(known().mutex);
  const auto found = known().installations.find(world);
  return found == known().installations.end() ? nullptr : found->second;
}

b2Contact* create(b2Fixture* a, int32 index_a, b2Fixture* b, int32 index_b, b2BlockAllocator* allocator) {
  NarrowPhase::Installation* installation = installation_in(a->GetBody()->GetWorld());
  if (!installation) return known().create_of_box2d(a, index_a, b, index_b, allocator);
  return new (allocator->Allocate(int32(sizeof(PolygonContact)))) PolygonContact(a, b, *installation);
}

}  // namespace

bool enter(const b2World& world, NarrowPhase::Installation& installation) {
  const std::lock_guard lock(known().mutex);
  if (!known().installations.emplace(&world, &installation).second) return false;
  if (known().installations.size() == 1) known().create_of_box2d = ContactTable::exchange_polygons(create);
  return true;
}

void withdraw(const b2World& world) {
  const std::lock_guard lock(known().mutex);
  known().installations.erase(&world);
  if (known().installations.empty()) ContactTable::exchange_polygons(known().create_of_box2d);
}

}  // namespace halfspace::box2d
