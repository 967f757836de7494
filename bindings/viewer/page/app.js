"use strict";

const element = (id) => document.getElementById(id);

/** The viewer: its state, and what follows from a change of it. */
class Viewer {
  static async open() {
    const recording = await Recording.load();
    const viewer = new Viewer(recording, await recording.frame(0));
    await viewer.start();
    return viewer;
  }

  constructor(recording, first) {
    this.recording = recording;
    document.documentElement.classList.toggle("in-plane", recording.dimension === 2);
    this.picture = new Picture(recording, element("picture"), element("overlay"), () => this.redraw());
    this.layers = this.picture.layers;
    this.fields = fieldsOf(recording, first);
    this.history = recording.history ? new History(recording.history) : null;
    this.player = new Player(recording.frameCount, (number) => this.show(number));
    this.inspector = new Inspector(element("inspector"), recording, this.layers, (block) => this.select(block),
      (time) => this.goToTime(time));
    this.isLog = false;
    this.frame = first;
  }

  async start() {
    const {recording, picture} = this;
    await this.layers.placeCracks();
    picture.resize();
    picture.control.fit(await boxOf(recording, picture.blockMesh));
    this.controls = new Controls(this);
    new ResizeObserver(() => picture.resize()).observe(element("stage"));
    await this.setField(this.fields[0]);
    this.draw();  // what it throws is a problem of the page, which a later draw would not show
    element("message").hidden = true;
  }

  // Frames.

  async show(number) {
    this.frame = await this.recording.frame(number);
    this.update();
  }

  goToTime(time) {
    return this.player.goTo(this.recording.frameAt(time));
  }

  /** Shows the frame again, after a change of what is shown. */
  update() {
    const {frame} = this, values = this.field.valuesIn(frame);
    this.picture.blockMesh.show(frame, this.isLog ? values.map(Math.log10) : values, !this.field.categories);
    this.layers.show(frame);
    this.inspector.show(frame);
    this.controls.showFrame(frame);
    this.redraw();
  }

  /** Draws the picture before the browser shows its next one. */
  redraw() {
    if (this.isDrawing) return;
    this.isDrawing = true;
    requestAnimationFrame(() => {
      this.isDrawing = false;
      this.draw();
    });
  }

  draw() {
    if (!this.range) return;
    this.drawnCount = (this.drawnCount || 0) + 1;
    this.picture.draw({field: this.field, range: this.range, isLog: this.isLog, title: this.recording.title,
      time: this.frame.time});
  }

  // Colours.

  async setField(field) {
    this.field = field;
    this.map = field.map;
    this.isLog = false;
    await this.setRangeOfRun();
    this.controls.showColours();
    this.inspector.showHistory(field);
  }

  /** The range of the whole run, from a few of its frames if the field is not in the table of ranges. */
  async setRangeOfRun() {
    const {field, recording} = this;
    if (field.categories) return this.setRange([-0.5, field.categories.length - 0.5]);
    const last = recording.frameCount - 1;
    const some = [...new Set([0, 0.25, 0.5, 0.75, 1].map((part) => Math.round(part * last)))];
    return this.setRange(field.range || await rangeOf(field, recording, some));
  }

  async setRangeOfFrame() {
    return this.setRange(await rangeOf(this.field, this.recording, [this.frame.number]));
  }

  setRange([low, high]) {
    if (this.field.map === "diverging" && this.map === "diverging") {
      high = Math.max(Math.abs(low), Math.abs(high));
      low = -high;
    }
    this.range = [low, high > low ? high : low + 1];
    this.applyColours();
  }

  setLog(isLog) {
    this.isLog = isLog;
    const [low, high] = this.range;
    if (isLog && low <= 0) this.range = [high > 0 ? high * 1e-4 : 1e-4, high > 0 ? high : 1];
    this.applyColours();
  }

  setMap(map) {
    this.map = map;
    this.applyColours();
  }

  applyColours() {
    const {field, isLog, picture} = this, [low, high] = this.range;
    picture.setColours(field.categories ? categoryTable(field.categories.length) : colourTable(this.map));
    picture.blockMesh.uniforms.range.value.set(isLog ? Math.log10(low) : low, isLog ? Math.log10(high) : high);
    this.update();
  }

  // Layers, fields and ranges on show.

  async setLayer(name, isShown) {
    if (name === "joints" && isShown) await this.layers.findJoints();
    this.layers.isShown[name] = isShown;
    this.controls.showLayer(name, isShown);
    const {uniforms} = this.picture.blockMesh;
    // Forces inside of solids are seen through them.
    if (name === "forces" && isShown && this.recording.dimension === 3 && uniforms.opacity.value === 1)
      this.setOpacity(0.25);
    this.update();
  }

  setOpacity(opacity) {
    this.picture.blockMesh.setOpacity(opacity);
    this.controls.showOpacity(opacity);
    this.redraw();
  }

  /** Removes what is ahead of a plane across an axis, at a fraction of the run's extent; axis -1: nothing. */
  setSection(axis, fraction, isFlipped) {
    const {box} = this.picture.control;
    if (axis < 0) {
      this.picture.setSection(null);
    } else {
      const normal = new THREE.Vector3().setComponent(axis, isFlipped ? -1 : 1);
      const [low, high] = [box.min.getComponent(axis), box.max.getComponent(axis)];
      const place = low + fraction * (high - low);
      this.picture.setSection(new THREE.Vector4(normal.x, normal.y, normal.z, isFlipped ? -place : place));
    }
    this.redraw();
  }

  /** Selects a block by its number; -1 selects none. */
  select(number) {
    this.selected = number;
    this.picture.blockMesh.uniforms.selected.value = number;
    this.inspector.pick(number < 0 ? null : this.recording.blocks[number], this.fields);
    this.inspector.show(this.frame);
    this.inspector.showHistory(this.field);
    this.redraw();
  }

  blockAt(x, y) {
    return this.picture.blockAt(x, y);
  }

  async savePicture() {
    this.draw();
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await this.picture.png());
    link.download = `frame_${String(this.frame.number).padStart(4, "0")}.png`;
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

/** Says why the page shows nothing. */
function showProblem(problem) {
  const message = element("message");
  message.hidden = false;
  message.textContent = problem instanceof Error ? problem.message : String(problem);
  throw problem;
}

window.viewerReady = Viewer.open().then((viewer) => { window.viewer = viewer; }, showProblem);
