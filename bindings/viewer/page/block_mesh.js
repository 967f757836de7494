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
    for (const {number} of blocks) this.states[8 * number + 7] = 1;  // the rotation of still blocks
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
        isPicking: {value: false},
        selected: {value: -1},
        missingColour: {value: new THREE.Color("#8a8f98")},
      },
    });
    this.mesh = new THREE.Mesh(meshGeometry(blocks), this.material);
    this.mesh.frustumCulled = false;
    this.visibleFaces = new VisibleFaces(recording, this.mesh.geometry);
    this.uniforms = this.material.uniforms;
  }

  /** Shows a frame, coloured by these values. Blocks without a finite one are grey, and fixed blocks if so wanted. */
  show(frame, values, hasGreyFixed = false) {
    const {states, recording: {dimension, blocks}} = this;
    const present = frame.column("blocks", "present");
    const [x, y, z, angle, turnX, turnY, turnZ] = poseColumns.map((name) => frame.column("blocks", name));
    const hidden = -2e30, missing = 2e30;
    for (let b = 0, i = 0; b < blocks.length; ++b, i += 8) {
      const value = values[b], isColoured = Number.isFinite(value) && !(hasGreyFixed && isFixed(blocks[b]));
      const isShown = blocks[b].isStill ? frame.number < blocks[b].frameCount : present[b] === 1;
      states[i + 3] = !isShown ? hidden : isColoured ? value : missing;
      if (blocks[b].isStill) continue;
      states[i] = x[b];
      states[i + 1] = y[b];
      states[i + 2] = dimension === 3 ? z[b] : 0;
      if (dimension === 2) {
        states[i + 6] = Math.sin(angle[b] / 2);
        states[i + 7] = Math.cos(angle[b] / 2);
        continue;
      }
      const turn = Math.sqrt(turnX[b] ** 2 + turnY[b] ** 2 + turnZ[b] ** 2);
      const factor = turn > 0 ? Math.sin(turn / 2) / turn : 0;
      states[i + 4] = factor * turnX[b];
      states[i + 5] = factor * turnY[b];
      states[i + 6] = factor * turnZ[b];
      states[i + 7] = Math.cos(turn / 2);
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
      place: vectorAt(states, i),
      rotation: new THREE.Quaternion(states[i + 4], states[i + 5], states[i + 6], states[i + 7]),
    };
  }

  isPresent(block) {
    return this.states[8 * block + 3] > -1e30;
  }

  /** A vertex of a block in the frame shown. */
  vertexAt({number, vertices, firstNode}, vertex) {
    if (firstNode >= 0) return vectorAt(this.states, 4 * (this.firstNode + firstNode + vertex));
    const {place, rotation} = this.pose(number);
    return vectorAt(vertices, 3 * vertex).applyQuaternion(rotation).add(place);
  }

  verticesOf(block) {
    return Array.from({length: block.vertexCount}, (_, vertex) => this.vertexAt(block, vertex));
  }

  /** Leaves out the faces that look away from the camera, unless a section shows the inside of blocks. */
  prepare(camera) {
    if (this.recording.dimension === 2 || this.hasSection) this.visibleFaces.showAll();
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
    this.hasSection = plane !== null;
    if (plane) this.uniforms.section.value.copy(plane);
    Object.assign(this.material, {defines: this.hasSection ? {HAS_SECTION: ""} : {}, needsUpdate: true});
    this.material.side = plane || this.recording.dimension === 2 ? THREE.DoubleSide : THREE.FrontSide;
  }
}

/** The corners of all faces, in the order of blocks and faces. VisibleFaces makes triangles of them. */
function meshGeometry(blocks) {
  let corners = 0;
  for (const {faces} of blocks) for (const face of faces) corners += face.length;
  const positions = new Float32Array(3 * corners), edges = new Uint8Array(3 * corners);
  const owners = new Float32Array(2 * corners), across = new Float32Array(3 * corners);
  let corner = 0;
  for (const {number, firstNode, vertices, faces} of blocks) {
    for (const face of faces) {
      const normal = firstNode < 0 ? normalOf(face, vertices).toArray() : null;
      face.forEach((vertex, place) => {
        positions.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner);
        edges.set(distancesFromEdges(place, face.length), 3 * corner);
        owners[2 * corner] = number;
        owners[2 * corner + 1] = firstNode < 0 ? -1 : firstNode + vertex;
        const nodeAfter = (step) => firstNode + face[(place + step) % face.length];
        across.set(normal || [nodeAfter(1), nodeAfter(face.length - 1)], 3 * corner);
        ++corner;
      });
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("edges", new THREE.BufferAttribute(edges, 3, true));
  geometry.setAttribute("owner", new THREE.BufferAttribute(owners, 2));
  geometry.setAttribute("across", new THREE.BufferAttribute(across, 3));
  return geometry;
}

/** The distances of a corner from the edges of its face, in three classes: 0 on an edge of the class, else 255. The
    first edge and the last have a class each, all between them the third one. So no class is 0 along a whole diagonal
    from the first corner, which is a side of two triangles and no edge. */
function distancesFromEdges(place, size) {
  const distances = [255, 255, 255];
  for (const edge of [place, (place + size - 1) % size]) distances[edge === 0 ? 0 : edge === size - 1 ? 1 : 2] = 0;
  return distances;
}
