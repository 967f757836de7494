#include "halfspace/viewer.h"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "recording/bytes.h"
#include "recording/recording.h"
#include "recording/run_folder.h"

struct hs_recording {
  halfspace::viewer::Recording recording;
};

namespace {

using namespace halfspace::viewer;

thread_local std::string last_error;

/// The result of `body`, or `failed` with the text of its exception kept.
template <class Result, class Body>
Result guarded(Result failed, Body body) {
  try {
    return body();
  } catch (const std::exception& error) {
    last_error = error.what();
  } catch (...) {
    last_error = "unknown error";
  }
  return failed;
}

template <class Body>
int32_t guarded(Body body) {
  return guarded(-1, [&] {
    body();
    return 0;
  });
}

Recording& recording_of(hs_recording* recording) {
  if (!recording) throw std::invalid_argument("recording is NULL");
  return recording->recording;
}

/// The recording, if it has a frame to be filled.
Recording& filled(hs_recording* recording) {
  Recording& found = recording_of(recording);
  if (found.frame_count() == 0) throw std::logic_error("the recording has no frame yet");
  return found;
}

std::size_t block_of(const Recording& recording, int64_t number) {
  if (number < 0 || static_cast<std::size_t>(number) >= recording.block_count())
    throw std::invalid_argument("there is no block " + std::to_string(number) +
                                "; blocks: " + std::to_string(recording.block_count()));
  return static_cast<std::size_t>(number);
}

std::string text_of(const char* name, const char* text) {
  if (!text) throw std::invalid_argument(std::string(name) + " is NULL");
  return text;
}

/// Arrays of so many values, which are there. @throws std::invalid_argument
template <class... Arrays>
void require_arrays(const char* name, int64_t count, const Arrays*... arrays) {
  if (count < 0) throw std::invalid_argument(std::string(name) + " is " + std::to_string(count));
  if (count > 0 && !(... && arrays))
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(count) + ", and an array NULL");
}

Point point_at(const double values[], int64_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

Pose pose_at(const double values[], int64_t index) {
  const double* at = values + 7 * index;
  return {{at[0], at[1], at[2]}, {at[3], at[4], at[5], at[6]}};
}

}  // namespace

hs_recording* hs_recording_create(int32_t dimension, const char* title) {
  return guarded<hs_recording*>(nullptr, [&] {
    if (dimension != 2 && dimension != 3)
      throw std::invalid_argument("dimension is " + std::to_string(dimension) + "; allowed: 2, 3");
    return new hs_recording{Recording(dimension, text_of("title", title))};
  });
}

hs_recording* hs_recording_read(const char* directory) {
  return guarded<hs_recording*>(nullptr,
                                [&] { return new hs_recording{read_run(text_of("directory", directory))}; });
}

void hs_recording_destroy(hs_recording* recording) { delete recording; }

const char* hs_recording_error() { return last_error.c_str(); }

int64_t hs_recording_add_block(hs_recording* recording, const char* name, int32_t kind, int32_t material,
                               const double pose[7], int64_t vertex_count, const double vertices[],
                               int64_t face_count, const int32_t face_sizes[],
                               const int32_t face_vertices[]) {
  return guarded<int64_t>(-1, [&] {
    require_arrays("vertex_count", vertex_count, vertices);
    require_arrays("face_count", face_count, face_sizes, face_vertices);
    if (!pose) throw std::invalid_argument("pose is NULL");
    BlockShape shape{.name = text_of("name", name), .kind = kind, .material = material};
    for (int64_t v = 0; v < vertex_count; ++v) shape.vertices.push_back(point_at(vertices, v));
    for (int64_t f = 0; f < face_count; ++f) {
      if (face_sizes[f] < 0)
        throw std::invalid_argument("face_sizes[" + std::to_string(f) + "] is " +
                                    std::to_string(face_sizes[f]));
      shape.faces.emplace_back(face_vertices, face_vertices + face_sizes[f]);
      face_vertices += face_sizes[f];
    }
    return static_cast<int64_t>(recording_of(recording).add_block(std::move(shape), pose_at(pose, 0)));
  });
}

int32_t hs_recording_set_materials(hs_recording* recording, int64_t count, const char* const names[]) {
  return guarded([&] {
    require_arrays("count", count, names);
    std::vector<std::string> texts;
    for (int64_t i = 0; i < count; ++i) texts.push_back(text_of("a name", names[i]));
    recording_of(recording).set_material_names(std::move(texts));
  });
}

int32_t hs_recording_add_frame(hs_recording* recording, double time) {
  return guarded([&] { recording_of(recording).add_frame(time); });
}

int32_t hs_recording_set_poses(hs_recording* recording, int64_t count, const int64_t blocks[],
                               const double poses[]) {
  return guarded([&] {
    require_arrays("count", count, blocks, poses);
    Recording& found = filled(recording);
    for (int64_t i = 0; i < count; ++i) found.set_rigid(block_of(found, blocks[i]), pose_at(poses, i));
  });
}

int32_t hs_recording_set_vertices(hs_recording* recording, int64_t block, const double vertices[]) {
  return guarded([&] {
    Recording& found = filled(recording);
    const std::size_t number = block_of(found, block);
    require_arrays("the number of vertices", static_cast<int64_t>(found.shape(number).vertices.size()),
                   vertices);
    std::vector<Point> points;
    for (std::size_t v = 0; v < found.shape(number).vertices.size(); ++v)
      points.push_back(point_at(vertices, static_cast<int64_t>(v)));
    found.set_vertices(number, points, {0, 0, 0, 1});
  });
}

int32_t hs_recording_set_values(hs_recording* recording, const char* name, const char* unit, int64_t count,
                                const int64_t blocks[], const double values[]) {
  return guarded([&] {
    require_arrays("count", count, blocks, values);
    Recording& found = filled(recording);
    for (int64_t i = 0; i < count; ++i)
      found.set_value(text_of("name", name), text_of("unit", unit), block_of(found, blocks[i]), values[i]);
  });
}

int32_t hs_recording_set_contacts(hs_recording* recording, int64_t count, const int64_t blocks_a[],
                                  const int64_t blocks_b[], const double points[], const double forces[],
                                  const double normal_forces[]) {
  return guarded([&] {
    require_arrays("count", count, blocks_a, blocks_b, points, forces, normal_forces);
    Recording& found = filled(recording);
    std::vector<ContactForce> contacts;
    for (int64_t c = 0; c < count; ++c)
      contacts.push_back({block_of(found, blocks_a[c]), block_of(found, blocks_b[c]), point_at(points, c),
                          point_at(forces, c), normal_forces[c]});
    found.set_contacts(std::move(contacts));
  });
}

int32_t hs_recording_set_bolts(hs_recording* recording, int64_t count, const int64_t numbers[],
                               const double places_a[], const double places_b[], const double tensions[],
                               const int32_t are_ruptured[]) {
  return guarded([&] {
    require_arrays("count", count, numbers, places_a, places_b, tensions, are_ruptured);
    Recording& found = filled(recording);
    for (int64_t i = 0; i < count; ++i) {
      if (numbers[i] < 0)
        throw std::invalid_argument("the number of a bolt is " + std::to_string(numbers[i]));
      found.set_bolt({static_cast<std::size_t>(numbers[i]), point_at(places_a, i), point_at(places_b, i),
                      tensions[i], are_ruptured[i] != 0});
    }
  });
}

int32_t hs_recording_add_cracks(hs_recording* recording, int64_t count, const double times[],
                                const int64_t blocks_a[], const int64_t blocks_b[], const double positions[],
                                const double normals[], const double areas[], const int32_t are_shear[]) {
  return guarded([&] {
    require_arrays("count", count, times, blocks_a, blocks_b, positions, normals, areas, are_shear);
    Recording& found = recording_of(recording);
    for (int64_t i = 0; i < count; ++i)
      found.add_crack({times[i],
                       {block_of(found, blocks_a[i]), block_of(found, blocks_b[i])},
                       point_at(positions, i),
                       point_at(normals, i),
                       areas[i],
                       are_shear[i] != 0});
  });
}

int32_t hs_recording_set_history(hs_recording* recording, const char* csv) {
  return guarded([&] { recording_of(recording).set_history(text_of("csv", csv)); });
}

int32_t hs_recording_write(hs_recording* recording, const char* viewer, const char* file) {
  return guarded([&] {
    write_bytes(text_of("file", file), recording_of(recording).page(bytes_of(text_of("viewer", viewer))));
  });
}
