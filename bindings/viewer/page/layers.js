"use strict";

// Layers besides the blocks: contact forces and points, open joints, cracks, bolts, the water table.

const layerColours = {
  compression: [0.93, 0.36, 0.2], tension: [0.2, 0.5, 0.95], point: [0.98, 0.78, 0.2], bolt: [0.15, 0.72, 0.62],
  ruptured: [0.85, 0.2, 0.35], joint: [0.93, 0.2, 0.7], tensileCrack: [0.88, 0.13, 0.25], shearCrack: [0.6, 0.25, 0.8],
  water: [0.2, 0.55, 0.95],
};

class Layers {
  constructor(recording, blockMesh) {
    this.recording = recording;
    this.blockMesh = blockMesh;
    const isInFront = recording.dimension === 3;
    this.bars = {
      forces: new Bars(isInFront), points: new Bars(isInFront), bolts: new Bars(isInFront), joints: new Bars(false),
      cracks: new Bars(false), water: new Bars(false),
    };
    this.group = new THREE.Group();
    for (const {mesh} of Object.values(this.bars)) this.group.add(mesh);
    this.group.children.forEach((mesh, index) => { mesh.renderOrder = 1 + index; });
    this.waterSurface = waterSurface();
    this.group.add(this.waterSurface);
    this.isShown = {forces: false, points: false, bolts: true, joints: false, cracks: true, water: true};
    this.forceScale = 1;
    this.thicknesses = recording.blocks.map(thicknessOf);
    this.cracks = recording.cracks.map((crack) => ({...crack, local: null}));
    this.joints = null;
  }

  /** The names of the layers that the recording has. */
  available() {
    const {recording} = this;
    const has = (table) => Number.isFinite(recording.description(table)[1].low);
    return [
      ...(has("contacts") ? ["forces", "points"] : []),
      ...(has("bolts") ? ["bolts"] : []),
      ...(recording.frameCount > 1 ? ["joints"] : []),
      ...(recording.cracks.length > 0 ? ["cracks"] : []),
      ...(recording.water.length > 0 ? ["water"] : []),
    ];
  }

  /** The force that has a bar of the usual width. */
  get usualForce() {
    return this.recording.description("contacts").find(({name}) => name === "force").usual_high || 1;
  }

  show(frame) {
    for (const bars of Object.values(this.bars)) bars.clear();
    if (this.isShown.forces || this.isShown.points) this.addContacts(frame);
    if (this.isShown.bolts) this.addBolts(frame);
    if (this.isShown.joints) this.joints.addTo(this.bars.joints, [...layerColours.joint, 1]);
    if (this.isShown.cracks) this.addCracks(frame);
    this.showWater(frame);
    for (const bars of Object.values(this.bars)) bars.commit();
  }

  addContacts(frame) {
    const count = frame.count("contacts"), {dimension} = this.recording;
    if (count === 0) return;
    const column = (name) => frame.column("contacts", name);
    const present = column("present"), blockA = column("block_a"), blockB = column("block_b");
    const axes = ["x", "y", "z"].slice(0, dimension), at = axes.map(column);
    const force = column("force"), direction = axes.map((axis) => column(`direction_${axis}`));
    const isTension = column("is_tension");
    const usual = this.usualForce, usualWidth = 5 * this.forceScale, maxWidth = 3 * usualWidth;
    const point = [0, 0, 0], begin = [0, 0, 0], end = [0, 0, 0];
    for (let c = 0; c < count; ++c) {
      if (present[c] === 0) continue;
      for (let axis = 0; axis < dimension; ++axis) point[axis] = at[axis][c];
      const width = Math.min((usualWidth * force[c]) / usual, maxWidth);
      if (this.isShown.forces && width > 0.15) {
        const half = 0.5 * Math.min(this.thicknesses[blockA[c]], this.thicknesses[blockB[c]]);
        for (let axis = 0; axis < dimension; ++axis) {
          begin[axis] = point[axis] - half * direction[axis][c];
          end[axis] = point[axis] + half * direction[axis][c];
        }
        const colour = isTension[c] ? layerColours.tension : layerColours.compression;
        this.bars.forces.add(begin, end, width, [...colour, 0.9]);
      }
      if (this.isShown.points) this.bars.points.add(point, point, 2, [...layerColours.point, 1]);
    }
  }

  addBolts(frame) {
    const count = frame.count("bolts"), {dimension} = this.recording;
    if (count === 0) return;
    const column = (name) => frame.column("bolts", name);
    const axes = ["x", "y", "z"].slice(0, dimension);
    const ends = ["a", "b"].map((end) => axes.map((axis) => column(end + axis)));
    const present = column("present"), ruptured = column("is_ruptured");
    for (let bolt = 0; bolt < count; ++bolt) {
      if (present[bolt] === 0) continue;
      const [begin, end] = ends.map((coordinates) => [0, 1, 2].map((axis) => coordinates[axis]?.[bolt] ?? 0));
      const colour = ruptured[bolt] ? layerColours.ruptured : layerColours.bolt;
      this.bars.bolts.add(begin, end, ruptured[bolt] ? 1 : 2, [...colour, 1]);
    }
  }

  /** Cracks that are there: as wide as they have opened between their two blocks or, if these have parted, on each. */
  addCracks(frame) {
    for (const {time, blocks, local, normal, is_shear: isShear} of this.cracks) {
      const poses = blocks.map((block) => this.blockMesh.pose(block));
      if (time > frame.time || !local || !blocks.every((block) => this.blockMesh.isPresent(block))) continue;
      const [a, b] = poses.map(({place, rotation}, side) =>
        local[side].map((end) => end.clone().applyQuaternion(rotation).add(place)));
      const colour = [...(isShear ? layerColours.shearCrack : layerColours.tensileCrack), 1];
      const gaps = [0, 1].map((end) => a[end].distanceTo(b[end]));
      if (Math.max(...gaps) > 0.1 * Math.min(...blocks.map((block) => this.thicknesses[block]))) {
        for (const [begin, end] of [a, b]) this.bars.cracks.add(begin.toArray(), end.toArray(), 1.5, colour);
        continue;
      }
      const [begin, end] = [0, 1].map((end) => a[end].clone().lerp(b[end], 0.5).toArray());
      const across = normal.clone().applyQuaternion(poses[0].rotation);
      const opening = [0, 1].reduce((sum, end) => sum + 0.5 * across.dot(b[end].clone().sub(a[end])), 0);
      this.bars.cracks.add(begin, end, 1.5, colour, Math.max(opening, 0));
    }
  }

  /** Finds the joints in the first frame, unless that is done. */
  async findJoints() {
    const {recording, blockMesh} = this, start = await recording.frame(0);
    if (this.joints) return;
    blockMesh.show(start, new Float32Array(recording.blocks.length));
    this.joints = new Joints(recording, blockMesh, this.thicknesses);
  }

  /** Places the cracks in the frames of their blocks, by the frame at or before the time of each. */
  async placeCracks() {
    const {recording, blockMesh} = this;
    const nothing = new Float32Array(recording.blocks.length);
    for (const crack of this.cracks) {
      const number = recording.frameAt(crack.time);
      if (number !== this.placedAt) blockMesh.show(await recording.frame(number), nothing);
      this.placedAt = number;
      const middle = new THREE.Vector3(...crack.position), normal = new THREE.Vector3(...crack.normal);
      const along = recording.dimension === 2 ? new THREE.Vector3(-normal.y, normal.x, 0) : anyAcross(normal);
      const half = 0.5 * (recording.dimension === 2 ? crack.area : Math.sqrt(crack.area));
      if (recording.dimension === 2) this.moveIntoJoint(crack.blocks, middle, along, half);
      const ends = [-half, half].map((offset) => middle.clone().addScaledVector(along, offset));
      const poses = crack.blocks.map((block) => blockMesh.pose(block));
      crack.local = poses.map(({place, rotation}) =>
        ends.map((end) => end.clone().sub(place).applyQuaternion(rotation.clone().conjugate())));
      crack.normal = normal.applyQuaternion(poses[0].rotation.clone().conjugate());
    }
  }

  /** Moves the middle of a crack so that its ends do not project from the joint: the point of a corner has the part of
      the joint beside it. */
  moveIntoJoint(blocks, middle, along, half) {
    const intervals = blocks.map((block) => {
      const vertices = this.blockMesh.verticesOf(this.recording.blocks[block]);
      const places = vertices.map((vertex) => vertex.sub(middle).dot(along));
      return [Math.min(...places), Math.max(...places)];
    });
    const low = Math.max(...intervals.map(([first]) => first)), high = Math.min(...intervals.map(([, last]) => last));
    middle.addScaledVector(along, Math.max(low + half, 0) + Math.min(high - half, 0));
  }

  showWater(frame) {
    const now = this.recording.water.filter((water) => water.frame <= frame.number).pop();
    const {points, faces} = this.isShown.water && now ? now : {points: [], faces: []};
    this.waterSurface.visible = this.recording.dimension === 3 && faces.length > 0;
    const colour = [...layerColours.water, 1], at = (point) => points[point];
    // The outline of a plane; a height map has too many edges.
    const outline = faces.length === 1 ? faces[0].map(at) : [];
    for (let i = 0; i + 1 < outline.length; ++i) this.bars.water.add(outline[i], outline[i + 1], 1.5, colour);
    if (!this.waterSurface.visible) return;
    if (outline.length > 2) this.bars.water.add(outline[outline.length - 1], outline[0], 1.5, colour);
    setWaterFaces(this.waterSurface, points, faces);
  }

  /** The forces of all contacts of a block in a frame, largest first. */
  contactsOf(block, frame) {
    const count = frame.count("contacts"), contacts = [];
    if (count === 0) return contacts;
    const column = (name) => frame.column("contacts", name);
    const [present, a, b, force] = ["present", "block_a", "block_b", "force"].map(column);
    for (let c = 0; c < count; ++c) {
      if (present[c] === 0 || (a[c] !== block && b[c] !== block)) continue;
      contacts.push({other: a[c] === block ? b[c] : a[c], force: force[c]});
    }
    return contacts.sort((one, two) => two.force - one.force);
  }

  setViewport(width, height) {
    for (const {material} of Object.values(this.bars)) material.uniforms.viewport.value.set(width, height);
  }

  setSection(plane) {
    for (const {material} of Object.values(this.bars)) {
      material.uniforms.hasSection.value = plane !== null;
      if (plane) material.uniforms.section.value.copy(plane);
    }
  }
}

/** The smallest extent of a block along an axis. */
function thicknessOf({vertices, vertexCount}) {
  const extents = [0, 1, 2].map((axis) => {
    let low = Infinity, high = -Infinity;
    for (let v = 0; v < vertexCount; ++v) {
      low = Math.min(low, vertices[3 * v + axis]);
      high = Math.max(high, vertices[3 * v + axis]);
    }
    return high - low;
  });
  return Math.min(...extents.filter((extent) => extent > 0));
}

function anyAcross(normal) {
  const other = Math.abs(normal.x) < 0.7 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
  return other.cross(normal).normalize();
}

function waterSurface() {
  const material = new THREE.MeshBasicMaterial({color: new THREE.Color(...layerColours.water), transparent: true,
    opacity: 0.25, side: THREE.DoubleSide, depthWrite: false});
  const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
  mesh.frustumCulled = false;
  return mesh;
}

function setWaterFaces(mesh, points, faces) {
  mesh.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(points.flat()), 3));
  mesh.geometry.setIndex(faces.flatMap((face) => face.slice(2).flatMap((_, i) => [face[0], face[i + 1], face[i + 2]])));
}
