#include "detection.h"
#include "guard.h"
#include "pair_arguments.h"

using namespace halfspace;
using namespace halfspace::capi;

hs_status hs_pairs_detect(hs_context* context, const hs_shape* const shapes[], const hs_pose poses[],
                          int64_t body_count, const int32_t pairs[], int64_t pair_count,
                          const hs_pair_options* options, hs_pair_cache caches[], hs_contact contacts[],
                          int64_t* touching) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_count(body_count, "body_count");
    require_count(pair_count, "pair_count");
    if (body_count > 0) {
      require_pointer(shapes, "shapes");
      require_pointer(poses, "poses");
    }
    if (pair_count > 0) {
      require_pointer(pairs, "pairs");
      require_pointer(contacts, "contacts");
    }
    const PairOptions known = read_options(options);

    // All input is validated before anything is written.
    for (std::int64_t i = 0; i < body_count; ++i) {
      require_pointer(shapes[i], {"shapes", i});
      visit(*shapes[i], [&]<int D>(const Shape<D>&) { read_pose<D>(&poses[i], {"poses", i}); });
    }
    for (std::int64_t i = 0; i < 2 * pair_count; ++i) {
      if (pairs[i] < 0 || pairs[i] >= body_count) {
        refuse(HS_ERROR_ARGUMENT, "pairs[%lld] is %d; it must be >= 0 and below body_count, which is %lld",
               static_cast<long long>(i), pairs[i], static_cast<long long>(body_count));
      }
    }
    const auto visit_pair = [&](std::int64_t i, auto use) {
      const std::int32_t a = pairs[2 * i], b = pairs[2 * i + 1];
      visit(*shapes[a], poses[a], *shapes[b], poses[b], use);
    };
    for (std::int64_t i = 0; i < pair_count; ++i) {
      const std::int32_t a = pairs[2 * i], b = pairs[2 * i + 1];
      require_one_dimension(*shapes[a], {"shapes", a}, *shapes[b], {"shapes", b});
      require_for(shapes[a]->dimension(), known);
      if (caches) visit_pair(i, [&](const auto& posed) { read_cache(caches[i], posed); });
    }

    std::int64_t count = 0;
    for (std::int64_t i = 0; i < pair_count; ++i) {
      visit_pair(i, [&](const auto& posed) {
        detect(posed, known, caches ? &caches[i] : nullptr, &shapes[pairs[2 * i]]->context->memory,
               contacts[i]);
      });
      count += contacts[i].type != HS_CONTACT_NONE;
    }
    if (touching) *touching = count;
    return HS_OK;
  });
}
