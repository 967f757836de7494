/** @file
 *  @brief Time of impact: when do two moving shapes first touch? For hosts whose blocks may pass through each other between two looks.
 */
#ifndef HALFSPACE_IMPACT_H
#define HALFSPACE_IMPACT_H

#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What comes of two motions. */
enum {
  HS_IMPACT_NEVER = 0,    /**< they do not touch within the duration */
  HS_IMPACT_AT_START = 1, /**< they touch at the start already */
  HS_IMPACT_TOUCH = 2     /**< they are apart at the start and come to touch */
};

/** How a shape moves: its centroid straight and its turn even. Fill it with hs_motion_def_init(): then it rests at the origin. At time t
 *  the point that is at X in the shape's frame is at position + t velocity + R(t angular_velocity) Q (gradient + t gradient_rate) X, with
 *  position and Q those of `start`, and R(v) the turn about v by its length. */
typedef struct hs_motion_def {
  uint32_t struct_size;       /**< set by hs_motion_def_init() */
  uint32_t reserved;          /**< 0 */
  hs_pose start;              /**< where it is at first */
  double velocity[3];         /**< of the centroid, m/s */
  double angular_velocity[3]; /**< rad/s; in 2D about z; it may turn by up to 1e6 rad in the duration */
  double gradient[9];         /**< how it is strained at first, before `start` turns it: row by row, as of affine blocks (affine.h);
                                   default the identity */
  double gradient_rate[9];    /**< of the gradient, 1/s; default 0 */
} hs_motion_def;

/** When, where and how two moving shapes first touch. */
typedef struct hs_impact {
  int32_t state;     /**< an HS_IMPACT_ value; of HS_IMPACT_NEVER all that follows is 0 but the time */
  int32_t pair_kind; /**< of the potential pair of largest gap then: an HS_PAIR_ value, not HS_PAIR_VERTEX_VERTEX */
  int32_t feature_a; /**< index of a's vertex, edge or face in that pair */
  int32_t feature_b; /**< index of b's, likewise */
  double time;       /**< s from the start; never later than the first touch; the duration for HS_IMPACT_NEVER */
  double gap;        /**< of the pair then: small to rounding; <= 0 when touching at the start */
  double normal[3];  /**< unit, from a to b then */
  double point[3];   /**< where they touch: the middle of the contact region */
} hs_impact;

/** @brief Fills a motion with its defaults: at the origin, not turned, at rest.
 *  @param def to fill
 *  @param size sizeof(hs_motion_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_motion_def_init(hs_motion_def *def, size_t size);

/** @brief When do two moving shapes first touch?
 *
 *  The shapes are apart at every time before the one told: no touch is passed over, however fast or thin the shapes are or however often
 *  they turn. Told early it may be by as much as rounding takes: the gap is then within some 1e-12 of the shapes' size, their distance and
 *  their way together, times 1 and the angle that they turn by. Should shapes come that near and part again, a touch may be told. Only
 *  where shapes graze each other through hundreds of turns the search may end sooner, with a larger `gap`: earlier, too, and never later.
 *  @param shape_a,shape_b the shapes, both of one dimension; the same one twice is legal
 *  @param motion_a,motion_b how they move
 *  @param duration of the motions, s, finite, >= 0
 *  @param impact receives when, where and how
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (shapes of many vertices). Thread rule: as for hs_pair_detect(). */
HS_CHECKED hs_status hs_pair_time_of_impact(const hs_shape *shape_a, const hs_motion_def *motion_a,
                                            const hs_shape *shape_b, const hs_motion_def *motion_b,
                                            double duration, hs_impact *impact);

#ifdef __cplusplus
}
#endif
#endif
