#include "block/topologies.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "block/outlines.h"
#include "catch.h"
#include "contacts_3d.h"
#include "geometry/polyhedron/topology.h"
#include "world/snapshot.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

/// Of a prism over a polygon of so many corners: as many different topologies as one likes.
Shape<3> prism_of(int corners) { return block_of(prism(regular_polygon(corners, 1), 1)); }

bool is_same(const Topology& p, const Topology& q) {
  const std::int64_t length = topology_length(p.vertex_count, p.edge_count, p.face_count);
  return p.vertex_count == q.vertex_count && p.edge_count == q.edge_count && p.face_count == q.face_count &&
         std::equal(p.first_of_face, p.first_of_face + length, q.first_of_face);
}

std::vector<std::byte> bytes_of(const Topologies& topologies) {
  snapshot::Writer counter(nullptr);
  counter(topologies);
  std::vector<std::byte> bytes(counter.size());
  snapshot::Writer writer(bytes.data());
  writer(topologies);
  return bytes;
}

/// What is read from bytes, and whether it may be.
struct Read {
  Topologies topologies{memory};
  bool is_good = false;

  explicit Read(const std::vector<std::byte>& bytes) {
    snapshot::Reader reader(bytes);
    reader(topologies);
    is_good = !reader.failed() && reader.at_end() && topologies.is_consistent();
  }
};

template <class Number>
std::vector<std::byte> with(std::vector<std::byte> bytes, std::size_t at, Number value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

}  // namespace

TEST_CASE("blocks of one shape share its topology, also when they differ in size") {
  Topologies topologies(memory);
  const Shape<3> cube = shape_of(completed(box({1, 1, 1}))), brick = shape_of(completed(box({3, 2, 1})));
  const std::int32_t first = topologies.add(cube.topology());
  const std::size_t size = bytes_of(topologies).size();
  CHECK(topologies.add(cube.topology()) == first);
  CHECK(topologies.add(brick.topology()) == first);
  CHECK(bytes_of(topologies).size() == size);
  CHECK(topologies.add(prism_of(3).topology()) != first);
  CHECK(bytes_of(topologies).size() > size);
}

TEST_CASE("different topologies stay apart, and copies stay right as the arrays grow and shrink") {
  Topologies topologies(memory);
  std::vector<Shape<3>*> shapes;
  for (int corners = 3; corners < 40; ++corners)
    shapes.push_back(new Shape<3>(hull_of(prism(regular_polygon(corners, 1), 1)), memory));
  Random random(31);
  std::vector<std::int32_t> where(shapes.size(), -1);  // -1: not in
  std::vector<int> users(shapes.size(), 0);
  for (int i = 0; i < 5000; ++i) {
    const std::size_t k = std::size_t(random.integer(0, int(shapes.size()) - 1));
    // Now rather more, now rather fewer.
    const bool adds = users[k] == 0 || random.uniform(0, 1) < (i / 500 % 2 ? 0.3 : 0.6);
    if (adds) {
      const std::int32_t which = topologies.add(shapes[k]->topology());
      CHECK((users[k] == 0 || which == where[k]));
      where[k] = which;
      ++users[k];
    } else {
      topologies.release(where[k]);
      --users[k];
    }
    if (i % 10 != 0) continue;
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      if (users[j] == 0) continue;
      CHECK(topologies.has(where[j]));
      CHECK(is_same(topologies[where[j]], shapes[j]->topology()));
      for (std::size_t other = 0; other < j; ++other) CHECK((users[other] == 0 || where[other] != where[j]));
    }
    CHECK(topologies.is_consistent());
  }
  for (const Shape<3>* shape : shapes) delete shape;
}

TEST_CASE("a topology that no block has is gone, and its place is used again") {
  Topologies topologies(memory);
  const Shape<3> three = prism_of(3), four = prism_of(4), five = prism_of(5);
  const std::int32_t a = topologies.add(three.topology());
  const std::int32_t b = topologies.add(four.topology());
  topologies.add(three.topology());
  const std::size_t size = bytes_of(topologies).size();
  topologies.release(a);
  CHECK(topologies.has(a));
  CHECK(bytes_of(topologies).size() == size);
  topologies.release(a);
  CHECK_FALSE(topologies.has(a));
  CHECK(is_same(topologies[b], four.topology()));
  CHECK(bytes_of(topologies).size() < size);
  CHECK(topologies.add(five.topology()) == a);
  CHECK(is_same(topologies[a], five.topology()));
  CHECK(is_same(topologies[b], four.topology()));
  CHECK_FALSE(topologies.has(-1));
  CHECK_FALSE(topologies.has(2));
}

TEST_CASE("topologies come back from their bytes") {
  Topologies topologies(memory);
  const Shape<3> three = prism_of(3), four = prism_of(4), five = prism_of(5);
  topologies.add(three.topology());
  const std::int32_t gone = topologies.add(four.topology());
  topologies.add(five.topology());
  topologies.release(gone);
  Read read(bytes_of(topologies));
  REQUIRE(read.is_good);
  CHECK(is_same(read.topologies[0], three.topology()));
  CHECK(is_same(read.topologies[2], five.topology()));
  CHECK_FALSE(read.topologies.has(1));
  CHECK(bytes_of(read.topologies) == bytes_of(topologies));
  // And what is known is found.
  CHECK(read.topologies.add(five.topology()) == 2);
  CHECK(read.topologies.add(four.topology()) == 1);
}

TEST_CASE("an index that leads out of its array is refused, in whichever array") {
  const Shape<3> shape = prism_of(5);
  const Topology& t = shape.topology();
  Topologies topologies(memory);
  topologies.add(t);
  const std::vector<std::byte> good = bytes_of(topologies);
  REQUIRE(Read(good).is_good);
  const std::int32_t vertices = t.vertex_count, edges = t.edge_count, faces = t.face_count;
  const struct {
    const char* name;
    const std::int32_t* array;
    std::int32_t length;
    std::int32_t count;  // of what it names
  } arrays[] = {
      {"first_of_face", t.first_of_face, faces + 1, 2 * edges + 1},
      {"face_vertex", t.face_vertex, 2 * edges, vertices},
      {"face_edge", t.face_edge, 2 * edges, edges},
      {"edge_start", t.edge_start, edges, vertices},
      {"edge_end", t.edge_end, edges, vertices},
      {"edge_left", t.edge_left, edges, faces},
      {"edge_right", t.edge_right, edges, faces},
      {"first_of_vertex", t.first_of_vertex, vertices + 1, 2 * edges + 1},
      {"vertex_neighbour", t.vertex_neighbour, 2 * edges, vertices},
      {"vertex_edge", t.vertex_edge, 2 * edges, edges},
      {"vertex_face", t.vertex_face, 2 * edges, faces},
  };
  for (const auto& [name, array, length, count] : arrays) {
    for (std::int32_t i = 0; i < length; ++i) {
      INFO(name << "[" << i << "]");
      // The bytes begin with how many indices there are.
      const std::size_t at =
          sizeof(std::uint64_t) + sizeof(std::int32_t) * std::size_t(array + i - t.first_of_face);
      for (const std::int32_t wrong : {-1, count, 0x7fffffff, INT32_MIN})
        CHECK_FALSE(Read(with(good, at, wrong)).is_good);
    }
  }
}

TEST_CASE("a face of two corners, or a vertex of two faces, is refused") {
  const Shape<3> shape = prism_of(5);
  const Topology& t = shape.topology();
  Topologies topologies(memory);
  topologies.add(t);
  const std::vector<std::byte> good = bytes_of(topologies);
  for (const std::int32_t* first : {t.first_of_face, t.first_of_vertex}) {
    const std::size_t at =
        sizeof(std::uint64_t) + sizeof(std::int32_t) * std::size_t(first - t.first_of_face);
    CHECK_FALSE(Read(with(good, at + sizeof(std::int32_t), std::int32_t(2))).is_good);
    CHECK_FALSE(Read(with(good, at + sizeof(std::int32_t), std::int32_t(0))).is_good);
  }
}

TEST_CASE("topologies that overlap are refused: one that goes would take a part of the other along") {
  Topologies topologies(memory);
  const Shape<3> three = prism_of(3), five = prism_of(5);
  topologies.add(three.topology());
  topologies.add(five.topology());
  const std::vector<std::byte> good = bytes_of(topologies);
  REQUIRE(Read(good).is_good);
  std::int64_t first = 0;
  const std::size_t second = good.size() - 32;
  std::memcpy(&first, good.data() + second, sizeof first);
  CHECK_FALSE(Read(with(good, second, std::int64_t(0))).is_good);
  CHECK_FALSE(Read(with(good, second, first - 1)).is_good);
}

TEST_CASE("a topology that lies outside the arrays, or has no features, is refused") {
  const Shape<3> shape = prism_of(5);
  const Topology& t = shape.topology();
  Topologies topologies(memory);
  topologies.add(t);
  const std::vector<std::byte> good = bytes_of(topologies);
  const std::size_t kept =
      good.size() - 32;  // first, then the counts of vertices, edges, faces and users, then the hash
  for (const std::int64_t wrong : {std::int64_t(-1), std::int64_t(1), INT64_MAX, INT64_MIN})
    CHECK_FALSE(Read(with(good, kept, wrong)).is_good);
  for (const std::size_t count : {8, 12, 16}) {
    for (const std::int32_t wrong : {-1, 0, 0x7fffffff}) {
      INFO("count at byte " << count << " is " << wrong);
      CHECK_FALSE(Read(with(good, kept + count, wrong)).is_good);
    }
  }
  CHECK_FALSE(Read(with(good, kept + 20, std::int32_t(-1))).is_good);
}

TEST_CASE("outlines share topologies, turn about the centroid, and close the gaps that others leave") {
  Random random(32);
  Outlines<3> outlines(memory);
  std::vector<Cloud> clouds;
  std::vector<Rotation<3>> rotations;
  constexpr int count = 20;
  outlines.resize(count);
  const auto add = [&](int slot, const Cloud& cloud) {
    outlines.assign(slot, outlines.take_in(block_of(cloud)));
    outlines.turn(slot, Rotation<3>());
  };
  for (int i = 0; i < count; ++i) {
    clouds.push_back(random_cloud(random, random.integer(4, 30), 1, 1));
    add(i, clouds.back());
  }
  std::vector<bool> lives(count, true);
  const auto living = [&] {
    std::vector<std::int32_t> slots;
    for (int i = 0; i < count; ++i)
      if (lives[std::size_t(i)]) slots.push_back(i);
    return slots;
  };
  for (int i = 0; i < 200; ++i) {
    const int slot = random.integer(0, count - 1);
    const Rotation<3> turn = Rotation<3>().turned_by(random_vector(random, -3, 3));
    if (!lives[std::size_t(slot)]) {
      clouds[std::size_t(slot)] = random_cloud(random, random.integer(4, 30), 1, 1);
      add(slot, clouds[std::size_t(slot)]);
      lives[std::size_t(slot)] = true;
    } else if (i % 3 == 0) {
      outlines.drop(slot);
      lives[std::size_t(slot)] = false;
      continue;
    }
    outlines.turn(slot, turn);
    const Shape<3> shape = block_of(clouds[std::size_t(slot)]);
    const Outline<3> own = shape.outline(), outline = outlines[slot];
    REQUIRE(is_same(*outline.topology, shape.topology()));
    const double rounding = 8 * 0x1p-52 * shape.bounding_radius();
    for (int v = 0; v < own.vertex_count(); ++v)
      CHECK((outline.vertex(v) - turn * own.vertex(v)).norm() < rounding);
    for (int f = 0; f < own.face_count(); ++f) {
      CHECK((outline.normal(f) - turn * own.normal(f)).norm() < 8 * 0x1p-52);
      CHECK(outline.offset[f] == own.offset[f]);
    }
    CHECK(outlines.is_consistent(living()));
  }
}
