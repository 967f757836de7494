#pragma once

namespace halfspace {

// Tolerances of questions that are asked in several places, by question. Each is far above rounding and far
// below what a model can mean. Limits of one algorithm stand beside it.

/// Parallel: directions at a smaller angle, rad, and unit vectors that differ by less. Above it their cross
/// product is a direction; below it rounding is. Not the parallel angle of a world, which is the user's: that
/// makes a region of two faces that are only nearly parallel.
constexpr double strictly_parallel = 1e-6;

/// Touching: blocks cut along a joint, or read from a file, touch up to rounding. A gap or an overlap below
/// this fraction of a block's size, its radius or that of a face, counts as a common face, and a block slides
/// over a joint whose edges are off by as little.
constexpr double touch_reach = 1e-6;

/// At an end: a place on an edge that is nearer to its end than this fraction of its length is that vertex.
constexpr double end_reach = 1e-6;

}  // namespace halfspace
