"use strict";

/** The panel of the picked block: its state in the frame shown, and the history of a field. */
class Inspector {
  constructor(element, recording, layers, onPick, onTime) {
    Object.assign(this, {element, recording, layers, onPick});
    this.hint = element.innerHTML;
    this.block = null;
    this.charted = null;
    this.onTime = onTime;
  }

  /** Shows a block, or the hint if there is none. */
  pick(block, fields) {
    this.block = block;
    this.fields = fields;
    this.charted = null;
    if (!block) {
      this.element.innerHTML = this.hint;
      return;
    }
    this.element.innerHTML = `<h2>Block <button title="Close (Esc)">×</button></h2><h3></h3><table></table>
      <canvas class="chart"></canvas>`;
    this.element.querySelector("h3").textContent = block.name;
    this.element.querySelector("button").addEventListener("click", () => this.onPick(-1));
    this.chart = new Chart(this.element.querySelector("canvas"), this.onTime);
  }

  /** The rows of the table in a frame. */
  show(frame) {
    const {block, recording, fields} = this;
    if (!block) return;
    const b = block.number, column = (name) => frame.column("blocks", name);
    const rows = [["number", String(b)], ["kind", kindNames[block.kind] || String(block.kind)],
      ["material", recording.materials[block.material] || String(block.material)]];
    if (!isIn(frame, block)) {
      rows.push(["state", "removed"]);
    } else {
      const axes = block.isStill ? [] : ["x", "y", "z"].slice(0, recording.dimension);
      const place = axes.map((axis, index) => shortNumber(recording.origin[index] + column(axis)[b]));
      if (place.length > 0) rows.push(["centroid", `${place.join(", ")} m`]);
      if (place.length > 0 && column("angle"))
        rows.push(["angle", `${shortNumber((column("angle")[b] * 180) / Math.PI)}°`]);
      for (const field of fields) {
        if (field.categories) continue;
        const value = field.valuesIn(frame)[b];
        if (!Number.isFinite(value)) continue;
        const {factor, unit} = scaledUnit(field.unit, Math.abs(value));
        rows.push([field.name, `${shortNumber(value / factor)} ${unit}`.trim()]);
      }
    }
    const table = this.element.querySelector("table");
    table.replaceChildren(...rows.map(([name, text]) => tableRow(name, document.createTextNode(text))));
    const partners = this.layers.contactsOf(b, frame), shown = 6;
    for (const {other, force} of partners.slice(0, shown)) {
      const link = document.createElement("a"), {factor, unit} = scaledUnit("N", force);
      link.textContent = recording.blocks[other].name;
      link.addEventListener("click", () => this.onPick(other));
      const row = tableRow(`${shortNumber(force / factor)} ${unit} with`, link);
      table.append(row);
    }
    const more = document.createTextNode(`and ${partners.length - shown} more contacts`);
    if (partners.length > shown) table.append(tableRow("", more));
    this.chart.setTime(frame.time);
  }

  /** Charts a field of the block over all frames, which are unpacked one group after the other. */
  showHistory(field) {
    this.historyShown = this.chartHistory(field);
    return this.historyShown;
  }

  async chartHistory(field) {
    const {block, recording, chart} = this;
    if (!block || block.isStill || field.categories || this.charted === field) return;
    this.charted = field;
    const times = [], values = [];
    for (let number = 0; number < recording.frameCount; ++number) {
      const frame = await recording.frame(number);
      if (this.block !== block || this.charted !== field) return;
      if (!isIn(frame, block)) continue;
      times.push(frame.time);
      values.push(field.valuesIn(frame)[block.number]);
    }
    chart.setSeries([{name: field.name, times, values}], field.unit);
  }
}

function tableRow(name, content) {
  const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
  head.textContent = name;
  cell.append(content);
  row.append(head, cell);
  return row;
}
