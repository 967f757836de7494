"use strict";

/** The faces of convex blocks that look towards the camera, as triangles: a fan for each face. The others are not
    drawn: half of the work, by software. */
class VisibleFaces {
  constructor(recording, geometry) {
    this.recording = recording;
    this.geometry = geometry;
    const faces = recording.blocks.flatMap((block) => block.faces.map((face) => ({block, face})));
    this.normals = new Float32Array(3 * faces.length);
    this.offsets = new Float32Array(faces.length);
    this.sizes = Uint32Array.from(faces, ({face}) => face.length);
    faces.forEach(({block, face}, index) => {
      const normal = normalOf(face, block.vertices);
      normal.toArray(this.normals, 3 * index);
      this.offsets[index] = normal.dot(vectorAt(block.vertices, 3 * face[0]));
    });
    const triangles = this.sizes.reduce((sum, size) => sum + Math.max(size - 2, 0), 0);
    this.index = new THREE.BufferAttribute(new Uint32Array(3 * triangles), 1);
    this.index.usage = THREE.DynamicDrawUsage;
    geometry.setIndex(this.index);
  }

  showAll() {
    if (this.showsAll) return;
    this.begin();
    let corner = 0;
    for (const size of this.sizes) {
      this.add(corner, size);
      corner += size;
    }
    this.use();
    this.showsAll = true;
  }

  /** Takes the faces in front of which the camera is, of blocks with these states. */
  show(camera, states) {
    const {normals, offsets, sizes} = this, {x: cx, y: cy, z: cz} = camera.position;
    this.begin();
    let face = 0, corner = 0;
    for (const {number, firstNode, faces} of this.recording.blocks) {
      const i = 8 * number, isHidden = states[i + 3] < -1e30;
      // The camera as the block sees it: rotated back by the conjugate quaternion.
      const x = cx - states[i], y = cy - states[i + 1], z = cz - states[i + 2];
      const qx = -states[i + 4], qy = -states[i + 5], qz = -states[i + 6], qw = states[i + 7];
      const ux = 2 * (qy * z - qz * y), uy = 2 * (qz * x - qx * z), uz = 2 * (qx * y - qy * x);
      const lx = x + qw * ux + qy * uz - qz * uy, ly = y + qw * uy + qz * ux - qx * uz;
      const lz = z + qw * uz + qx * uy - qy * ux;
      for (let f = 0; f < faces.length; ++f, ++face) {
        const n = 3 * face;
        const isAhead = firstNode >= 0 || normals[n] * lx + normals[n + 1] * ly + normals[n + 2] * lz > offsets[face];
        if (isAhead && !isHidden) this.add(corner, sizes[face]);
        corner += sizes[face];
      }
    }
    this.use();
  }

  begin() {
    this.count = 0;
    this.showsAll = false;
  }

  /** Adds the triangles of a face, given by its first corner. */
  add(first, size) {
    const {array} = this.index;
    for (let i = 1; i + 1 < size; ++i) {
      array[this.count++] = first;
      array[this.count++] = first + i;
      array[this.count++] = first + i + 1;
    }
  }

  use() {
    this.index.updateRange = {offset: 0, count: this.count};
    this.index.needsUpdate = true;
    this.geometry.setDrawRange(0, this.count);
  }
}

const vectorAt = (values, place) => new THREE.Vector3(values[place], values[place + 1], values[place + 2]);

/** The outward normal of a face, as long as twice its area. */
const normalOf = (face, vertices) => normalOfLoop(Array.from(face, (index) => vectorAt(vertices, 3 * index)));

function normalOfLoop([origin, ...others]) {
  const normal = new THREE.Vector3(), along = others.map((point) => point.clone().sub(origin));
  for (let i = 1; i < along.length; ++i) normal.add(new THREE.Vector3().crossVectors(along[i - 1], along[i]));
  return normal;
}
