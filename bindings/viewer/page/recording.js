"use strict";

/** Columns of a block's pose: its centroid, and its angle in 2D, its rotation vector in 3D. */
const poseColumns = ["x", "y", "z", "angle", "turn_x", "turn_y", "turn_z"];

/** A table of a group of frames: for each column the values of all items, unpacked when they are first read. */
class GroupTable {
  constructor(description, reader, frameCount) {
    this.itemCount = reader.whole();
    this.columns = new Map();
    const columnCount = reader.byte();
    for (const column of description.columns.slice(0, columnCount))
      this.columns.set(column.name, new PackedColumn(reader, this.itemCount, frameCount, column));
  }

  /** A column in a frame of the group. */
  column(name, frame) {
    let values = this.columns.get(name);
    if (values instanceof PackedColumn) this.columns.set(name, values = values.unpacked());
    return values && values.subarray(frame * this.itemCount, (frame + 1) * this.itemCount);
  }
}

/** The run: its blocks, and its frames, of which only some groups are unpacked at a time. */
class Recording {
  static async load() {
    const header = JSON.parse(new TextDecoder().decode(await bytesOf("header")));
    return new Recording(header, new ByteReader(await bytesOf("geometry")));
  }

  constructor(header, geometry) {
    Object.assign(this, header);
    this.blocks = readBlocks(geometry, header.names);
    this.tableNames = header.tables.map((table) => table.name);
    this.groups = new Map();
  }

  get frameCount() {
    return this.times.length;
  }

  description(table) {
    return this.tables[this.tableNames.indexOf(table)].columns;
  }

  /** A promise of a frame. */
  async frame(number) {
    const index = Math.floor(number / this.frames_per_group);
    if (!this.groups.has(index)) {
      const keptGroups = 6;
      if (this.groups.size >= keptGroups) this.groups.delete(this.groups.keys().next().value);
      this.groups.set(index, this.readGroup(index));
    }
    const tables = await this.groups.get(index), place = number - index * this.frames_per_group;
    return {
      number,
      time: this.times[number],
      count: (table) => tables.get(table).itemCount,
      column: (table, name) => tables.get(table).column(name, place),
    };
  }

  async readGroup(index) {
    const reader = new ByteReader(await bytesOf(`group-${index}`));
    const frameCount = reader.byte();
    return new Map(this.tables.map((table) => [table.name, new GroupTable(table, reader, frameCount)]));
  }

  /** The last frame at or before a time. */
  frameAt(time) {
    let low = 0, high = this.frameCount - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}

/** Blocks with their kinds, materials, vertices relative to the centroid, and faces. The last ones may be still blocks,
    which frames do not repeat: their vertices are positions, and they have the number of frames until their removal. */
function readBlocks(reader, names) {
  const count = reader.whole();
  const [kinds, materials, nodes, vertexCounts, faceCounts] = Array.from({length: 5}, () => reader.wholes(count));
  const total = (numbers) => numbers.reduce((sum, number) => sum + number, 0);
  const faceSizes = reader.wholes(total(faceCounts));
  const faceVertices = reader.wholes(total(faceSizes));
  const coordinates = reader.floats(3 * total(vertexCounts));
  const blocks = [];
  let face = 0, corner = 0, coordinate = 0;
  for (let b = 0; b < count; ++b) {
    const faces = [];
    for (let f = 0; f < faceCounts[b]; ++f) {
      const size = faceSizes[face++];
      faces.push(faceVertices.subarray(corner, corner += size));
    }
    blocks.push({
      number: b,
      name: names[b] || `block ${b}`,
      kind: kinds[b],
      material: materials[b],
      firstNode: nodes[b] - 1,
      vertexCount: vertexCounts[b],
      vertices: coordinates.subarray(coordinate, coordinate += 3 * vertexCounts[b]),
      faces,
    });
  }
  const stillCount = reader.whole(), frameCounts = reader.wholes(stillCount);
  blocks.forEach((block) => {
    block.isStill = block.number >= count - stillCount;
    block.frameCount = block.isStill ? frameCounts[block.number - count + stillCount] : null;
  });
  return blocks;
}

const kindNames = ["fixed", "prescribed", "rigid", "affine", "cell of a mesh"];

/** Whether a frame has a block. */
const isIn = (frame, {number, isStill, frameCount}) =>
  isStill ? frame.number < frameCount : frame.column("blocks", "present")[number] === 1;

const isFixed = (block) => block.kind === 0;
