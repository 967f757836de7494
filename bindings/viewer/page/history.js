"use strict";

const chartedEnergies = ["kinetic", "strain", "block_strain", "bolt_strain", "friction_loss", "contact_damping_loss",
  "local_damping_loss", "mass_damping_loss", "block_damping_loss", "bolt_loss", "outer_work", "residual"];

/** The history of a run: columns over time. */
class History {
  constructor(csv) {
    const [names, ...rows] = csv.trim().split("\n").map(valuesOfLine);
    this.columns = new Map();
    if (rows.length === 0) return;
    names.forEach((name, index) => {
      const values = Float64Array.from(rows, (row) => (row[index] === "" ? NaN : Number(row[index])));
      if (values.some(Number.isFinite)) this.columns.set(name, values);
    });
    this.times = this.columns.get("time");
  }

  /** A column; the outer work since the start, because the ledger's includes the energy at the start. */
  series(name) {
    const column = this.columns.get(name), from = name === "outer_work" ? column[0] : 0;
    return {name: name.replace(/_/g, " "), times: this.times, values: column.map((value) => value - from)};
  }

  /** The energies that change, without the sum of their errors. */
  energies() {
    const changes = (values) => values.some((value) => value !== values[0]);
    return chartedEnergies.filter((name) => this.columns.has(name) && changes(this.columns.get(name)));
  }

  /** All other columns. */
  others() {
    const left = ["time", "gravity", "water", ...chartedEnergies];
    return [...this.columns.keys()].filter((name) => !left.includes(name));
  }
}

/** The values of a line of comma-separated values, some in quotes. */
function valuesOfLine(line) {
  const values = [""];
  let isQuoted = false;
  for (const c of line) {
    if (c === '"') isQuoted = !isQuoted;
    else if (c === "," && !isQuoted) values.push("");
    else values[values.length - 1] += c;
  }
  return values;
}
