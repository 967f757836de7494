/** @file
 *  @brief Recordings of runs, and pages of HTML that play them.
 *
 *  A recording has blocks, and frames with what the blocks do. It is written as one file, which shows the run
 * in a browser and fetches nothing. This interface is of the library halfspace_viewer, which does not depend
 * on the library of the kernel. A function that fails returns -1 or NULL; hs_recording_error() says why.
 *  Thread rule: a recording is used by one thread at a time.
 */
#ifndef HALFSPACE_VIEWER_H
#define HALFSPACE_VIEWER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Opaque recording. */
typedef struct hs_recording hs_recording;

/** @brief Creates an empty recording. @param dimension 2 or 3 @param title of the page, UTF-8 */
hs_recording* hs_recording_create(int32_t dimension, const char* title);

/** @brief Creates the recording of a run from the output directory of the command. @param directory UTF-8 */
hs_recording* hs_recording_read(const char* directory);

/** @brief Destroys a recording. @param recording may be NULL */
void hs_recording_destroy(hs_recording* recording);

/** @brief The text of the last error of the calling thread. */
const char* hs_recording_error(void);

/** @brief Adds a block. It is in no frame until a frame has its pose or its vertices.
 *  @param recording not NULL @param name UTF-8; empty: its number
 *  @param kind an HS_BLOCK_ value: affine blocks and cells of meshes deform, all others are rigid
 *  @param material index
 *  @param pose position and quaternion x, y, z, w, at which the vertices are given
 *  @param vertex_count number of vertices @param vertices 3 coordinates each
 *  @param face_count number of faces; in 2D 1, the outline
 *  @param face_sizes number of vertices of each @param face_vertices of all faces, counter-clockwise from
 * outside
 *  @return the number of the block, from 0 */
int64_t hs_recording_add_block(hs_recording* recording, const char* name, int32_t kind, int32_t material,
                               const double pose[7], int64_t vertex_count, const double vertices[],
                               int64_t face_count, const int32_t face_sizes[], const int32_t face_vertices[]);

/** @brief Names the materials. @param recording not NULL @param count of names @param names UTF-8 */
int32_t hs_recording_set_materials(hs_recording* recording, int64_t count, const char* const names[]);

/** @brief Begins the next frame. @param recording not NULL @param time s */
int32_t hs_recording_add_frame(hs_recording* recording, double time);

/** @brief Sets the poses of rigid blocks in the frame.
 *  @param recording not NULL @param count of blocks @param blocks their numbers @param poses 7 values each */
int32_t hs_recording_set_poses(hs_recording* recording, int64_t count, const int64_t blocks[],
                               const double poses[]);

/** @brief Sets the vertices of a block that deforms in the frame.
 *  @param recording not NULL @param block its number @param vertices 3 coordinates each, as many as it has */
int32_t hs_recording_set_vertices(hs_recording* recording, int64_t block, const double vertices[]);

/** @brief Sets a quantity of blocks in the frame.
 *  @param recording not NULL @param name of the quantity @param unit may be empty
 *  @param count of blocks @param blocks their numbers @param values one each */
int32_t hs_recording_set_values(hs_recording* recording, const char* name, const char* unit, int64_t count,
                                const int64_t blocks[], const double values[]);

/** @brief Sets the contacts of the frame.
 *  @param recording not NULL @param count of contacts @param blocks_a,blocks_b numbers of the blocks of each
 *  @param points 3 coordinates each @param forces on block b, 3 components each
 *  @param normal_forces one each; compression is positive */
int32_t hs_recording_set_contacts(hs_recording* recording, int64_t count, const int64_t blocks_a[],
                                  const int64_t blocks_b[], const double points[], const double forces[],
                                  const double normal_forces[]);

/** @brief Sets the bolts of the frame.
 *  @param recording not NULL @param count of bolts @param numbers of the bolts, from 0
 *  @param places_a,places_b the ends, 3 coordinates each @param tensions one each
 *  @param are_ruptured 1 or 0 each */
int32_t hs_recording_set_bolts(hs_recording* recording, int64_t count, const int64_t numbers[],
                               const double places_a[], const double places_b[], const double tensions[],
                               const int32_t are_ruptured[]);

/** @brief Adds failures of points of bonds, at any time.
 *  @param recording not NULL @param count of cracks @param times s, one each
 *  @param blocks_a,blocks_b numbers of the blocks of each @param positions at these times, 3 coordinates each
 *  @param normals from block a to block b, of length 1, 3 components each
 *  @param areas m2, in 2D lengths, one each @param are_shear 1 or 0 each */
int32_t hs_recording_add_cracks(hs_recording* recording, int64_t count, const double times[],
                                const int64_t blocks_a[], const int64_t blocks_b[], const double positions[],
                                const double normals[], const double areas[], const int32_t are_shear[]);

/** @brief Sets the history that is charted beside the picture.
 *  @param recording not NULL @param csv comma-separated values with a line of names, among them `time` */
int32_t hs_recording_set_history(hs_recording* recording, const char* csv);

/** @brief Writes the recording as a page of HTML. It takes no more frames then.
 *  @param recording not NULL, with a frame @param viewer the path of viewer.html, which is installed with the
 * library
 *  @param file the path to write */
int32_t hs_recording_write(hs_recording* recording, const char* viewer, const char* file);

#ifdef __cplusplus
}
#endif
#endif
