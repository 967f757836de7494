"use strict";

/** All blocks as one mesh. A frame is one upload of a texture with poses, nodes and colour values. */
class BlockMesh {
  constructor(recording) {
    this.recording = recording;
    const {blocks} = recording;
    const nodes = blocks.reduce((sum, block) => sum + (block.firstNode < 0 ? 0 : block.vertexCount), 0);
    const texels = 2 * blocks.length + nodes;
    const width = Math.min(2048, texels), height = Math.ceil(texels / width);
    this.states = new Float32Array(4 * width * height);
    this.firstNode = 2 * blocks.length;
    this.texture = new THREE.DataTexture(this.states, width, height, THREE.RGBAFormat, THREE.FloatType);
    const {dimension} = recording;
    this.material = new THREE.ShaderMaterial({
      vertexShader: blockVertexShader,
      fragmentShader: blockFragmentShader,
      side: dimension === 2 ? THREE.DoubleSide : THREE.FrontSide,
      uniforms: {
        states: {value: this.texture},
        statesWidth: {value: width},
        firstNode: {value: this.firstNode},
        colours: {value: null},
        range: {value: new THREE.Vector2(0, 1)},
        isFlat: {value: dimension === 2},
        opacity: {value: 1},
        edgeColour: {value: new THREE.Color("#10151c")},
        edgeOpacity: {value: 0.75},
        section: {value: new THREE.Vector4(0, 0, 1, 0)},
        hasSection: {value: false},
        isPicking: {value: false},
        selected: {value: -1},
        missingColour: {value: new THREE.Color("#8a8f98")},
      },
    });
    this.mesh = new THREE.Mesh(meshGeometry(blocks), this.material);
    this.mesh.frustumCulled = false;
    this.visibleFaces = dimension === 3 ? new VisibleFaces(recording, this.mesh.geometry) : null;
    this.uniforms = this.material.uniforms;
  }

  /** Shows a frame, coloured by these values. Blocks without a finite one are grey, and fixed blocks if so wanted. */
  show(frame, values, hasGreyFixed = false) {
    const {states, recording: {dimension, blocks}} = this;
    const present = frame.column("blocks", "present");
    const [x, y, z, angle, qx, qy, qz, qw] =
      ["x", "y", "z", "angle", "qx", "qy", "qz", "qw"].map((name) => frame.column("blocks", name));
    const hidden = -2e30, missing = 2e30;
    for (let b = 0, i = 0; b < blocks.length; ++b, i += 8) {
      const value = values[b];
      states[i] = x[b];
      states[i + 1] = y[b];
      states[i + 2] = dimension === 3 ? z[b] : 0;
      const isColoured = Number.isFinite(value) && !(hasGreyFixed && isFixed(blocks[b]));
      states[i + 3] = present[b] === 0 ? hidden : isColoured ? value : missing;
      if (dimension === 2) {
        states[i + 6] = Math.sin(angle[b] / 2);
        states[i + 7] = Math.cos(angle[b] / 2);
        continue;
      }
      const length = Math.hypot(qx[b], qy[b], qz[b], qw[b]) || 1;
      states[i + 4] = qx[b] / length;
      states[i + 5] = qy[b] / length;
      states[i + 6] = qz[b] / length;
      states[i + 7] = qw[b] / length;
    }
    const count = frame.count("nodes");
    ["x", "y", "z"].slice(0, dimension).forEach((name, axis) => {
      const values = frame.column("nodes", name);
      for (let n = 0; n < count; ++n) states[4 * (this.firstNode + n) + axis] = values[n];
    });
    this.texture.needsUpdate = true;
  }

  /** The pose of a block in the frame shown: its place, and its rotation as a quaternion. */
  pose(block) {
    const i = 8 * block, {states} = this;
    return {
      place: new THREE.Vector3(states[i], states[i + 1], states[i + 2]),
      rotation: new THREE.Quaternion(states[i + 4], states[i + 5], states[i + 6], states[i + 7]),
      isPresent: states[i + 3] > -1e30,
    };
  }

  /** The vertices of a block in the frame shown. */
  verticesOf({number, vertices, vertexCount, firstNode}) {
    const {place, rotation} = this.pose(number);
    return Array.from({length: vertexCount}, (_, v) => firstNode < 0
      ? new THREE.Vector3(...vertices.subarray(3 * v, 3 * v + 3)).applyQuaternion(rotation).add(place)
      : new THREE.Vector3(...this.states.subarray(4 * (this.firstNode + firstNode + v)).subarray(0, 3)));
  }

  /** Leaves out the faces that look away from the camera, unless a section shows the inside of blocks. */
  prepare(camera) {
    if (!this.visibleFaces) return;
    if (this.uniforms.hasSection.value) this.visibleFaces.showAll();
    else this.visibleFaces.show(camera, this.states);
  }

  setOpacity(opacity) {
    this.uniforms.opacity.value = opacity;
    this.material.transparent = opacity < 1;
    this.material.depthWrite = opacity === 1;
    this.mesh.visible = opacity > 0;
  }

  /** Removes what is ahead of a plane, or shows all if there is none. */
  setSection(plane) {
    this.uniforms.hasSection.value = plane !== null;
    if (plane) this.uniforms.section.value.copy(plane);
    this.material.side = plane || this.recording.dimension === 2 ? THREE.DoubleSide : THREE.FrontSide;
  }
}

/** The faces of all blocks as triangles: a fan for each face. */
function meshGeometry(blocks) {
  let corners = 0;
  for (const {faces} of blocks) for (const face of faces) corners += 3 * (face.length - 2);
  const positions = new Float32Array(3 * corners), edges = new Uint8Array(3 * corners);
  const owners = new Float32Array(2 * corners);
  let corner = 0;
  for (const {number, firstNode, vertices, faces} of blocks) {
    for (const face of faces) {
      for (let i = 1; i + 1 < face.length; ++i) {
        // A side of the triangle inside the face is no edge: everything is far from it.
        const isEdge = [true, i + 2 === face.length, i === 1];
        [face[0], face[i], face[i + 1]].forEach((vertex, k) => {
          positions.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner);
          for (let side = 0; side < 3; ++side) edges[3 * corner + side] = side === k || !isEdge[side] ? 255 : 0;
          owners[2 * corner] = number;
          owners[2 * corner + 1] = firstNode < 0 ? -1 : firstNode + vertex;
          ++corner;
        });
      }
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("edges", new THREE.BufferAttribute(edges, 3, true));
  geometry.setAttribute("owner", new THREE.BufferAttribute(owners, 2));
  return geometry;
}
