"use strict";

/** Whether the browser draws by the processor, to which each sample of a pixel costs time. */
function drawsBySoftware() {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render/i.test(name);
}

/** The picture: blocks and layers in WebGL, and the overlay above them. */
class Picture {
  constructor(recording, canvas, overlay, onChange) {
    this.isBySoftware = drawsBySoftware();
    const options = {antialias: !this.isBySoftware, alpha: false}, context = canvas.getContext("webgl2", options);
    if (!context) throw new Error("This browser has no WebGL 2, which the viewer needs.");
    Object.assign(this, {recording, canvas});
    this.overlay = new Overlay(overlay);
    this.renderer = new THREE.WebGLRenderer({canvas, context, ...options});
    this.blockMesh = new BlockMesh(recording);
    this.layers = new Layers(recording, this.blockMesh);
    this.scene = new THREE.Scene();
    this.scene.add(this.blockMesh.mesh, this.layers.group);
    this.control = new Camera(canvas, recording.dimension, onChange);
    this.picker = new Picker(this.renderer, this.blockMesh, this.control);
    this.colours = new THREE.DataTexture(new Uint8Array(4 * 256), 256, 1, THREE.RGBAFormat);
    this.blockMesh.uniforms.colours.value = this.colours;
  }

  setColours(table) {
    this.colours.image.data.set(table);
    this.colours.needsUpdate = true;
    this.table = table;
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    const ratio = window.devicePixelRatio || 1;
    this.renderer.setPixelRatio(this.isBySoftware ? 1 : ratio);
    this.renderer.setSize(width, height, false);
    this.overlay.resize(width, height, ratio);
    this.layers.setViewport(width, height);
    this.control.resize(width, height);
  }

  draw(legend) {
    const {renderer, overlay, control} = this;
    const style = getComputedStyle(document.documentElement);
    const [text, quiet, card] = ["--text", "--quiet", "--card"].map((name) => style.getPropertyValue(name));
    renderer.setClearColor(new THREE.Color(style.getPropertyValue("--back").trim()), 1);
    this.blockMesh.prepare(control.camera);
    renderer.render(this.scene, control.camera);
    overlay.show({...legend, width: control.width, height: control.height, table: this.table, camera: control,
      theme: {text, quiet, card}});
  }

  setSection(plane) {
    this.blockMesh.setSection(plane);
    this.layers.setSection(plane);
  }

  blockAt(x, y) {
    return this.picker.blockAt(x, y);
  }

  /** The picture with its legend, as a PNG. It has just been drawn: browsers forget what they have shown. */
  png() {
    const {canvas, control} = this, whole = document.createElement("canvas");
    whole.width = canvas.width;
    whole.height = canvas.height;
    const context = whole.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const ratio = canvas.width / control.width;
    context.scale(ratio, ratio);
    this.overlay.copyTo(context);
    return new Promise((resolve) => whole.toBlob(resolve, "image/png"));
  }
}

/** The box that the first view shows: of blocks that move, without stragglers, and what is near of fixed blocks. */
async function boxOf(recording, blockMesh) {
  const values = new Float32Array(recording.blocks.length), moving = [[], [], []], all = [[], [], []];
  for (const number of new Set([0, recording.frameCount - 1])) {
    blockMesh.show(await recording.frame(number), values);
    for (const block of recording.blocks) {
      if (!blockMesh.isPresent(block.number)) continue;
      for (const vertex of blockMesh.verticesOf(block)) {
        vertex.toArray().forEach((coordinate, axis) => {
          all[axis].push(coordinate);
          if (block.kind >= 2) moving[axis].push(coordinate);
        });
      }
    }
  }
  if (all[0].length === 0) throw new Error("There is no block in the first frame, nor in the last one.");
  const bounds = (coordinates, fraction) => {
    const sorted = Float64Array.from(coordinates).sort(), last = sorted.length - 1;
    return [sorted[Math.round(fraction * last)], sorted[Math.round((1 - fraction) * last)]];
  };
  const box = new THREE.Box3();
  const shown = moving[0].length > 0 ? moving.map((coordinates) => bounds(coordinates, 0.002))
    : all.map((coordinates) => bounds(coordinates, 0));
  const size = Math.max(...shown.map(([low, high]) => high - low));
  all.forEach((coordinates, axis) => {
    const [low, high] = shown[axis], [lowest, highest] = bounds(coordinates, 0), margin = 0.06 * size;
    box.min.setComponent(axis, Math.max(lowest, low - margin));
    box.max.setComponent(axis, Math.min(highest, high + margin));
  });
  return box;
}
