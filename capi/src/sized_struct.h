#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "require.h"

namespace halfspace::capi {

/// Upper bound of the size of any struct of any version.
constexpr std::size_t largest_struct = 1u << 16;
/// Lower bound of the size of any definition: those of all versions begin with their size and one more field.
constexpr std::size_t min_definition = 2 * sizeof(std::uint32_t);

/// Fills a struct of the caller's version, which follows from its size: copies the fields that both versions
/// have, and sets fields of a later version to 0.
template <class Struct>
void write_sized(const Struct& ours, Struct* out, std::size_t size) {
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &ours, std::min(size, sizeof ours));
}

/// Refuses a size below that of the first version of the report.
inline void require_report_size(std::size_t size, std::size_t first_version) {
  if (size < first_version || size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "size is %zu; it must be the size of the struct, from %zu to %zu", size,
           first_version, largest_struct);
  }
}

/// The defaults of a definition; specialised next to the functions that read it.
template <class Definition>
Definition default_definition();

/// Reads a definition of the caller's version, which follows from its size: the fields that both versions
/// have; others keep their defaults.
template <class Definition>
Definition read_definition(const Definition* given, const char* name) {
  require_pointer(given, name);
  if (given->struct_size < min_definition || given->struct_size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "%s.struct_size is %u; fill the definition with its init function", name,
           given->struct_size);
  }
  Definition known = default_definition<Definition>();
  std::memcpy(static_cast<void*>(&known), given, std::min<std::size_t>(given->struct_size, sizeof known));
  known.struct_size = sizeof known;
  return known;
}

/// The body of all init functions of definitions: writes the defaults of the fields that the caller's struct
/// has.
template <class Definition>
hs_status write_definition(Definition* def, std::size_t size) {
  if (!def || size < min_definition || size > largest_struct) return HS_ERROR_ARGUMENT;
  Definition defaults = default_definition<Definition>();
  defaults.struct_size = static_cast<std::uint32_t>(size);
  write_sized(defaults, def, size);
  return HS_OK;
}

}  // namespace halfspace::capi
