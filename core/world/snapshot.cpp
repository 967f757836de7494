#include "world/snapshot.h"

#include "world/world.h"

namespace halfspace::snapshot {

template <class Part>
std::size_t write_state(const Part& part, std::byte* out) {
  Writer writer(out);
  writer(part);
  return writer.size();
}

template <int D>
bool read_state(std::span<const std::byte> state, World<D>& world) {
  Reader reader(state);
  world.state().visit(reader);
  if (reader.failed() || !reader.at_end() || !world.state().is_consistent()) return false;
  world.stages().end_reading();
  return true;
}

template <int D>
void copy_state(const World<D>& from, World<D>& to) {
  Array<std::byte> state(state_size(from.state()), std::byte(), from.blocks().kind.get_allocator());
  write_state(from.state(), state.data());
  Reader reader(state);
  to.state().visit(reader);
  to.stages().end_reading();
}

// Instantiated only here, because reading and writing generates code for each type of part.
#define HALFSPACE_STATE(D)                                             \
  template std::size_t write_state(const State<D>&, std::byte*);       \
  template std::size_t write_state(const Blocks<D>&, std::byte*);      \
  template std::size_t write_state(const Meshes<D>&, std::byte*);      \
  template std::size_t write_state(const Bonds<D>&, std::byte*);       \
  template std::size_t write_state(const ContactList<D>&, std::byte*); \
  template bool read_state(std::span<const std::byte>, World<D>&);     \
  template void copy_state(const World<D>&, World<D>&);

HALFSPACE_STATE(2)
HALFSPACE_STATE(3)
#undef HALFSPACE_STATE

}  // namespace halfspace::snapshot
