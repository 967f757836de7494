#include "pair.h"

#include "check.h"
#include "contact.h"
#include "detect/pair.h"
#include "guard.h"
#include "shape.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_pair_options default_definition() {
  const DetectOptions defaults;
  return {0, 0, defaults.parallel_angle, defaults.vertex_zone};
}

DetectOptions read_detect_options(double parallel_angle, double vertex_zone) {
  require(parallel_angle >= 0 && parallel_angle <= 0.5, parallel_angle, "parallel_angle", "from 0 to 0.5 rad");
  require(vertex_zone >= 0 && vertex_zone <= 0.5, vertex_zone, "vertex_zone", "from 0 to 0.5");
  return {parallel_angle, vertex_zone};
}

namespace {

DetectOptions read_options(const hs_pair_options* options) {
  if (!options) return {};
  const hs_pair_options known = read_definition(options, "options");
  return read_detect_options(known.parallel_angle, known.vertex_zone);
}

PairMemory read_cache(const hs_pair_cache& cache, const Outline<2>& a, const Outline<2>& b) {
  if (cache.state < PairMemory::unknown || cache.state > PairMemory::touching) {
    refuse(HS_ERROR_ARGUMENT, "cache->state is %d; it must be 0, 1 or 2", cache.state);
  }
  PairMemory memory;
  if (cache.state == PairMemory::unknown) return memory;
  memory.state = PairMemory::State(cache.state);
  if (cache.edge < 0 || cache.edge >= a.count + b.count) {
    refuse(HS_ERROR_ARGUMENT, "cache->edge is %d; the shapes have %d edges", cache.edge, a.count + b.count);
  }
  memory.pair.owner = cache.edge < a.count ? 0 : 1;
  memory.pair.edge = memory.pair.owner == 0 ? cache.edge : cache.edge - a.count;
  const int vertices = memory.pair.owner == 0 ? b.count : a.count;
  if (cache.vertex < 0 || cache.vertex >= vertices) {
    refuse(HS_ERROR_ARGUMENT, "cache->vertex is %d; the shape has %d vertices", cache.vertex, vertices);
  }
  memory.pair.vertex = cache.vertex;
  return memory;
}

void write_cache(const PairMemory& memory, int edges_of_a, hs_pair_cache& cache) {
  const PotentialPair& pair = memory.pair;
  cache = {memory.state, pair.owner == 0 ? pair.edge : pair.edge + edges_of_a, pair.vertex, 0};
}

/// An outline turned into another frame, in memory of its own: on the stack for most shapes. The normals are turned on demand.
class TurnedOutline {
 public:
  TurnedOutline(const Outline<2>& given, const Rotation<2>& rotation, Memory* memory)
      : given_(given), rotation_(rotation), stride_(Outline<2>::padded(given.count)), memory_(memory) {
    components_ = stride_ <= most_inline ? inline_ : static_cast<double*>(memory_->allocate(bytes(), alignof(double)));
    outline_ = {given.count, component(0), component(1), component(2), component(3), given.offset};
    turn(given.x, given.y, component(0), component(1));
  }
  ~TurnedOutline() {
    if (components_ != inline_) memory_->deallocate(components_, bytes(), alignof(double));
  }
  TurnedOutline(const TurnedOutline&) = delete;
  TurnedOutline& operator=(const TurnedOutline&) = delete;

  const Outline<2>& outline() const { return outline_; }
  void turn_normals() { turn(given_.nx, given_.ny, component(2), component(3)); }

 private:
  static constexpr int most_inline = 32;

  std::size_t bytes() const { return 4 * std::size_t(stride_) * sizeof(double); }
  double* component(int k) { return components_ + k * stride_; }

  void turn(const double* x, const double* y, double* out_x, double* out_y) const {
    const double c = rotation_.cosine, s = rotation_.sine;
    for (int i = 0; i < stride_; i += 2) {
      const Eigen::Map<const Eigen::Array2d> px(x + i), py(y + i);
      Eigen::Map<Eigen::Array2d>(out_x + i) = c * px - s * py;
      Eigen::Map<Eigen::Array2d>(out_y + i) = s * px + c * py;
    }
  }

  const Outline<2>& given_;
  Rotation<2> rotation_;
  int stride_;
  Memory* memory_;
  double* components_;
  double inline_[4 * most_inline];
  Outline<2> outline_;
};

/// Where block b is, seen from a: detection works in the frame of a, so that only b has to be turned and the distance from the
/// origin costs no digits.
struct Relative {
  Rotation<2> b_in_a;
  Vector<2> to_b;
};

/// The remembered violated pair, judged before anything is turned but its normal.
bool proves_separation(const Outline<2>& a, const Outline<2>& b, const Relative& at, PairMemory& memory,
                       Contact<2>& contact) {
  if (memory.state != PairMemory::separated) return false;
  PotentialPair& pair = memory.pair;
  const bool a_owns = pair.owner == 0;
  const Outline<2>& owner = a_owns ? a : b;
  const Outline<2>& other = a_owns ? b : a;
  const Vector<2> normal = owner.normal(pair.edge);
  const Vector<2> normal_of_other = (a_owns ? at.b_in_a.inverse() : at.b_in_a) * normal;
  const Vector<2> away = a_owns ? normal : Vector<2>(-normal_of_other);  // from a to b, in the frame of a
  pair.vertex = deepest_vertex(other, normal_of_other, pair.vertex);
  const double gap = (height_along(normal_of_other, other, pair.vertex) + away.dot(at.to_b)) - owner.offset[pair.edge];
  if (!(gap > 0)) return false;
  describe_separation({gap, pair}, away, contact);
  return true;
}

void detect(const hs_shape& shape_a, const Pose2& pose_a, const hs_shape& shape_b, const Pose2& pose_b,
            const DetectOptions& options, hs_pair_cache* cache, hs_contact& out) {
  const Outline<2>& a = shape_a.shape.outline();
  const Outline<2>& b = shape_b.shape.outline();
  const Rotation<2> to_a_frame = pose_a.rotation.inverse();
  const Relative at{to_a_frame * pose_b.rotation, to_a_frame * Vector<2>(pose_b.position - pose_a.position)};

  PairMemory memory;
  if (cache) memory = read_cache(*cache, a, b);
  Contact<2> contact;
  if (!proves_separation(a, b, at, memory, contact)) {
    TurnedOutline turned(b, at.b_in_a, &shape_a.context->memory);
    judge_pair(a, turned.outline(), at.to_b, options, [&] { turned.turn_normals(); }, memory, contact);
  }
  if (cache) write_cache(memory, a.count, *cache);
  write_contact(contact, pose_a.rotation, pose_a.position, out);
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_pair_options_init(hs_pair_options* options, size_t size) { return write_definition(options, size); }

hs_status hs_pair_detect(const hs_shape* shape_a, const hs_pose* pose_a, const hs_shape* shape_b,
                         const hs_pose* pose_b, const hs_pair_options* options, hs_pair_cache* cache,
                         hs_contact* contact) {
  hs_context* context = shape_a ? shape_a->context : shape_b ? shape_b->context : nullptr;
  return guarded(context, __func__, [&] {
    require_pointer(shape_a, "shape_a");
    require_pointer(shape_b, "shape_b");
    require_pointer(contact, "contact");
    detect(*shape_a, read_pose(pose_a, "pose_a"), *shape_b, read_pose(pose_b, "pose_b"), read_options(options), cache,
           *contact);
    return HS_OK;
  });
}

hs_status hs_pairs_detect(hs_context* context, const hs_shape* const* shapes, const hs_pose* poses, int64_t body_count,
                          const int32_t* pairs, int64_t pair_count, const hs_pair_options* options,
                          hs_pair_cache* caches, hs_contact* contacts, int64_t* touching) {
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
    const DetectOptions known = read_options(options);

    // All input is judged before anything is written.
    Array<Pose2> read(&context->memory);
    read.reserve(std::size_t(body_count));
    for (std::int64_t i = 0; i < body_count; ++i) {
      char name[48];
      std::snprintf(name, sizeof name, "poses[%lld]", static_cast<long long>(i));
      if (!shapes[i]) refuse(HS_ERROR_ARGUMENT, "shapes[%lld] is NULL", static_cast<long long>(i));
      read.push_back(read_pose(&poses[i], name));
    }
    for (std::int64_t i = 0; i < 2 * pair_count; ++i) {
      if (pairs[i] < 0 || pairs[i] >= body_count) {
        refuse(HS_ERROR_ARGUMENT, "pairs[%lld] is %d; there are %lld bodies", static_cast<long long>(i), pairs[i],
               static_cast<long long>(body_count));
      }
    }
    if (caches) {
      for (std::int64_t i = 0; i < pair_count; ++i) {
        read_cache(caches[i], shapes[pairs[2 * i]]->shape.outline(), shapes[pairs[2 * i + 1]]->shape.outline());
      }
    }

    std::int64_t count = 0;
    for (std::int64_t i = 0; i < pair_count; ++i) {
      const std::int32_t a = pairs[2 * i], b = pairs[2 * i + 1];
      detect(*shapes[a], read[std::size_t(a)], *shapes[b], read[std::size_t(b)], known, caches ? &caches[i] : nullptr,
             contacts[i]);
      count += contacts[i].type != HS_CONTACT_NONE;
    }
    if (touching) *touching = count;
    return HS_OK;
  });
}
