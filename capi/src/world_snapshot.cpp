#include "world.h"
#include "world/snapshot.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

struct Header {
  std::uint64_t magic = snapshot::magic;
  std::uint32_t version = snapshot::version;
  std::uint32_t dimension = 2;
  std::uint64_t size = 0;  // of what follows
  std::uint64_t checksum = 0;
};

std::size_t state_size(World<2>& world) {
  snapshot::Writer counter(nullptr);
  world.visit(counter);
  return counter.size();
}

}  // namespace

hs_status hs_world_save(const hs_world* world, void* bytes, size_t capacity, size_t* count) {
  return guarded(context_of(world), __func__, [&] {
    require_pointer(world, "world");
    require_pointer(count, "count");
    if (capacity > 0) require_pointer(bytes, "bytes");
    World<2>& w = const_cast<World<2>&>(world->world);  // one visit() serves reading and writing
    const std::size_t size = state_size(w);
    *count = sizeof(Header) + size;
    if (*count > capacity) return HS_NOTE_TRUNCATED;
    std::byte* state = static_cast<std::byte*>(bytes) + sizeof(Header);
    snapshot::Writer writer(state);
    w.visit(writer);
    Header header;
    header.size = size;
    header.checksum = snapshot::checksum({state, size});
    std::memcpy(bytes, &header, sizeof header);
    return HS_OK;
  });
}

hs_status hs_world_restore(hs_context* context, const void* bytes, size_t count, hs_world** world) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(bytes, "bytes");
    require_pointer(world, "world");
    Header header;
    if (count < sizeof header)
      refuse(HS_ERROR_FORMAT, "count is %zu; a snapshot has at least %zu bytes", count, sizeof header);
    std::memcpy(&header, bytes, sizeof header);
    const Header expected;
    if (header.magic != expected.magic) refuse(HS_ERROR_FORMAT, "bytes do not begin as a snapshot does");
    if (header.version != expected.version || header.dimension != expected.dimension) {
      refuse(HS_ERROR_FORMAT,
             "snapshot has version %u and dimension %u; this library reads version %u, dimension %u",
             header.version, header.dimension, expected.version, expected.dimension);
    }
    const std::span<const std::byte> state(static_cast<const std::byte*>(bytes) + sizeof header,
                                           count - sizeof header);
    if (header.size != state.size()) {
      refuse(HS_ERROR_FORMAT, "count is %zu; the snapshot says %zu", count,
             std::size_t(header.size) + sizeof header);
    }
    if (header.checksum != snapshot::checksum(state))
      refuse(HS_ERROR_FORMAT, "bytes are damaged: the checksum differs");

    hs_world* restored = create<hs_world>(context, context, WorldSettings<2>());
    try {
      snapshot::Reader reader(state);
      restored->world.visit(reader);
      if (reader.failed() || !reader.at_end() || !restored->world.is_consistent())
        refuse(HS_ERROR_FORMAT, "bytes do not hold what a snapshot holds");
    } catch (...) {
      hs_world_destroy(restored);
      throw;
    }
    *world = restored;
    return HS_OK;
  });
}
