"use strict";

/** A quantity by which blocks are coloured: values of all blocks in a frame, or categories with names. */
class Field {
  constructor(name, unit, valuesIn, range, options = {}) {
    Object.assign(this, {name, unit, valuesIn, range, categories: null, map: "viridis"}, options);
  }
}

/** All fields of a recording: those of its frames, those that follow from poses, and what blocks are. */
function fieldsOf(recording, start) {
  const axes = ["x", "y", "z"].slice(0, recording.dimension);
  const origin = axes.map((axis) => start.column("blocks", axis).slice());
  const {blocks} = recording;
  const perBlock = (value) => {
    const values = Float32Array.from(blocks, value);
    return () => values;
  };
  const displacement = (frame, axis) => {
    const start = origin[axis];
    return frame.column("blocks", axes[axis]).map((coordinate, block) => coordinate - start[block]);
  };
  const fields = [
    new Field("displacement", "m", (frame) => {
      const [x, y, z] = axes.map((_, axis) => displacement(frame, axis));
      return x.map((_, block) => Math.sqrt(x[block] ** 2 + y[block] ** 2 + (z ? z[block] ** 2 : 0)));
    }, null),
  ];
  axes.forEach((axis, index) => fields.push(new Field(`displacement ${axis}`, "m",
    (frame) => displacement(frame, index), null, {map: "diverging"})));
  for (const column of recording.description("blocks")) {
    if (column.name === "present" || poseColumns.includes(column.name)) continue;
    const isSigned = column.low < 0;
    fields.push(new Field(column.name, column.unit, (frame) => frame.column("blocks", column.name),
      [isSigned ? column.usual_low : 0, column.usual_high], {map: isSigned ? "diverging" : "viridis"}));
  }
  fields.push(...stressMeasures(recording));
  const materials = recording.materials.length > 0 ? recording.materials : ["material 0"];
  fields.push(
    new Field("material", "", perBlock((block) => block.material), null, {categories: materials}),
    new Field("kind", "", perBlock((block) => block.kind), null, {categories: kindNames}),
    new Field("block", "", perBlock((block) => (7 * block.number) % categoryColours.length), null,
      {categories: categoryColours.map(() => "")}));
  return fields;
}

/** The mean stress and the largest shear stress, where blocks have stresses. */
function stressMeasures(recording) {
  const {dimension, blocks} = recording;
  if (!recording.description("blocks").some((column) => column.name === "stress xx")) return [];
  const of = (frame, component) => frame.column("blocks", `stress ${component}`);
  const mean = new Field("mean stress", "Pa", (frame) => {
    const parts = ["xx", "yy", "zz"].slice(0, dimension).map((component) => of(frame, component));
    return Float32Array.from(blocks, ({number}) => parts.reduce((sum, part) => sum + part[number], 0) / dimension);
  }, null, {map: "diverging"});
  if (dimension === 3) {
    const equivalent = new Field("von Mises stress", "Pa", (frame) => {
      const [xx, yy, zz, yz, zx, xy] = ["xx", "yy", "zz", "yz", "zx", "xy"].map((component) => of(frame, component));
      return Float32Array.from(blocks, ({number: b}) => Math.sqrt(
        ((xx[b] - yy[b]) ** 2 + (yy[b] - zz[b]) ** 2 + (zz[b] - xx[b]) ** 2) / 2
        + 3 * (yz[b] ** 2 + zx[b] ** 2 + xy[b] ** 2)));
    }, null);
    return [mean, equivalent];
  }
  const shear = new Field("max shear stress", "Pa", (frame) => {
    const [xx, yy, xy] = ["xx", "yy", "xy"].map((component) => of(frame, component));
    return Float32Array.from(blocks, ({number: b}) => Math.hypot((xx[b] - yy[b]) / 2, xy[b]));
  }, null);
  return [mean, shear];
}

/** The range of a field without its extreme hundredths, in some frames. */
async function rangeOf(field, recording, numbers) {
  const values = [];
  for (const number of numbers) {
    const frame = await recording.frame(number);
    const present = frame.column("blocks", "present");
    field.valuesIn(frame).forEach((value, block) => {
      if (present[block] && !isFixed(recording.blocks[block]) && Number.isFinite(value)) values.push(value);
    });
  }
  if (values.length === 0) return [0, 1];
  values.sort((a, b) => a - b);
  const at = (fraction) => values[Math.round(fraction * (values.length - 1))];
  return [at(0) >= 0 ? 0 : at(0.01), at(0.99)];
}
