"use strict";

/** A part of the overlay, in a canvas as small as its content: browsers blend clear pixels at the cost of others. */
class OverlayPart {
  constructor(parent, place, draw) {
    Object.assign(this, {place, draw, canvas: parent.appendChild(document.createElement("canvas"))});
  }

  /** Fits into a picture of this size, at this many pixels of the screen per pixel of the page. */
  resize(pictureWidth, pictureHeight, ratio) {
    const [left, top, width, height] = this.place(pictureWidth, pictureHeight);
    Object.assign(this, {left, top, width, height, ratio});
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    Object.assign(this.canvas.style, {left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px`});
  }

  show(content) {
    const context = this.canvas.getContext("2d"), {left, top, width, height, ratio} = this;
    context.setTransform(ratio, 0, 0, ratio, -left * ratio, -top * ratio);
    context.clearRect(left, top, width, height);
    context.textBaseline = "middle";
    this.draw(context, content);
  }

  copyTo(context) {
    context.drawImage(this.canvas, this.left, this.top, this.width, this.height);
  }
}

/** The texts above the picture. A saved picture contains it, too. */
class Overlay {
  constructor(parent) {
    this.time = new OverlayPart(parent, (width) => [0, 0, width, 60], drawTime);
    this.legend = new OverlayPart(parent, (width, height) => [0, height - 310, Math.min(320, width), 310], drawLegend);
    this.orientation = new OverlayPart(parent, (width, height) => [width - 200, height - 120, 200, 120],
      drawOrientation);
    this.parts = [this.time, this.legend, this.orientation];
  }

  resize(width, height, ratio) {
    for (const part of this.parts) part.resize(width, height, ratio);
    this.drawn = "";
  }

  /** Draws the time, and the other parts if they have changed. */
  show(content) {
    this.time.show(content);
    const {field, range, isLog, table, camera, theme} = content;
    const {distance, azimuth, elevation} = camera;
    const state = JSON.stringify([field.name, range, isLog, table, theme, distance, azimuth, elevation]);
    if (state === this.drawn) return;
    this.drawn = state;
    this.legend.show(content);
    this.orientation.show(content);
  }

  copyTo(context) {
    for (const part of this.parts) part.copyTo(context);
  }
}
