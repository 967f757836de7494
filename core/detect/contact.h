#pragma once

#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

/// Contact types (Wang et al. 2021, section 2.5). The values are those of the C API.
enum class ContactType : std::int32_t { none = 0, vertex_vertex = 1, vertex_edge = 2, edge_edge = 3 };

/// Settings of detection that trade nothing but what a contact is called.
struct DetectOptions {
  double parallel_angle = 0.01;  // rad: edges closer to parallel than this are edge-edge
  double vertex_zone =
      1e-6;  // share of the shorter edge's length that an end of an edge counts as its vertex
};

/// A facet of the Minkowski difference of two blocks is a potential contact pair (Wang et al. 2021, eq. 9).
/// In the plane it is known by its edge alone: the vertex is the other block's deepest one behind it.
struct PotentialPair {
  std::int32_t owner = 0;   // whose edge: 0 block a, 1 block b
  std::int32_t edge = 0;    // of the owner
  std::int32_t vertex = 0;  // of the other block
  friend bool operator==(const PotentialPair&, const PotentialPair&) = default;
};

/// What a pair of blocks remembers from one step to the next.
struct PairMemory {
  enum State : std::int32_t { unknown = 0, separated = 1, touching = 2 };
  State state = unknown;
  /// Separated: the last violated pair, tried first. Touching: the pair through which the blocks met.
  PotentialPair pair;
};

/// A contact between blocks a and b, relative to the centroid of a, or the proof that there is none.
template <int D>
struct Contact;

/// Without initial values: detection writes one for each pair, and what a separated pair leaves unset costs
/// nothing.
template <>
struct Contact<2> {
  ContactType type;
  PotentialPair pair;        // the contact plane; of a separated pair, the violated pair
  std::int32_t point_count;  // 0 when separated, and then only normal and gap follow
  std::int32_t reserved;  // fills the gap before the next member, so that saved contacts hold no stray bytes
  double gap;           // of the pair, or of the deeper end of an edge-edge region; > 0 proves the separation
  Vector<2> normal;     // unit, from a to b
  Vector<2> points[2];  // of the region, on the contact plane
  double gaps[2];       // at the points
  double shares[2];     // of the contact's stiffness at the points
  double length;        // of the contact region: 0 unless edge-edge
  double share_rate;    // of the first point's share as b turns counter-clockwise against a
};

}  // namespace halfspace
