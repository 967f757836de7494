/** @file
 *  @brief Detection for hosts that keep their own bodies: one pair, or many. Stateless but for a cache that
 *  the caller may keep.
 */
#ifndef HALFSPACE_PAIR_H
#define HALFSPACE_PAIR_H

#include "halfspace/contact.h"
#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a pair remembers between calls: the last violated potential pair while separated, the initial contact
 *  pair while in contact. All zero is an empty cache. Copy it freely, also to another process. Initial contact
 *  pairs are those of Wang et al. 2021, section 2.5.
 *
 *  While separated it also holds a proof: along `normal` the two centroids were farther apart than the shapes
 *  reach together. A call whose blocks have moved and turned by less than the gap, or by less than what of it
 *  is beyond hs_pair_options.margin, since answers from the proof alone, without a look at the shapes; its
 *  contact has the proof's pair and normal, and as gap what is left of the gap after the most that the motion
 *  can have taken. The proof is of the two shapes that it was found for; with others it is not used. */
typedef struct hs_pair_cache {
  int32_t state;        /**< 0 unknown, 1 separated, 2 in contact */
  int32_t pair_kind;    /**< of the remembered pair: an HS_PAIR_ value */
  int32_t feature_a;    /**< index of a's vertex, edge or face in it; a vertex of a separated pair is only
                             where to look for the deepest one first */
  int32_t feature_b;    /**< index of b's, likewise */
  uint64_t shapes;      /**< the proof: fingerprint of its shapes, 0 if there is none */
  double reach;         /**< of both shapes together, along the normal, as they were turned then */
  double normal[3];     /**< unit, from a to b */
  double rotation_a[4]; /**< how a was turned then: quaternion x, y, z, w */
  double rotation_b[4]; /**< how b was turned then */
} hs_pair_cache;

/** Settings of detection. Fill it with hs_pair_options_init(). */
typedef struct hs_pair_options {
  uint32_t struct_size;  /**< set by hs_pair_options_init() */
  uint32_t reserved;     /**< 0 */
  double parallel_angle; /**< edges (3D: faces, or an edge and a face) closer to parallel than this share a
                              region; rad, [0, 0.5]; default 0.01. A region that exists is followed to larger
                              angles, so that the energy does not jump */
  double vertex_zone;    /**< how near the end of an edge (3D: the border of a face) a vertex meets what is
                              there: share of the shorter of the two edges that face each other; [0, 0.5];
                              default 1e-6 */
  double margin;         /**< polygons are separated only when a gap exceeds it, and in contact otherwise; for
                              hosts whose blocks wear a skin. The gaps of a contact may be above 0 then, of one
                              at a corner above the margin. m, [0, 1e75], polyhedra 0; default 0 */
  int32_t without_region; /**< 1: a contact between polygons is the pair of largest gap and no more, for hosts
                              that make their own points: its type is HS_CONTACT_VERTEX_EDGE, it has no points,
                              `area` and what follows stay as they were, and the cache remembers nothing of
                              it; polyhedra 0; default 0 */
  int32_t reserved_2;     /**< 0 */
} hs_pair_options;

/** @brief Fills detection options with their defaults.
 *  @param options to fill
 *  @param size sizeof(hs_pair_options) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_pair_options_init(hs_pair_options *options, size_t size);

/** @brief Are two shapes in contact, and how?
 *  @param shape_a,shape_b the shapes, both of one dimension; the same one twice is legal
 *  @param pose_a,pose_b where they are
 *  @param options NULL for the defaults
 *  @param[in,out] cache NULL, or the pair's memory from the last call: makes the answer faster and, in
 *         contact, keeps the plane through which the pair met
 *  @param[in,out] contact receives type, pair, normal, gap, and of a contact its region; the rest stays
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (polygons of more than 32 vertices) */
HS_CHECKED hs_status hs_pair_detect(const hs_shape *shape_a, const hs_pose *pose_a, const hs_shape *shape_b,
                                    const hs_pose *pose_b, const hs_pair_options *options,
                                    hs_pair_cache *cache, hs_contact *contact);

/** @brief Detects many pairs.
 *  @param context for the error text
 *  @param shapes shapes of the bodies, body_count pointers; those of a pair are of one dimension
 *  @param poses poses of the bodies, body_count
 *  @param body_count number of bodies, >= 0
 *  @param pairs body indices a, b of each pair, 2 * pair_count values
 *  @param pair_count number of pairs, >= 0
 *  @param options NULL for the defaults
 *  @param[in,out] caches NULL, or one per pair
 *  @param[in,out] contacts receives one per pair, in the order of the pairs, separated ones with
 *         HS_CONTACT_NONE
 *  @param touching receives the number of pairs in contact; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY; then the pairs before the failing one have
 *          been written */
HS_CHECKED hs_status hs_pairs_detect(hs_context *context, const hs_shape *const shapes[],
                                     const hs_pose poses[], int64_t body_count, const int32_t pairs[],
                                     int64_t pair_count, const hs_pair_options *options,
                                     hs_pair_cache caches[], hs_contact contacts[], int64_t *touching);

#ifdef __cplusplus
}
#endif
#endif
