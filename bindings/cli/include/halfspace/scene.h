/** @file
 *  @brief Scene files: the library behind the command `halfspace`, for other languages.
 *
 *  The library `halfspace_scene` reads TOML scenes (docs/scenes/index.md), makes worlds of them, and runs
 *  them as the command does. It belongs to the command, not to the C interface of the kernel: the bindings for
 *  Fortran and Rust do not wrap it.
 *
 *  Thread rule: a scene admits one thread at a time, and so does the context that a call receives.
 */
#ifndef HALFSPACE_SCENE_H
#define HALFSPACE_SCENE_H

#include "halfspace/halfspace.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A scene. It keeps the text of the last error, and the texts of hs_scene_get_text(). */
typedef struct hs_scene hs_scene;

/** Texts of a scene. */
enum {
  HS_SCENE_TEXT_TOML = 0,    /**< the scene with its settings, as a file */
  HS_SCENE_TEXT_NOTES = 1,   /**< notes on unusual input of the last world, run or search, a line each */
  HS_SCENE_TEXT_NAMES = 2,   /**< names of the blocks of the last world, as hs_world_get_blocks(), a line each */
  HS_SCENE_TEXT_REPORT = 3,  /**< the summary of the last run or search */
  HS_SCENE_TEXT_TROUBLE = 4  /**< the reason why the last run ended as unstable or too fast; else empty */
};

/** The end of a run or search. */
enum {
  HS_SCENE_COMPLETE = 0,    /**< the duration is over; a search has found its bracket */
  HS_SCENE_AT_REST = 1,     /**< all free blocks are slower than the rest speed */
  HS_SCENE_INTERRUPTED = 2, /**< a callback has ended it */
  HS_SCENE_UNSTABLE = 3,    /**< the time step is too large */
  HS_SCENE_TOO_FAST = 4,    /**< two blocks approach too fast, and `fast_blocks` refuses them */
  HS_SCENE_NOT_FOUND = 5    /**< a search: the scene is not at rest, or the bracket is wrong; see the report */
};

/** Quantities of a scene that was read. */
typedef struct hs_scene_properties {
  int32_t dimension;   /**< 2 or 3 */
  int32_t threads;     /**< number of threads that the scene requests */
  double duration;     /**< s; of a scene with stages the sum of the stages that run */
  int64_t stage_count; /**< 0 or more */
} hs_scene_properties;

/** @brief Receives the progress of a run or search, some ten times per second.
 *  @param user pointer of the caller @param fraction completed, of the stage or search, 0 to 1
 *  @param where position of the work, for a reader @return 0 to continue, 1 to end it */
typedef int32_t (*hs_scene_progress)(void *user, double fraction, const char *where);

/** @brief Receives the world at its start, after each interval of the history, and at its end.
 *  @param user pointer of the caller @param world valid during the call, in the context of the run
 *  @return 0 to continue, 1 to end the run */
typedef int32_t (*hs_scene_row)(void *user, hs_world *world);

/** A run. */
typedef struct hs_scene_run_def {
  const char *directory;      /**< of the output files; created if missing; not NULL */
  int32_t replaces;           /**< 1: replace an earlier run in the directory; default 0: refuse it */
  const char *from;           /**< file of a checkpoint of this scene; default NULL: from the start */
  hs_scene_progress progress; /**< default NULL */
  hs_scene_row row;           /**< default NULL */
  void *user;                 /**< for both */
} hs_scene_run_def;

/** Results of a run. */
typedef struct hs_scene_run_result {
  int32_t end;             /**< an HS_SCENE_ value */
  double time;             /**< s, at the end */
  int64_t steps;           /**< number of steps */
  double run_out;          /**< m, farthest horizontal spread of the free blocks */
  double max_displacement; /**< m, of the centroid of a free block */
  double largest_overlap;  /**< m, in the whole run */
  double energy_residual;  /**< J */
} hs_scene_run_result;

/** A search for the factor of safety. */
typedef struct hs_scene_safety_def {
  double low;                 /**< lower end of the bracket, where the scene is stable; default 0.5 */
  double high;                /**< upper end, where it falls; default 5 */
  double resolution;          /**< final width of the bracket; default 0.005 */
  double limit;               /**< m, displacement of a fallen block; default 0: by elastic displacement */
  const char *directory;      /**< of the output files; created if missing; not NULL */
  int32_t replaces;           /**< 1: replace an earlier run in the directory; default 0: refuse it */
  int32_t resumes;            /**< 1: continue from the trials in the directory; default 0 */
  hs_scene_progress progress; /**< default NULL */
  void *user;                 /**< for it */
} hs_scene_safety_def;

/** Quantities that hs_scene_find_limit() varies. */
enum {
  HS_SCENE_VARY_TILT = 0,   /**< the direction of gravity, by an angle in degrees */
  HS_SCENE_VARY_LOADS = 1,  /**< a factor of the loads of meshes */
  HS_SCENE_VARY_SETTING = 2 /**< a number of the scene */
};

/** A search for the largest, or the smallest, value at which a scene is stable. */
typedef struct hs_scene_limit_def {
  int32_t varied;             /**< an HS_SCENE_VARY_ value; default HS_SCENE_VARY_TILT */
  int32_t smallest;           /**< 1: the scene falls below the value; default 0: above it */
  const char *name;           /**< axis of a tilt, as "-x", NULL: z in 2D, x in 3D; group, mesh or mesh/group of
                                   loads, NULL: all; key of a setting, not NULL; default NULL */
  double low;                 /**< lower end of the bracket; default NaN: 0, of a setting required */
  double high;                /**< upper end; default NaN: 90 degrees or a factor of 10, of a setting required */
  double resolution;          /**< final width of the bracket; default 0: a thousandth of it */
  double limit;               /**< m, displacement of a fallen block; default 0: as for safety, and a tenth of
                                   its size in motion */
  const char *directory;      /**< of the output files; created if missing; not NULL */
  int32_t replaces;           /**< 1: replace an earlier run in the directory; default 0: refuse it */
  int32_t resumes;            /**< 1: continue from the trials in the directory; default 0 */
  hs_scene_progress progress; /**< default NULL */
  void *user;                 /**< for it */
} hs_scene_limit_def;

/** Results of a search. */
typedef struct hs_scene_search_result {
  int32_t end;   /**< an HS_SCENE_ value */
  double stable; /**< the value nearest to the limit at which the scene was stable; NaN without any */
  double falls;  /**< the value nearest to the limit at which it fell; NaN without any */
} hs_scene_search_result;

/** @brief Creates an empty scene. @param scene receives it @return HS_OK, HS_ERROR_ARGUMENT or
 *  HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_scene_create(hs_scene **scene);

/** @brief Destroys a scene. @param scene may be NULL */
HS_API void hs_scene_destroy(hs_scene *scene);

/** @brief Returns the text of the last error. @param scene not NULL @return valid until the next call */
HS_API const char *hs_scene_last_error(const hs_scene *scene);

/** @brief Returns a text of a scene.
 *  @param scene not NULL @param text an HS_SCENE_TEXT_ value
 *  @return valid until the next call with the scene; empty for other values and before it is known */
HS_API const char *hs_scene_get_text(const hs_scene *scene, int32_t text);

/** @brief Reads a scene. A faulty one leaves the scene as it was; the error text has all faults, a line each,
 *  with file, line, column and key.
 *  @param scene not NULL @param toml its text, UTF-8, not NULL @param size of the text in bytes
 *  @param file name in error texts; relative file names in the scene refer to its folder; not NULL
 *  @param settings texts `key=value`, which replace values of the scene @param setting_count >= 0
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_FORMAT for a faulty scene, or HS_ERROR_OUT_OF_MEMORY */
HS_CHECKED hs_status hs_scene_read(hs_scene *scene, const char *toml, size_t size, const char *file,
                                   const char *const settings[], int64_t setting_count);

/** @brief Returns quantities of a scene. @param scene that was read @param properties receives them
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STATE */
HS_CHECKED hs_status hs_scene_get_properties(hs_scene *scene, hs_scene_properties *properties);

/** @brief Makes the world at the start of a scene, with notes and names. Stages, and motions of prescribed
 *  blocks that start or stop later, take part in runs only.
 *  @param scene that was read @param context allocates the world @param world receives it, the caller's to
 *  destroy; NULL for the notes alone
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE, HS_ERROR_FORMAT for faulty blocks, or an error of the
 *  kernel */
HS_CHECKED hs_status hs_scene_make_world(hs_scene *scene, hs_context *context, hs_world **world);

/** @brief Makes the shapes of all blocks of a scene, in the order of their names, for hs_scene_take_shape().
 *  @param scene that was read @param context allocates them @param count receives their number
 *  @return as hs_scene_make_world() */
HS_CHECKED hs_status hs_scene_make_shapes(hs_scene *scene, hs_context *context, int64_t *count);

/** @brief Hands a shape of hs_scene_make_shapes() over to the caller.
 *  @param scene not NULL @param index from 0; each shape once @param shape receives it
 *  @return HS_OK, HS_ERROR_ARGUMENT or HS_ERROR_STATE */
HS_CHECKED hs_status hs_scene_take_shape(hs_scene *scene, int64_t index, hs_shape **shape);

/** @brief Fills the definition of a run with its defaults. @param def not NULL */
HS_API void hs_scene_run_def_init(hs_scene_run_def *def);

/** @brief Runs a scene through its stages and writes the files of `halfspace run`, with the same bytes.
 *  @param scene that was read @param context with the threads of the run @param def not NULL
 *  @param result receives the results; may be NULL
 *  @param world receives the world at the end, the caller's to destroy; may be NULL
 *  @return HS_OK also for interrupted and unstable runs; HS_ERROR_ARGUMENT, HS_ERROR_STATE for a directory in
 *  use or a checkpoint of another scene, HS_ERROR_FORMAT for faulty blocks, or an error of the kernel */
HS_CHECKED hs_status hs_scene_run(hs_scene *scene, hs_context *context, const hs_scene_run_def *def,
                                  hs_scene_run_result *result, hs_world **world);

/** @brief Fills the definition of a search with its defaults. @param def not NULL */
HS_API void hs_scene_safety_def_init(hs_scene_safety_def *def);

/** @brief Finds the factor of safety and writes the files of `halfspace safety`.
 *  @param scene that was read @param context with the threads of the search @param def not NULL
 *  @param result receives the results; may be NULL @return as hs_scene_run() */
HS_CHECKED hs_status hs_scene_find_safety(hs_scene *scene, hs_context *context,
                                          const hs_scene_safety_def *def, hs_scene_search_result *result);

/** @brief Fills the definition of a search with its defaults. @param def not NULL */
HS_API void hs_scene_limit_def_init(hs_scene_limit_def *def);

/** @brief Finds the largest, or the smallest, tilt, factor of loads or value of a key at which the scene is
 *  stable, and writes the files of `halfspace limit`.
 *  @param scene that was read @param context with the threads of the search
 *  @param def not NULL @param result receives the results; may be NULL
 *  @return as hs_scene_run(); HS_ERROR_FORMAT also if the scene is faulty at an end of the bracket */
HS_CHECKED hs_status hs_scene_find_limit(hs_scene *scene, hs_context *context, const hs_scene_limit_def *def,
                                         hs_scene_search_result *result);

/** @brief Writes the blocks of any world, or its contacts, as a file of VTK XML PolyData for ParaView.
 *  @param scene keeps the error text; it need not have been read @param context of the world
 *  @param world not NULL
 *  @param start poses from which displacements are measured, as hs_world_get_poses(); NULL: they are 0
 *  @param blocks file of the blocks @param contacts file of the contacts; NULL: none
 *  @return HS_OK, HS_ERROR_ARGUMENT, HS_ERROR_STATE if a file cannot be written, or an error of the kernel */
HS_CHECKED hs_status hs_scene_write_vtk(hs_scene *scene, hs_context *context, const hs_world *world,
                                        const hs_pose *start, const char *blocks, const char *contacts);

#ifdef __cplusplus
}
#endif
#endif
