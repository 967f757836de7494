// Pairs that move: an answer with a cache kept from move to move is the one without, and so is that with the
// shapes swapped.

#include <algorithm>

#include "fuzz/pair_rounding.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace_test;

/// The memory of a pair. One of any bytes may be refused, until a call has written it; the library's own
/// may not.
struct Cache {
  hs_pair_cache memory{};
  bool is_own = true;  // empty, or written by the library
};

struct Pair {
  Shape a, b;
  hs_pose at_a, at_b;
  hs_pair_options options;
};

void check_contact(const hs_contact& contact, int dimension) {
  const double length_of_normal = length(vector_of(contact.normal));
  demand(std::abs(length_of_normal - 1) <= 64 * 0x1p-53, "the normal has unit length");
  demand(std::isfinite(contact.gap), "the gap is a number");
  demand(contact.point_count >= 0 && contact.point_count <= (dimension == 2 ? 2 : HS_CONTACT_POINTS),
         "points in their array");
  demand(touches(contact) || contact.point_count == 0, "what is separated has no points");
  for (int i = 0; i < contact.point_count; ++i) {
    demand(std::isfinite(contact.gaps[i]), "the gap of a point is a number");
    for (const double x : contact.points[i]) demand(std::isfinite(x), "a point is somewhere");
  }
}

bool detect(const Pair& pair, bool swapped, hs_pair_cache* cache, hs_contact& contact) {
  contact = {};
  const hs_status status = swapped ? hs_pair_detect(pair.b.get(), &pair.at_b, pair.a.get(), &pair.at_a,
                                                    &pair.options, cache, &contact)
                                   : hs_pair_detect(pair.a.get(), &pair.at_a, pair.b.get(), &pair.at_b,
                                                    &pair.options, cache, &contact);
  return succeeds_or(status, {HS_ERROR_ARGUMENT}, "detect");
}

void check_pair(const Pair& pair, Cache& cache) {
  hs_contact cold, warm, backward;
  const bool is_legal = detect(pair, false, nullptr, cold);
  if (!detect(pair, false, &cache.memory, warm)) {
    demand(!is_legal || !cache.is_own, "a cache that was written here is read");
    return;
  }
  cache.is_own = true;
  demand(is_legal, "a cache makes no argument legal");
  demand(detect(pair, true, nullptr, backward), "swapped shapes are legal as well");
  const int dimension = properties_of(pair.a.get()).dimension;
  for (const hs_contact* contact : {&cold, &warm, &backward}) check_contact(*contact, dimension);

  const double apart = length(vector_of(pair.at_b.position) - vector_of(pair.at_a.position));
  const double rounding = rounding_of_gap(pair.a.get(), pair.b.get(), apart) +
                          aside(pair.a.get(), pair.b.get(), pair.options.vertex_zone);
  if (pair.options.margin > 0) return;  // then gaps of either sign are contacts
  demand(!contradicts(warm, cold, rounding), "a cache leaves the verdict");
  demand(!contradicts(backward, cold, rounding), "swapped shapes have one verdict");
  const bool comparable = touches(cold) && cold.type == backward.type && cold.point_count <= 1;
  demand(!comparable || std::abs(cold.gap - backward.gap) <= 2 * rounding, "swapped shapes have one depth");
}

hs_pair_options read_options(Bytes& bytes) {
  hs_pair_options options;
  hs_pair_options_init(&options, sizeof options);
  if (bytes.flag()) return options;
  options.parallel_angle = bytes.positive() / 256;
  options.vertex_zone = bytes.positive() / 256;
  options.margin = bytes.flag() ? bytes.positive() : 0;
  return options;
}

/// Empty, or of any bytes but for a proof: that is believed, so that only the library's own says something.
Cache read_cache(Bytes& bytes) {
  if (bytes.byte() != 1) return {};
  Cache any{bytes.raw<hs_pair_cache>(), false};
  any.memory.shapes = 0;
  return any;
}

void run(Bytes bytes) {
  const Context context = make_context();
  const int dimension = bytes.between(2, 3);
  Pair pair{
      read_hull(bytes, context.get(), dimension), read_hull(bytes, context.get(), dimension), {}, {}, {}};
  if (!pair.a || !pair.b) return;
  pair.options = read_options(bytes);
  pair.at_a = read_pose(bytes, dimension);
  pair.at_b = read_pose(bytes, dimension);
  Cache cache = read_cache(bytes);
  check_pair(pair, cache);
  for (int moves = 0; moves < 20 && !bytes.empty(); ++moves) {
    hs_pose& pose = bytes.flag() ? pair.at_a : pair.at_b;
    if (bytes.flag()) {
      pose = read_pose(bytes, dimension);
    } else {
      const double share = bytes.positive();
      for (int i = 0; i < dimension; ++i) pose.position[i] += share * bytes.number();
    }
    check_pair(pair, cache);
  }
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::run({data, size});
  return 0;
}
