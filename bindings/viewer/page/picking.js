"use strict";

/** Finds the block at a pixel, by a picture of one pixel in which a colour is the number of a block. */
class Picker {
  constructor(renderer, blockMesh, control) {
    Object.assign(this, {renderer, blockMesh, control});
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.scene = new THREE.Scene();
  }

  /** The number of the block at a pixel from the upper left corner; -1 if there is none. */
  blockAt(x, y) {
    const {renderer, blockMesh: {mesh, material, uniforms}, control: {camera, width, height}} = this;
    const {parent} = mesh, clearColour = renderer.getClearColor().clone(), clearAlpha = renderer.getClearAlpha();
    const {transparent, depthWrite} = material, pixel = new Uint8Array(4);
    this.scene.add(mesh);
    Object.assign(material, {transparent: false, depthWrite: true});
    uniforms.isPicking.value = true;
    camera.setViewOffset(width, height, Math.floor(x), Math.floor(y), 1, 1);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, pixel);
    renderer.setRenderTarget(null);
    renderer.setClearColor(clearColour, clearAlpha);
    camera.clearViewOffset();
    uniforms.isPicking.value = false;
    Object.assign(material, {transparent, depthWrite});
    if (parent) parent.add(mesh);
    return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
  }
}
