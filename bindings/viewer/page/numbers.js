"use strict";

/** A number with three significant digits, for people. */
function shortNumber(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) {
    const [digits, exponent] = value.toExponential(2).split("e");
    return `${parseFloat(digits)}e${parseInt(exponent, 10)}`.replace("-", "−").replace("e-", "e−");
  }
  return String(parseFloat(value.toPrecision(3))).replace("-", "−");
}

const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]];

/** The factor and the name of a unit in which values up to this size have few digits, such as kN. */
function scaledUnit(unit, size) {
  if (!["N", "Pa", "J"].includes(unit)) return {factor: 1, unit};
  const [factor, prefix] = prefixes.find(([least]) => size >= least) || [1, ""];
  return {factor, unit: prefix + unit};
}

/** Round numbers over a range, some `count` of them. */
function ticksOf(low, high, count) {
  if (!(high > low)) return [low];
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough * 0.999);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) ticks.push(i * step);
  return ticks;
}
