#include "world_bytes.h"

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

}  // namespace

hs_status hs_world_save(const hs_world* world, void* bytes, size_t capacity, size_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_between_steps(w);
    require_pointer(count, "count");
    if (capacity > 0) require_pointer(bytes, "bytes");
    const std::size_t size = snapshot::state_size(w.state());
    *count = sizeof(Header) + size;
    if (*count > capacity) return HS_NOTE_TRUNCATED;
    std::byte* state = static_cast<std::byte*>(bytes) + sizeof(Header);
    snapshot::write_state(w.state(), state);
    Header header;
    header.dimension = D;
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
    if (header.magic != snapshot::magic)
      refuse(HS_ERROR_FORMAT, "bytes do not begin with the magic number of a snapshot");
    if (header.version != snapshot::version || (header.dimension != 2 && header.dimension != 3)) {
      refuse(HS_ERROR_FORMAT,
             "snapshot has version %u and dimension %u; this library reads version %u, dimension 2 or 3",
             header.version, header.dimension, snapshot::version);
    }
    const std::span<const std::byte> state(static_cast<const std::byte*>(bytes) + sizeof header,
                                           count - sizeof header);
    if (header.size != state.size()) {
      refuse(HS_ERROR_FORMAT, "count is %zu; the snapshot has %zu bytes", count,
             std::size_t(header.size) + sizeof header);
    }
    if (header.checksum != snapshot::checksum(state))
      refuse(HS_ERROR_FORMAT, "bytes are damaged: the checksum differs");
    if (header.dimension == 2)
      *world = restore<2>(context, state);
    else
      *world = restore<3>(context, state);
    return HS_OK;
  });
}
