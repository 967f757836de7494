#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/library.h"

namespace halfspace::cli {

/// The blocks of a world or of a share, in the order of their keys.
struct SharedBlocks {
  SharedBlocks(const Context& context, const hs_world* world);
  std::vector<std::int64_t> keys_of(std::int32_t role) const;

  std::vector<std::int64_t> keys;
  std::vector<std::int32_t> roles;
};

hs_share_info share_info_of(const Context& context, hs_world* world);

/// The records of blocks, one after the other.
class Records {
 public:
  /// @throws LibraryError
  Records(const Context& context, hs_world* world, std::vector<std::int64_t> keys, bool with_shapes);
  /// Adds the blocks, which refer to these records, to those of a share.
  void add_to(std::vector<hs_packed>& blocks, std::int32_t role) const;

 private:
  std::vector<std::int64_t> keys_;
  std::vector<std::size_t> ends_;
  std::vector<char> bytes_;
};

/// Blocks that the world has from which a share is assembled.
void add_present(std::vector<hs_packed>& blocks, const std::vector<std::int64_t>& keys, std::int32_t role);

/// A world of these blocks, in any order. @throws LibraryError
World assembled(const Context& context, hs_world* from, std::vector<hs_packed> blocks);

}  // namespace halfspace::cli
