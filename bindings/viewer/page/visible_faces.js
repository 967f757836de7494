"use strict";

/** The faces of convex blocks that look towards the camera. The others are not drawn: half of the work, by software. */
class VisibleFaces {
  constructor(recording, geometry) {
    this.recording = recording;
    this.geometry = geometry;
    const faces = recording.blocks.flatMap((block) => block.faces.map((face) => ({block, face})));
    this.normals = new Float32Array(3 * faces.length);
    this.offsets = new Float32Array(faces.length);
    this.sizes = Uint32Array.from(faces, ({face}) => 3 * (face.length - 2));  // corners
    faces.forEach(({block, face}, index) => {
      const at = (i) => new THREE.Vector3(...block.vertices.subarray(3 * face[i], 3 * face[i] + 3));
      const normal = new THREE.Vector3(), origin = at(0);
      for (let i = 1; i + 1 < face.length; ++i) normal.add(at(i).sub(origin).cross(at(i + 1).sub(origin)));
      normal.toArray(this.normals, 3 * index);
      this.offsets[index] = normal.dot(origin);
    });
    this.index = new THREE.BufferAttribute(new Uint32Array(geometry.attributes.position.count), 1);
    this.index.usage = THREE.DynamicDrawUsage;
    geometry.setIndex(this.index);
    this.showAll();
  }

  showAll() {
    const {array} = this.index;
    for (let corner = 0; corner < array.length; ++corner) array[corner] = corner;
    this.use(array.length);
  }

  /** Takes the faces in front of which the camera is, of blocks with these states. */
  show(camera, states) {
    const {normals, offsets, sizes, index: {array}} = this, {x: cx, y: cy, z: cz} = camera.position;
    let face = 0, corner = 0, count = 0;
    for (const {number, firstNode, faces} of this.recording.blocks) {
      const i = 8 * number, isHidden = states[i + 3] < -1e30;
      // The camera as the block sees it: rotated back by the conjugate quaternion.
      const x = cx - states[i], y = cy - states[i + 1], z = cz - states[i + 2];
      const qx = -states[i + 4], qy = -states[i + 5], qz = -states[i + 6], qw = states[i + 7];
      const ux = 2 * (qy * z - qz * y), uy = 2 * (qz * x - qx * z), uz = 2 * (qx * y - qy * x);
      const lx = x + qw * ux + qy * uz - qz * uy, ly = y + qw * uy + qz * ux - qx * uz;
      const lz = z + qw * uz + qx * uy - qy * ux;
      for (let f = 0; f < faces.length; ++f, ++face) {
        const end = corner + sizes[face], n = 3 * face;
        const isAhead = firstNode >= 0 || normals[n] * lx + normals[n + 1] * ly + normals[n + 2] * lz > offsets[face];
        if (isAhead && !isHidden) while (corner < end) array[count++] = corner++;
        corner = end;
      }
    }
    this.use(count);
  }

  use(count) {
    this.index.updateRange = {offset: 0, count};
    this.index.needsUpdate = true;
    this.geometry.setDrawRange(0, count);
  }
}
