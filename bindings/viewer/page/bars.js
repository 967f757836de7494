"use strict";

/** Many straight bars, each with ends, a width in pixels and a colour, drawn at once. */
class Bars {
  constructor(isInFront) {
    this.material = new THREE.ShaderMaterial({
      vertexShader: barVertexShader,
      fragmentShader: barFragmentShader,
      transparent: true,
      depthTest: !isInFront,
      depthWrite: false,
      side: THREE.DoubleSide,
      uniforms: {
        viewport: {value: new THREE.Vector2(1, 1)},
        lift: {value: 2e-4},
        section: {value: new THREE.Vector4(0, 0, 1, 0)},
        hasSection: {value: false},
      },
    });
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.capacity = 0;
    this.clear();
  }

  clear() {
    this.count = 0;
  }

  /** Adds a bar between two points, given by their coordinates. Its width is in pixels, besides a part in metres. */
  add(begin, end, width, colour, metres = 0) {
    if (this.count === this.capacity) this.reserve(Math.max(256, 2 * this.capacity));
    const i = this.count++;
    this.begins.set(begin, 3 * i);
    this.ends.set(end, 3 * i);
    this.widths.set([width, metres], 2 * i);
    this.tints.set(colour, 4 * i);
  }

  reserve(capacity) {
    const grown = (values, size) => {
      const larger = new Float32Array(size * capacity);
      if (values) larger.set(values);
      return larger;
    };
    this.capacity = capacity;
    this.begins = grown(this.begins, 3);
    this.ends = grown(this.ends, 3);
    this.widths = grown(this.widths, 2);
    this.tints = grown(this.tints, 4);
    this.mesh.geometry.dispose();
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]);
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    const values = {begin: [this.begins, 3], end: [this.ends, 3], widths: [this.widths, 2], tint: [this.tints, 4]};
    this.attributes = Object.entries(values).map(([name, [array, size]]) => {
      const attribute = new THREE.InstancedBufferAttribute(array, size);
      geometry.setAttribute(name, attribute);
      return attribute;
    });
    this.mesh.geometry = geometry;
  }

  /** Draws the bars that have been added since clear(). */
  commit() {
    this.mesh.visible = this.count > 0;
    if (this.count === 0) return;
    this.mesh.geometry.maxInstancedCount = this.count;
    for (const attribute of this.attributes) attribute.needsUpdate = true;
  }
}
