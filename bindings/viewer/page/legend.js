"use strict";

// The parts of the overlay: the colours' legend, the time, a scale in 2D or the axes in 3D. Places count from the upper
// left corner of the picture.

function drawLegend(context, {height, field, range, isLog, table, theme}) {
  if (field.categories) drawCategories(context, height, field, theme);
  else drawScale(context, height, field, range, isLog, table, theme);
}

function drawOrientation(context, {width, height, camera, theme}) {
  if (camera.dimension === 2) drawRuler(context, width, height, camera, theme);
  else drawAxes(context, width, height, camera, theme);
}

/** The ground of a text over the picture. */
function drawCard(context, left, top, width, height, theme) {
  context.fillStyle = theme.card;
  context.beginPath();
  context.roundRect(left, top, width, height, 8);
  context.fill();
}

const overlayFont = (size, weight = 400) => `${weight} ${size}px system-ui, "Segoe UI", "DejaVu Sans", sans-serif`;

/** A text, cut to a width. */
function shortened(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let count = text.length;
  while (count > 0 && context.measureText(`${text.slice(0, count)}…`).width > width) --count;
  return `${text.slice(0, count)}…`;
}

function drawTime(context, {width, camera, title, time, theme}) {
  const buttons = camera.dimension === 2 ? 190 : 290;
  context.textAlign = "left";
  context.fillStyle = theme.text;
  context.font = overlayFont(15, 600);
  context.fillText(shortened(context, title, width - buttons), 18, 24);
  context.font = overlayFont(13);
  context.fillStyle = theme.quiet;
  context.fillText(`t = ${time.toPrecision(4).replace(/\.?0+$/, "")} s`, 18, 45);
}

function drawScale(context, height, field, range, isLog, table, theme) {
  const tall = Math.min(220, height - 150), left = 24, top = height - tall - 28, wide = 14;
  if (tall < 40) return;
  const [low, high] = range;
  const {factor, unit} = scaledUnit(field.unit, Math.max(Math.abs(low), Math.abs(high)));
  const name = unit ? `${field.name} (${unit})` : field.name;
  context.font = overlayFont(13, 600);
  drawCard(context, 12, top - 36, Math.max(context.measureText(name).width, 74) + 24, tall + 52, theme);
  for (let i = 0; i < tall; ++i) {
    const c = 4 * Math.round((1 - i / (tall - 1)) * 255);
    context.fillStyle = `rgb(${table[c]},${table[c + 1]},${table[c + 2]})`;
    context.fillRect(left, top + i, wide, 1.5);
  }
  context.textAlign = "left";
  context.fillStyle = theme.text;
  context.fillText(name, left, top - 18);
  context.font = overlayFont(12);
  const ticks = isLog ? logTicks(low, high) : ticksOf(low / factor, high / factor, 5).map((tick) => tick * factor);
  for (const tick of ticks) {
    const part = isLog ? Math.log10(tick / low) / Math.log10(high / low) : (tick - low) / (high - low || 1);
    const y = top + (1 - part) * (tall - 1);
    context.fillStyle = theme.quiet;
    context.fillRect(left + wide, y - 0.5, 5, 1);
    context.fillStyle = theme.text;
    context.fillText(shortNumber(tick / factor), left + wide + 9, y + 0.5);
  }
}

function logTicks(low, high) {
  const ticks = [], decades = Math.log10(high / low), every = Math.max(1, Math.ceil(decades / 6));
  for (let power = Math.ceil(Math.log10(low) - 1e-9); power <= Math.log10(high) + 1e-9; power += every)
    ticks.push(10 ** power);
  return ticks;
}

function drawCategories(context, height, field, theme) {
  const shown = field.categories.map((name, index) => [name, index]).filter(([name]) => name !== "").slice(0, 12);
  const left = 24, top = height - 30 - 20 * shown.length;
  const title = shown.length > 0 ? field.name : "blocks, in any colour";
  context.textAlign = "left";
  context.font = overlayFont(13, 600);
  const texts = [title, ...shown.map(([name]) => `${name}     `)];
  const width = Math.max(...texts.map((text) => context.measureText(text).width));
  drawCard(context, 12, top - 26, width + 24, 20 * shown.length + 42, theme);
  context.fillStyle = theme.text;
  context.fillText(title, left, top - 9);
  context.font = overlayFont(12);
  shown.forEach(([name, index], row) => {
    context.fillStyle = categoryColours[index % categoryColours.length];
    context.fillRect(left, top + 20 * row + 6, 12, 12);
    context.fillStyle = theme.text;
    context.fillText(name, left + 20, top + 20 * row + 12.5);
  });
}

/** A round length in the picture. */
function drawRuler(context, width, height, camera, theme) {
  const scale = camera.metresPerPixel(), longest = 150 * scale, power = 10 ** Math.floor(Math.log10(longest));
  const length = [5, 2, 1].map((digit) => digit * power).find((size) => size <= longest);
  const right = width - 20, left = right - length / scale, y = height - 24;
  context.strokeStyle = theme.text;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(left, y - 5);
  context.lineTo(left, y);
  context.lineTo(right, y);
  context.lineTo(right, y - 5);
  context.stroke();
  context.fillStyle = theme.text;
  context.textAlign = "center";
  context.font = overlayFont(12);
  context.fillText(`${shortNumber(length)} m`, (left + right) / 2, y - 11);
}

function drawAxes(context, width, height, camera, theme) {
  const size = 34, x = width - 58, y = height - 56;
  const right = camera.right(), up = camera.up(), outward = camera.outward();
  const axes = [["x", 0, "#e5484d"], ["y", 1, "#46a758"], ["z", 2, "#3e8eff"]];
  axes.sort((a, b) => outward.getComponent(a[1]) - outward.getComponent(b[1]));
  context.lineWidth = 2;
  context.textAlign = "center";
  context.font = overlayFont(12, 600);
  for (const [name, axis, colour] of axes) {
    const dx = size * right.getComponent(axis), dy = -size * up.getComponent(axis);
    context.strokeStyle = context.fillStyle = colour;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + dx, y + dy);
    context.stroke();
    context.fillText(name, x + 1.3 * dx, y + 1.3 * dy);
  }
}
