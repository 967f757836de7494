#include <cstring>
#include <memory>
#include <vector>

#include "bare_law.h"
#include "catch.h"
#include "contacts_3d.h"
#include "world/snapshot.h"
#include "world/world.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// Hands out memory full of a given byte, so that what is saved without having been set shows.
class FilledMemory : public Memory {
 public:
  explicit FilledMemory(int byte) : byte_(byte) {}

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    void* const memory = std::pmr::new_delete_resource()->allocate(bytes, alignment);
    return std::memset(memory, byte_, bytes);
  }
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
    std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
  }
  bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }
  int byte_;
};

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const World<3>& world) {
  Bytes bytes(snapshot::state_size(world.state()));
  snapshot::write_state(world.state(), bytes.data());
  return bytes;
}

/// As a host reads it; null when it is refused.
std::unique_ptr<World<3>> world_of(const Bytes& bytes, Memory* memory) {
  auto world = std::make_unique<World<3>>(WorldSettings<3>(), memory);
  return snapshot::read_state(std::span<const std::byte>(bytes), *world) ? std::move(world) : nullptr;
}

/// A few blocks of every kind that lie and knock on each other with friction, two of them bonded, and one
/// slot free.
std::unique_ptr<World<3>> busy_world(Memory* memory) {
  WorldSettings<3> settings;
  settings.gravity = {0, 0, -10};
  settings.time_step = 1e-3;
  auto world = std::make_unique<World<3>>(settings, memory);
  const std::int32_t stone = world->add_material(1000), glue = world->add_material(1500),
                     clay = world->add_material(1200);
  ContactLaw law = test::bare_law();
  law.normal_stiffness = 1e6;
  law.shear_stiffness = 5e5;
  law.tan_friction = 0.5;
  law.normal_damping = 0.1;
  world->set_default_law(law);
  law.stiffness_kind = StiffnessKind::per_area;
  law.cohesion = law.tensile_strength = 1e6;
  world->set_law(glue, glue, law);
  law.stiffness_kind = StiffnessKind::potential;
  world->set_law(clay, stone, law);
  Random random(101);
  Elasticity rubber;
  rubber.lame = rubber.shear_modulus = 1e7;
  rubber.damping_time = 1e-4;
  world->set_elasticity(stone, rubber);
  const Shape<3> cube = shape_of(completed(box({1, 1, 1}))), tip = block_of(octahedron(0.5, 0.5, 0.7));
  world->add_block(shape_of(completed(box({8, 8, 1}))), BlockKind::fixed, stone, {0, 0, -0.5}, {});
  const std::int32_t gone = world->add_block(tip, BlockKind::rigid, stone, {3, 3, 3}, {});
  world->add_block(cube, BlockKind::rigid, glue, {0, 0, 0.5}, {});
  world->add_block(cube, BlockKind::rigid, glue, {0, 0, 1.5}, {});
  world->add_block(tip, BlockKind::rigid, stone, {1.3, 0, 0.72}, Rotation<3>().turned_by({0.3, 0.1, 0}));
  const std::int32_t soft = world->add_block(tip, BlockKind::affine, stone, {0, -1.3, 0.68}, {});
  world->add_block(cube, BlockKind::rigid, clay, {-2, -2, 0.5}, {});
  world->add_surface_load(soft, 0, {0, 100, -100});
  const std::int32_t ram = world->add_block(cube, BlockKind::prescribed, stone, {-1.05, 0.2, 0.8}, {});
  world->set_velocity(ram, {0.5, 0, 0}, {0, 0, 0.2});
  for (int i = 0; i < 150; ++i) REQUIRE(world->step() == StepResult::ok);
  world->remove_block(gone);
  for (int i = 0; i < 50; ++i) REQUIRE(world->step() == StepResult::ok);
  REQUIRE(world->state().contacts.count() >= 5);
  return world;
}

/// Everything that reads indices: steps, contacts, removals, additions.
void use(World<3>& world) {
  for (int i = 0; i < 3; ++i)
    if (world.step() != StepResult::ok) break;
  world.detect();
  for (std::size_t c = 0; c < world.state().contacts.count(); ++c) world.state().contacts.contact(c);
  for (std::size_t i = 0; i < world.blocks().slot_count(); ++i)
    if (world.blocks().lives(i) && i % 2 == 0) world.remove_block(std::int32_t(i));
  if (world.model().materials.count() > 0)
    world.add_block(shape_of(completed(box({1, 1, 1}))), BlockKind::rigid, 0, {0, 0, 5}, {});
  world.step();
  for (std::size_t i = 0; i < world.blocks().slot_count(); ++i)
    if (world.blocks().lives(i)) world.remove_block(std::int32_t(i));
}

}  // namespace

TEST_CASE("in space, a world comes back from its bytes to the bit, and goes on to the bit") {
  FilledMemory zeros(0), others(0xa5);
  const auto world = busy_world(&zeros);
  const Bytes bytes = bytes_of(*world);
  // Made in other memory, it has the same bytes: none that nobody has set.
  CHECK(bytes_of(*busy_world(&others)) == bytes);
  const auto restored = world_of(bytes, &others);
  REQUIRE(restored);
  CHECK(bytes_of(*restored) == bytes);
  for (int i = 0; i < 300; ++i) {
    REQUIRE(world->step() == StepResult::ok);
    REQUIRE(restored->step() == StepResult::ok);
  }
  CHECK(bytes_of(*restored) == bytes_of(*world));
  CHECK(bytes_of(*world) != bytes);
}

TEST_CASE("in space, a snapshot that ends too early is refused, wherever it ends") {
  Memory* const memory = std::pmr::get_default_resource();
  const Bytes bytes = bytes_of(*busy_world(memory));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    CHECK_FALSE(world_of(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(length)), memory));
  Bytes longer = bytes;
  longer.push_back(std::byte(0));
  CHECK_FALSE(world_of(longer, memory));
}

TEST_CASE("in space, a damaged snapshot is refused, or whatever is run of it stays within its arrays") {
  Memory* const memory = std::pmr::get_default_resource();
  const Bytes bytes = bytes_of(*busy_world(memory));
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    // All bits; and in turn the sign, what makes of 1 an infinity, and the least.
    constexpr int others[] = {0x80, 0x40, 0x01};
    for (const int mask : {0xff, others[i % 3]}) {
      Bytes damaged = bytes;
      damaged[i] ^= std::byte(mask);
      try {
        if (const auto world = world_of(damaged, memory)) {
          use(*world);
        } else {
          ++refused;
        }
      } catch (const std::bad_alloc&) {
        // A world of blocks that large takes more memory than there is: said, as at any other time.
      } catch (const std::length_error&) {
        FAIL("byte " << i << " makes an array longer than can be");
      }
    }
  }
  CHECK(refused > int(bytes.size()) / 10);
}
