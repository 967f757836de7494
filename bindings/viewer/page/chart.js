"use strict";

const seriesColours = ["#4c8dff", "#f0883e", "#3fb27f", "#d2569b", "#9a7bff", "#c9a227", "#5bb5c9", "#e5534b",
                       "#8a8f98", "#7a5c3e", "#b8d44c", "#1f6f5c", "#c7a6ff"];

/** A chart of lines over time in a canvas. A click or drag in it goes to a time. */
class Chart {
  constructor(canvas, onTime) {
    this.canvas = canvas;
    this.series = [];
    this.leftOut = new Set();
    this.time = 0;
    const seek = (event) => {
      if (event.type === "pointermove" && event.buttons === 0) return;
      const box = canvas.getBoundingClientRect();
      onTime(this.begin + ((event.clientX - box.left - this.left) / this.plotWidth) * (this.end - this.begin));
    };
    canvas.addEventListener("pointerdown", seek);
    canvas.addEventListener("pointermove", seek);
  }

  /** Series as {name, times, values}, in one unit. */
  setSeries(series, unit) {
    this.series = series.filter(({values}) => values.length > 0);
    this.unit = unit;
    this.draw();
  }

  setTime(time) {
    this.time = time;
    this.draw();
  }

  /** Leaves a series out, or shows it again; returns whether it is left out. */
  toggle(series) {
    if (!this.leftOut.delete(series)) this.leftOut.add(series);
    this.draw();
    return this.leftOut.has(series);
  }

  draw() {
    const {canvas} = this, ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0) return;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    const context = canvas.getContext("2d"), style = getComputedStyle(canvas);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    if (this.series.length === this.leftOut.size) return;
    let low = Infinity, high = -Infinity;
    this.begin = Infinity;
    this.end = -Infinity;
    for (const series of this.series) {
      if (this.leftOut.has(series)) continue;
      const {times, values} = series;
      this.begin = Math.min(this.begin, times[0]);
      this.end = Math.max(this.end, times[times.length - 1]);
      for (const value of values) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    if (!(high > low)) {
      const margin = Math.abs(high) * 0.1 || 1;
      low -= margin;
      high += margin;
    }
    const {factor, unit} = scaledUnit(this.unit, Math.max(Math.abs(low), Math.abs(high)));
    this.left = 46;
    this.plotWidth = width - this.left - 8;
    const top = 18, bottom = height - 18;
    const x = (time) => this.left + ((time - this.begin) / (this.end - this.begin || 1)) * this.plotWidth;
    const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
    context.font = overlayFont(10.5);
    context.textBaseline = "middle";
    context.lineWidth = 1;
    context.strokeStyle = style.getPropertyValue("--line");
    context.fillStyle = style.getPropertyValue("--quiet");
    context.textAlign = "left";
    context.fillText(unit ? `${unit}` : "", 4, 8);
    context.textAlign = "right";
    for (const tick of ticksOf(low / factor, high / factor, 4)) {
      const at = Math.round(y(tick * factor)) + 0.5;
      context.beginPath();
      context.moveTo(this.left, at);
      context.lineTo(width - 8, at);
      context.stroke();
      context.fillText(shortNumber(tick), this.left - 6, at);
    }
    context.textAlign = "center";
    for (const tick of ticksOf(this.begin, this.end, 5)) context.fillText(shortNumber(tick), x(tick), height - 7);
    context.save();
    context.beginPath();
    context.rect(this.left, top - 4, this.plotWidth + 4, bottom - top + 8);
    context.clip();
    this.series.forEach((series, index) => {
      if (this.leftOut.has(series)) return;
      const {times, values, colour} = series;
      context.strokeStyle = colour || seriesColours[index % seriesColours.length];
      context.lineWidth = 1.6;
      context.beginPath();
      const stride = Math.max(1, Math.floor(values.length / (4 * this.plotWidth)));
      for (let i = 0; i < values.length; i += stride) context.lineTo(x(times[i]), y(values[i]));
      context.stroke();
    });
    context.strokeStyle = style.getPropertyValue("--text");
    context.globalAlpha = 0.6;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x(this.time), top - 4);
    context.lineTo(x(this.time), bottom + 4);
    context.stroke();
    context.restore();
  }
}

/** The name of a series with its colour, as a button that leaves the series out of its chart. */
function legendEntry(chart, series, index) {
  const entry = document.createElement("button");
  entry.title = "Show or hide";
  entry.innerHTML = `<i class="swatch" style="background:${seriesColours[index % seriesColours.length]}"></i>`;
  entry.append(series.name);
  entry.addEventListener("click", () => entry.classList.toggle("off", chart.toggle(series)));
  return entry;
}
