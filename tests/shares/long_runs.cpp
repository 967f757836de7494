#include "shares/compare.h"

// The same for runs in which many blocks change shares.

using namespace halfspace_test;

TEST_CASE("shares keep the bits over 30 000 steps", "[shares]") {
  const LawOfStiffness& of = laws_of_stiffness[GENERATE(0, 1, 2)];
  const std::int32_t kind = GENERATE(std::int32_t(HS_BLOCK_RIGID), std::int32_t(HS_BLOCK_AFFINE));
  const bool is_plane = GENERATE(true, false);
  INFO(of.name << ", kind " << kind << (is_plane ? ", plane" : ", space"));
  const std::vector<unsigned char> start = is_plane ? heap_in_plane(of, kind) : heap_in_space(of, kind);
  for (const std::size_t shares : {2, 3, 8}) {
    const Seen seen = compare(start, shares, 30000);
    CHECK(seen.migrations >= 100);
    WARN(shares << " shares: " << seen.assemblies << " assemblies, " << seen.migrations << " migrations, "
                << seen.entrances << " for entry faces");
  }
}
