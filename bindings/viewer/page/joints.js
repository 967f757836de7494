"use strict";

/** The joints of a run: where sides of two blocks, edges in 2D and faces in 3D, coincide at the start. Both blocks
    carry their side of a joint along, so that the distance between its sides is how far the joint has opened. */
class Joints {
  /** Finds the joints of the blocks as the mesh shows them now. */
  constructor(recording, blockMesh, thicknesses) {
    Object.assign(this, {recording, blockMesh, thicknesses, all: []});
    const outlines = recording.blocks.filter(({number, faces}) => faces.length > 0 && blockMesh.isPresent(number))
      .map((block) => this.outlineOf(block));
    for (const [a, b] of overlappingPairs(outlines)) {
      if (isFixed(a.block) && isFixed(b.block)) continue;
      for (const side of a.sides) for (const other of b.sides) this.addJoint(side, other);
    }
  }

  /** The sides of a block, and its bounding box with a margin. */
  outlineOf(block) {
    const vertices = this.blockMesh.verticesOf(block), box = new THREE.Box3().setFromPoints(vertices);
    box.expandByScalar(closeness * this.thicknesses[block.number]);
    const loops = this.recording.dimension === 3 ? block.faces
      : Array.from(block.faces[0], (vertex, i) => [vertex, block.faces[0][(i + 1) % block.faces[0].length]]);
    return {block, low: box.min.toArray(), high: box.max.toArray(),
      sides: loops.map((loop) => sideOf(block, loop, vertices))};
  }

  addJoint(a, b) {
    if (a.normal.dot(b.normal) > -parallelCosine) return;
    const width = Math.min(...[a, b].map(({block}) => this.thicknesses[block.number]));
    if (Math.abs(a.normal.dot(b.points[0].clone().sub(a.points[0]))) > closeness * width) return;
    const corners = overlapOf(a, b);
    if (corners.length < 2) return;
    const size = corners.length > 2 ? Math.sqrt(normalOfLoop(corners).length() / 2) : corners[0].distanceTo(corners[1]);
    if (size < closeness * width) return;
    const sides = [a, b].map(({block, base, origins}) =>
      ({block, base, weights: corners.map((corner) => weightsOf(corner, origins))}));
    const joint = {sides, width, size, resolution: 2 * (this.errorOf(a) + this.errorOf(b))};
    joint.start = this.stateOf(joint).distance;
    this.all.push(joint);
  }

  /** The largest error of a side's place in a frame, from the steps of its recorded pose. */
  errorOf({block, points}) {
    if (isFixed(block)) return 0;  // it is the same in all frames
    const {recording} = this, {dimension} = recording, rounding = 0.5 * Math.sqrt(dimension);
    const stepOf = (table, name) => recording.description(table).find((column) => column.name === name).step;
    if (block.firstNode >= 0) return rounding * stepOf("nodes", "x");
    const {place} = this.blockMesh.pose(block.number);
    const reach = Math.max(...points.map((point) => point.distanceTo(place)));
    const turn = 0.5 * (dimension === 2 ? stepOf("blocks", "angle") : Math.sqrt(3) * stepOf("blocks", "turn_x"));
    return rounding * stepOf("blocks", "x") + turn * reach;
  }

  /** The corners of both sides of a joint in the frame shown, and the mean distance between them along its normal. */
  stateOf({sides}) {
    const bases = sides.map(({block, base}) => base.map((vertex) => this.blockMesh.vertexAt(block, vertex)));
    const corners = sides.map(({weights}, end) => weights.map((factors) => weighted(bases[end], factors)));
    const normal = normalOfSide(bases[0]), [a, b] = corners;
    const sum = a.reduce((sum, corner, i) => sum + normal.dot(b[i]) - normal.dot(corner), 0);
    return {corners, distance: sum / a.length};
  }

  /** Adds the open joints of the frame shown, each as wide as it has opened. Sides that have parted are no joint. */
  addTo(bars, colour) {
    for (const joint of this.all) {
      if (!joint.sides.every(({block}) => this.blockMesh.isPresent(block.number))) continue;
      const {corners: [a, b], distance} = this.stateOf(joint), opening = distance - joint.start;
      const hasParted = opening > partedRatio * joint.width || a[0].distanceTo(b[0]) > joint.size;
      if (opening < joint.resolution || hasParted) continue;
      const loop = a.map((corner, i) => corner.lerp(b[i], 0.5).toArray());
      const barCount = loop.length === 2 ? 1 : loop.length;
      for (let i = 0; i < barCount; ++i) bars.add(loop[i], loop[(i + 1) % loop.length], 1.5, colour, opening);
    }
  }
}

const closeness = 0.02;       // the distance and the size of a joint, over the thickness of the thinner block
const parallelCosine = 0.999; // of the angle between its sides
const partedRatio = 0.1;      // the opening over the thickness of the thinner block

/** Pairs of boxes that overlap: a sweep along x. */
function* overlappingPairs(boxes) {
  const sorted = [...boxes].sort((a, b) => a.low[0] - b.low[0]);
  for (let i = 0; i < sorted.length; ++i) {
    const {low, high} = sorted[i];
    for (let j = i + 1; j < sorted.length && sorted[j].low[0] <= high[0]; ++j) {
      const other = sorted[j];
      if (other.low[1] <= high[1] && other.high[1] >= low[1] && other.low[2] <= high[2] && other.high[2] >= low[2])
        yield [sorted[i], other];
    }
  }
}

/** A side of a block: its corners, its outward normal, and the vertices by which its points are placed. */
function sideOf(block, loop, vertices) {
  const points = Array.from(loop, (vertex) => vertices[vertex]), base = widestCorners(points);
  return {block, points, normal: normalOfSide(points),
    base: base.map((corner) => loop[corner]), origins: base.map((corner) => points[corner])};
}

/** Both ends of an edge; of a face three corners that are far from one line. */
function widestCorners(points) {
  if (points.length === 2) return [0, 1];
  const farthest = (measure) => points.reduce((best, _, i) => (measure(i) > measure(best) ? i : best), 0);
  const second = farthest((i) => points[i].distanceTo(points[0]));
  const third = farthest((i) => normalOfLoop([points[0], points[second], points[i]]).length());
  return [0, second, third].sort((a, b) => a - b);
}

/** The normal of an edge or of a triangle, to the right of the edge, of length 1. */
function normalOfSide(points) {
  if (points.length > 2) return normalOfLoop(points).normalize();
  const along = points[1].clone().sub(points[0]).normalize();
  return new THREE.Vector3(along.y, -along.x, 0);
}

/** A point as a sum of two or three others with these factors: its projection onto their line or plane. */
function weightsOf(point, [origin, ...others]) {
  const [along, across] = others.map((other) => other.clone().sub(origin)), offset = point.clone().sub(origin);
  if (!across) {
    const s = offset.dot(along) / along.lengthSq();
    return [1 - s, s];
  }
  const aa = along.lengthSq(), ab = along.dot(across), bb = across.lengthSq();
  const a = offset.dot(along), b = offset.dot(across), determinant = aa * bb - ab * ab;
  const s = (a * bb - b * ab) / determinant, t = (b * aa - a * ab) / determinant;
  return [1 - s - t, s, t];
}

function weighted(points, factors) {
  const sum = new THREE.Vector3();
  points.forEach((point, i) => sum.addScaledVector(point, factors[i]));
  return sum;
}

/** The part of a side that faces another one: the other's corners, cut off at each end or edge of the first. */
function overlapOf({points, normal}, other) {
  if (points.length === 2) {
    const [begin, end] = points, along = end.clone().sub(begin), size = along.lengthSq();
    const [low, high] = other.points.map((point) => point.clone().sub(begin).dot(along) / size).sort((a, b) => a - b);
    const from = Math.max(low, 0), to = Math.min(high, 1);
    return from < to ? [from, to].map((place) => begin.clone().addScaledVector(along, place)) : [];
  }
  return points.reduce((corners, point, i) => {
    const along = points[(i + 1) % points.length].clone().sub(point);
    return cutLoop(corners, point, normal.clone().cross(along));
  }, other.points);
}

/** The part of a convex loop on the side of a plane through a point to which the normal points. */
function cutLoop(corners, point, normal) {
  const kept = [];
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % corners.length];
    const here = normal.dot(corner.clone().sub(point)), there = normal.dot(next.clone().sub(point));
    if (here >= 0) kept.push(corner);
    if (here * there < 0) kept.push(corner.clone().lerp(next, here / (here - there)));
  });
  return kept;
}
