#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "require.h"

namespace halfspace::capi {

/// No struct of any version is larger: beyond it a size is garbage.
constexpr std::size_t largest_struct = 1u << 16;

/// Fills a caller's struct, whose size tells with which version of it the caller was compiled: as much of
/// ours as it holds, and zeros for what only a later version knows.
template <class Struct>
void write_sized(const Struct& ours, Struct* out, std::size_t size) {
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &ours, std::min(size, sizeof ours));
}

/// The size of a report, refused when it is below that of the report's first version.
inline void require_report_size(std::size_t size, std::size_t first_version) {
  if (size < first_version || size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "size is %zu; it must be that of the struct, from %zu to %zu", size,
           first_version, largest_struct);
  }
}

/// The defaults of a definition, given next to the functions that read it.
template <class Definition>
Definition default_definition();

/// A definition's size tells which version of it the caller was compiled with; a smaller or larger one than
/// ours is met by reading what both know.
template <class Definition>
Definition read_definition(const Definition* given, const char* name) {
  require_pointer(given, name);
  constexpr std::size_t least = 2 * sizeof(std::uint32_t);
  if (given->struct_size < least || given->struct_size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "%s.struct_size is %u; fill the definition with its init function", name,
           given->struct_size);
  }
  Definition known = default_definition<Definition>();
  std::memcpy(static_cast<void*>(&known), given, std::min<std::size_t>(given->struct_size, sizeof known));
  known.struct_size = sizeof known;
  return known;
}

/// The init function behind every definition: the defaults, as much of them as the caller's struct holds.
template <class Definition>
hs_status write_definition(Definition* def, std::size_t size) {
  if (!def || size < 2 * sizeof(std::uint32_t) || size > largest_struct) return HS_ERROR_ARGUMENT;
  Definition defaults = default_definition<Definition>();
  defaults.struct_size = static_cast<std::uint32_t>(size);
  write_sized(defaults, def, size);
  return HS_OK;
}

}  // namespace halfspace::capi
