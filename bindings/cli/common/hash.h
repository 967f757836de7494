#pragma once

#include <cstdint>
#include <string>

namespace halfspace::cli {

/// FNV-1a, 64 bits: detects accidental changes, not attacks.
inline std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return hash;
}

}  // namespace halfspace::cli
