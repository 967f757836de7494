/** @file
 *  @brief Time of impact of two moving shapes, for hosts whose blocks may tunnel through each other between
 *  two detections.
 */
#ifndef HALFSPACE_IMPACT_H
#define HALFSPACE_IMPACT_H

#include "halfspace/shape.h"
#include "halfspace/status.h"
#include "halfspace/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Results of hs_pair_time_of_impact(). */
enum {
  HS_IMPACT_NEVER = 0,    /**< the shapes do not touch within the duration */
  HS_IMPACT_AT_START = 1, /**< the shapes touch at time 0 */
  HS_IMPACT_TOUCH = 2     /**< the shapes are separated at time 0 and touch later */
};

/** Motion of a shape with constant linear and angular velocity and constant rate of deformation. Fill it with
 *  hs_motion_def_init(): at rest at the origin. At time t the material point X (in the shape's frame) is at
 *  position + t velocity + R(t angular_velocity) Q (gradient + t gradient_rate) X, with position and rotation
 *  Q of `start`, and R(v) the rotation about v by the angle |v|. */
typedef struct hs_motion_def {
  uint32_t struct_size;       /**< set by hs_motion_def_init() */
  uint32_t reserved;          /**< 0 */
  hs_pose start;              /**< pose at time 0 */
  double velocity[3];         /**< of the centroid, m/s */
  double angular_velocity[3]; /**< rad/s; in 2D about z; times the duration at most 1e6 rad */
  double gradient[9];         /**< deformation gradient at time 0, before the rotation of `start`, row by row
                                   (see affine.h); default identity */
  double gradient_rate[9];    /**< rate of the deformation gradient, 1/s; default 0 */
} hs_motion_def;

/** First touch of two moving shapes. */
typedef struct hs_impact {
  int32_t state;     /**< an HS_IMPACT_ value; for HS_IMPACT_NEVER all later fields except time are 0 */
  int32_t pair_kind; /**< potential contact pair of largest gap at that time: an HS_PAIR_ value, not
                          HS_PAIR_VERTEX_VERTEX */
  int32_t feature_a; /**< index of a's vertex, edge or face in that pair */
  int32_t feature_b; /**< index of b's feature, likewise */
  double time;       /**< s; never later than the first touch; the duration for HS_IMPACT_NEVER */
  double gap;        /**< gap of the pair at that time, m, > 0 and close to rounding; <= 0 for
                          HS_IMPACT_AT_START */
  double normal[3];  /**< unit vector from a to b at that time */
  double point[3];   /**< centroid of the contact region */
} hs_impact;

/** @brief Fills a motion with its defaults: at rest at the origin, without rotation.
 *  @param def to fill
 *  @param size sizeof(hs_motion_def) as the caller was compiled
 *  @return HS_OK or HS_ERROR_ARGUMENT. Thread rule: any thread, any time. */
HS_API hs_status hs_motion_def_init(hs_motion_def *def, size_t size);

/** @brief Computes the time of impact of two moving shapes by conservative advancement (Mirtich 1996).
 *
 *  The shapes are separated at all times before the reported one, whatever their speed, thickness or number
 *  of revolutions. The reported time may be early by rounding only: the gap is then at most about 1e-12 of
 *  (size + distance + relative displacement) times (1 + angle of rotation). Shapes that come that close
 *  without touching may be reported as touching. After hundreds of revolutions of grazing shapes the search
 *  may stop early, with a larger `gap`; it is never late.
 *  @param shape_a,shape_b the shapes, of the same dimension; may be the same shape
 *  @param motion_a,motion_b their motions
 *  @param duration s, finite, >= 0
 *  @param impact receives time, place and normal of the first touch
 *  @return HS_OK, HS_ERROR_ARGUMENT, or HS_ERROR_OUT_OF_MEMORY (shapes of many vertices). Thread rule: as for
 *         hs_pair_detect(). */
HS_CHECKED hs_status hs_pair_time_of_impact(const hs_shape *shape_a, const hs_motion_def *motion_a,
                                            const hs_shape *shape_b, const hs_motion_def *motion_b,
                                            double duration, hs_impact *impact);

#ifdef __cplusplus
}
#endif
#endif
