// Preloaded before libhalfspace, it hears what a program is told through the C API. At the program's end it
// adds a line to the file that GOLDEN_RECORD names: one number for all that it heard, and how many times it
// heard something.
//
// It hears worlds after each call that moves or detects, worlds when they end, reports, answers about pairs,
// and shapes when they end. With GOLDEN_ENDS_ONLY it hears of worlds only how they end: some programs step as
// far at a time as the clock lets them.
//
// The number is a sum of hashes, so that threads may be told things in any order. Only the last look at a
// world asks for its report, which evaluates forces that the host may not have asked for yet.

#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "golden/record.h"

namespace {

using namespace halfspace_test;

class Record {
 public:
  void add(const Hash& hash) {
    sum_ += hash.value();
    ++count_;
  }
  ~Record() {
    const char* path = std::getenv("GOLDEN_RECORD");
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    std::fprintf(file, "%016" PRIx64 " %9" PRIu64 "\n", sum_.load(), count_.load());
    std::fclose(file);
  }

 private:
  std::atomic<std::uint64_t> sum_ = 0, count_ = 0;
};

Record heard;

const bool ends_only = std::getenv("GOLDEN_ENDS_ONLY");

/// While it lives, what ends is half made, and ended by the library itself.
struct WithinLibrary {
  static thread_local int depth;
  WithinLibrary() { ++depth; }
  ~WithinLibrary() { --depth; }
};
thread_local int WithinLibrary::depth = 0;

// The library's own function. The recorder's function of the same name stands before it.
#define LIBRARY(function)                                                                         \
  ([] {                                                                                           \
    static const auto found = reinterpret_cast<decltype(&function)>(dlsym(RTLD_NEXT, #function)); \
    return found;                                                                                 \
  }())

void add_status(hs_status status) {
  Hash hash;
  hash(status);
  heard.add(hash);
}

void record_whole(Hash& hash, const hs_world_report& report) {
  record(hash, report);
  hash.all(report.peak_overlap, report.peak_speed);
}

void record_motion(Hash& hash, const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_blocks(world, nullptr, 0, &count);
  std::vector<hs_block> blocks(static_cast<std::size_t>(count));
  (void)hs_world_get_blocks(world, blocks.data(), count, nullptr);
  for (const hs_block block : blocks) {
    hash(block);
    record(hash, state_of(world, block));
    record(hash, deformation_of(world, block));
  }
  for (const hs_contact& contact : contacts_of(world)) record(hash, contact);
}

/// How a call left a world.
hs_status heard_of(const hs_world* world, hs_status status) {
  if (!world || ends_only) return status;
  Hash hash;
  hash(status);
  record_motion(hash, world);
  heard.add(hash);
  return status;
}

void record_shape(Hash& hash, const hs_shape* shape) {
  hs_shape_properties p{};
  (void)hs_shape_get_properties(shape, &p, sizeof p);
  hash.all(p.dimension, p.vertex_count, p.edge_count, p.face_count, p.volume, p.centroid, p.second_moment,
           p.bounding_radius, p.shortest_edge);

  struct Vector {
    double values[3];
  };
  const auto view_of_all = [](std::vector<Vector>& v) {
    return hs_mutable_view{&v[0].values[0], &v[0].values[1], &v[0].values[2], sizeof(Vector),
                           std::int64_t(v.size())};
  };
  std::vector<Vector> vertices(std::size_t(p.vertex_count)), normals(std::size_t(p.face_count));
  std::vector<double> offsets(normals.size());
  (void)hs_shape_get_vertices(shape, view_of_all(vertices), nullptr);
  (void)hs_shape_get_halfspaces(shape, view_of_all(normals), offsets.data(), nullptr);
  for (const Vector& vertex : vertices) hash(vertex.values);
  for (const Vector& normal : normals) hash(normal.values);
  hash.first(offsets.data(), offsets.size());

  std::vector<std::int32_t> first_of_face(normals.size() + 1), corners(2 * std::size_t(p.edge_count)),
      ends(corners.size());
  (void)hs_shape_get_faces(shape, first_of_face.data(), std::int64_t(first_of_face.size()), corners.data(),
                           std::int64_t(corners.size()), nullptr, nullptr);
  (void)hs_shape_get_edges(shape, ends.data(), p.edge_count, nullptr);
  for (const auto& indices : {first_of_face, corners, ends}) hash.first(indices.data(), indices.size());
}

}  // namespace

hs_status hs_world_step(hs_world* world, int64_t steps) {
  return heard_of(world, LIBRARY(hs_world_step)(world, steps));
}

hs_status hs_world_detect(hs_world* world, int64_t* touching) {
  return heard_of(world, LIBRARY(hs_world_detect)(world, touching));
}

hs_status hs_world_forces(hs_world* world, double elapsed, hs_mutable_view forces, hs_mutable_view torques) {
  return heard_of(world, LIBRARY(hs_world_forces)(world, elapsed, forces, torques));
}

hs_status hs_world_get_report(hs_world* world, hs_world_report* report, size_t size) {
  const hs_status status = LIBRARY(hs_world_get_report)(world, report, size);
  if (ends_only) return status;
  if (status < 0) {
    add_status(status);
    return status;
  }
  // The program may know less of it than the library.
  hs_world_report known{};
  std::memcpy(&known, report, std::min(size, sizeof known));
  Hash hash;
  record_whole(hash, known);
  heard.add(hash);
  return status;
}

void hs_world_destroy(hs_world* world) {
  if (world && WithinLibrary::depth == 0) {
    hs_world_report report{};
    Hash hash;
    hash(LIBRARY(hs_world_get_report)(world, &report, sizeof report));
    record_whole(hash, report);
    record_motion(hash, world);
    heard.add(hash);
  }
  LIBRARY(hs_world_destroy)(world);
}

hs_status hs_world_restore(hs_context* context, const void* bytes, size_t count, hs_world** world) {
  const WithinLibrary within;
  const hs_status status = LIBRARY(hs_world_restore)(context, bytes, count, world);
  if (status >= 0) return heard_of(*world, status);
  add_status(status);
  return status;
}

hs_status hs_pair_detect(const hs_shape* shape_a, const hs_pose* pose_a, const hs_shape* shape_b,
                         const hs_pose* pose_b, const hs_pair_options* options, hs_pair_cache* cache,
                         hs_contact* contact) {
  const hs_status status = LIBRARY(hs_pair_detect)(shape_a, pose_a, shape_b, pose_b, options, cache, contact);
  Hash hash;
  hash(status);
  if (status >= 0) record_detected(hash, *contact);
  heard.add(hash);
  return status;
}

hs_status hs_pairs_detect(hs_context* context, const hs_shape* const shapes[], const hs_pose poses[],
                          int64_t body_count, const int32_t pairs[], int64_t pair_count,
                          const hs_pair_options* options, hs_pair_cache caches[], hs_contact contacts[],
                          int64_t* touching) {
  const hs_status status = LIBRARY(hs_pairs_detect)(context, shapes, poses, body_count, pairs, pair_count,
                                                    options, caches, contacts, touching);
  Hash hash;
  hash(status);
  if (status >= 0)
    std::for_each_n(contacts, pair_count, [&](const hs_contact& contact) { record_detected(hash, contact); });
  heard.add(hash);
  return status;
}

hs_status hs_pair_time_of_impact(const hs_shape* shape_a, const hs_motion_def* motion_a,
                                 const hs_shape* shape_b, const hs_motion_def* motion_b, double duration,
                                 hs_impact* impact) {
  const hs_status status =
      LIBRARY(hs_pair_time_of_impact)(shape_a, motion_a, shape_b, motion_b, duration, impact);
  Hash hash;
  hash(status);
  if (status >= 0) record(hash, *impact);
  heard.add(hash);
  return status;
}

hs_status hs_shape_cut(const hs_shape* shape, const double point[3], const double normal[3],
                       hs_shape** behind, hs_shape** ahead) {
  const WithinLibrary within;
  const hs_status status = LIBRARY(hs_shape_cut)(shape, point, normal, behind, ahead);
  add_status(status);
  return status;
}

void hs_shape_destroy(hs_shape* shape) {
  if (shape && WithinLibrary::depth == 0) {
    Hash hash;
    record_shape(hash, shape);
    heard.add(hash);
  }
  LIBRARY(hs_shape_destroy)(shape);
}
