/** @file
 *  @brief Contact detection of one pair or many pairs, for hosts with their own bodies. It is stateless; the
 *  caller may keep a cache per pair.
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

/** Cached state of a pair between calls: the last violated potential contact pair if separated, the initial
 *  contact pair (Wang et al. 2021, section 2.5) if in contact. All zero is an empty cache. It may be copied,
 *  also to another process.
 *
 *  A separated pair also caches a separation proof: the distance of the centroids along `normal` exceeded
 *  `reach`, and the gap was their difference. As long as the motion since then is bounded by the gap minus
 *  hs_pair_options.margin, detection returns from the proof alone, without reading the shapes: with the
 *  cached pair and normal, and as gap a lower bound, the old gap minus the bound of the motion. The proof is
 *  ignored for other shapes. */
typedef struct hs_pair_cache {
  int32_t state;        /**< 0 unknown, 1 separated, 2 in contact */
  int32_t pair_kind;    /**< an HS_PAIR_ value, of the cached pair */
  int32_t feature_a;    /**< index of a's vertex, edge or face in it; for a separated pair a vertex is only
                             the start of the search */
  int32_t feature_b;    /**< index of b's feature, likewise */
  uint64_t shapes;      /**< fingerprint of the proof's shapes; 0: no proof */
  double reach;         /**< of the proof: sum of the support distances of both shapes along the normal, m */
  double normal[3];     /**< of the proof: unit vector from a to b */
  double rotation_a[4]; /**< of the proof: rotation of a, quaternion x, y, z, w */
  double rotation_b[4]; /**< of the proof: rotation of b */
} hs_pair_cache;

/** Options of detection. Fill it with hs_pair_options_init(). */
typedef struct hs_pair_options {
  uint32_t struct_size;  /**< set by hs_pair_options_init() */
  uint32_t reserved;     /**< 0 */
  double parallel_angle; /**< max angle of edges (3D: faces, or an edge and a face) that are parallel, rad,
                              [0, 0.5]; default 0.01. An existing region is kept up to larger angles */
  double vertex_zone;    /**< distance from the end of an edge (3D: the boundary of a face) at which a vertex
                              touches that end, over the shorter edge; [0, 0.5]; default 1e-6 */
  double margin;         /**< polygons are in contact up to this gap (skin); gaps of a contact may be above 0,
                              at a corner above the margin. m, [0, 1e75], polyhedra 0; default 0 */
  int32_t without_region; /**< 1: report only the pair of largest gap of polygons in contact, as
                               HS_CONTACT_VERTEX_EDGE without region, uncached; polyhedra 0; default 0 */
  int32_t reserved_2;     /**< 0 */
} hs_pair_options;

/** @brief Fills detection options with their defaults.
 *  @param options to fill
 *  @param size sizeof(hs_pair_options) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_pair_options_init(hs_pair_options *options, size_t size);

/** @brief Detects the contact of two shapes. A separated pair has the type HS_CONTACT_NONE.
 *  @param shape_a,shape_b the shapes, of the same dimension; may be the same shape
 *  @param pose_a,pose_b their poses
 *  @param options NULL for the defaults
 *  @param[in,out] cache NULL, or the cache of this pair from the last call: detection is faster and keeps the
 *         contact plane of the first touch
 *  @param[in,out] contact receives type, pair, normal, gap, and if in contact the region; other fields are
 *         not written
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (polygons of more than 32 vertices) */
HS_CHECKED hs_status hs_pair_detect(const hs_shape *shape_a, const hs_pose *pose_a, const hs_shape *shape_b,
                                    const hs_pose *pose_b, const hs_pair_options *options,
                                    hs_pair_cache *cache, hs_contact *contact);

/** @brief Detects the contacts of many pairs.
 *  @param context keeps the error text
 *  @param shapes shapes of the bodies, body_count pointers; those of a pair have the same dimension
 *  @param poses poses of the bodies, body_count
 *  @param body_count number of bodies, >= 0
 *  @param pairs body indices a, b of each pair, 2 * pair_count values
 *  @param pair_count number of pairs, >= 0
 *  @param options NULL for the defaults
 *  @param[in,out] caches NULL, or one per pair
 *  @param[in,out] contacts receives one per pair, in the order of the pairs; HS_CONTACT_NONE if separated
 *  @param touching receives the number of pairs in contact; may be NULL
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY: the pairs before the failing one have been
 *         written */
HS_CHECKED hs_status hs_pairs_detect(hs_context *context, const hs_shape *const shapes[],
                                     const hs_pose poses[], int64_t body_count, const int32_t pairs[],
                                     int64_t pair_count, const hs_pair_options *options,
                                     hs_pair_cache caches[], hs_contact contacts[], int64_t *touching);

#ifdef __cplusplus
}
#endif
#endif
