"use strict";

/** The camera, and how the pointer moves it: orbit in 3D, pan, zoom towards the pointer. */
class Camera {
  constructor(element, dimension, onChange) {
    this.dimension = dimension;
    this.onChange = onChange;
    this.element = element;
    this.target = new THREE.Vector3();
    this.azimuth = dimension === 2 ? 0 : -0.55;  // from -y towards x
    this.elevation = dimension === 2 ? Math.PI / 2 : 0.35;
    this.distance = 10;
    this.camera = dimension === 2 ? new THREE.OrthographicCamera(-1, 1, 1, -1) : new THREE.PerspectiveCamera(35);
    this.pointers = new Map();
    element.addEventListener("pointerdown", (event) => this.press(event));
    element.addEventListener("pointermove", (event) => this.drag(event));
    for (const kind of ["pointerup", "pointercancel"])
      element.addEventListener(kind, (event) => this.pointers.delete(event.pointerId));
    element.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  /** Shows all of a box. */
  fit(box) {
    this.box = box;
    box.getCenter(this.target);
    const size = box.getSize(new THREE.Vector3()), aspect = this.aspect || 1;
    if (this.dimension === 2) {
      // The legend is on the left, titles and the scale above and below.
      const aside = Math.min(150, 0.25 * this.width), above = Math.min(120, 0.3 * this.height);
      const scale = Math.max(size.x / (this.width - aside - 30), size.y / (this.height - above), 1e-9);
      this.distance = scale * this.height;
      this.target.x -= 0.5 * (aside - 30) * scale;
    } else {
      this.distance = 1.05 * this.distanceTo(box);
    }
    this.update();
  }

  /** The smallest distance from which all corners of a box are in sight. */
  distanceTo(box) {
    const outward = this.outward(), right = new THREE.Vector3(0, 0, 1).cross(outward).normalize();
    const up = outward.clone().cross(right), slope = Math.tan(0.5 * this.fieldOfView());
    let distance = 1e-6;
    for (const x of [box.min.x, box.max.x]) {
      for (const y of [box.min.y, box.max.y]) {
        for (const z of [box.min.z, box.max.z]) {
          const corner = new THREE.Vector3(x, y, z).sub(this.target);
          const aside = Math.max(Math.abs(corner.dot(up)), Math.abs(corner.dot(right)) / (this.aspect || 1));
          distance = Math.max(distance, aside / slope + corner.dot(outward));
        }
      }
    }
    return distance;
  }

  fieldOfView() {
    return (this.camera.fov * Math.PI) / 180;
  }

  /** Looks along an axis, or from above and aside. */
  look(azimuth, elevation) {
    this.azimuth = azimuth;
    this.elevation = elevation;
    this.fit(this.box);
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    this.aspect = width / height;
    this.update();
  }

  /** The direction from the target to the camera. */
  outward() {
    if (this.dimension === 2) return new THREE.Vector3(0, 0, 1);
    const c = Math.cos(this.elevation);
    return new THREE.Vector3(c * Math.sin(this.azimuth), -c * Math.cos(this.azimuth), Math.sin(this.elevation));
  }

  update() {
    const {camera, distance, target} = this, outward = this.outward();
    if (this.dimension === 2) {
      const half = 0.5 * distance;
      Object.assign(camera, {left: -half * this.aspect, right: half * this.aspect, top: half, bottom: -half});
      camera.near = 0;
      camera.far = 2 * distance;
      camera.up.set(0, 1, 0);
    } else {
      camera.aspect = this.aspect;
      const reach = this.box ? this.box.getSize(new THREE.Vector3()).length() : distance;
      camera.near = Math.max(distance - 3 * reach, 0.005 * distance);
      camera.far = distance + 4 * reach;
      camera.up.set(0, 0, 1);
    }
    camera.position.copy(target).addScaledVector(outward, distance);
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.onChange();
  }

  /** Metres of one pixel at the target. */
  metresPerPixel() {
    const extent = this.dimension === 2 ? this.distance : 2 * this.distance * Math.tan(0.5 * this.fieldOfView());
    return extent / this.height;
  }

  right() {
    return new THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
  }

  up() {
    return new THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
  }

  press(event) {
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = {x: event.clientX, y: event.clientY};
    if (this.pointers.size === 2) return this.pinch(event.pointerId, now);
    this.pointers.set(event.pointerId, now);
    const dx = now.x - before.x, dy = now.y - before.y;
    const pans = this.dimension === 2 || event.shiftKey || (event.buttons & 6) !== 0;
    if (pans) this.pan(dx, dy);
    else this.orbit(dx, dy);
  }

  /** Two fingers zoom and pan. */
  pinch(id, now) {
    const [a, b] = [...this.pointers.values()];
    const span = () => Math.hypot(...["x", "y"].map((axis) => {
      const [one, two] = [...this.pointers.values()];
      return one[axis] - two[axis];
    }));
    const before = span(), middle = {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2};
    this.pointers.set(id, now);
    this.zoom(before / Math.max(span(), 1), middle.x, middle.y);
  }

  pan(dx, dy) {
    const scale = this.metresPerPixel();
    this.target.addScaledVector(this.right(), -dx * scale).addScaledVector(this.up(), dy * scale);
    this.update();
  }

  orbit(dx, dy) {
    this.azimuth -= 0.008 * dx;
    this.elevation = Math.min(Math.max(this.elevation + 0.008 * dy, -1.55), 1.55);
    this.update();
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    this.zoom(Math.exp(0.0015 * lines * event.deltaY), event.clientX, event.clientY);
  }

  /** Scales the distance, and keeps the point under the pointer in its place. */
  zoom(factor, clientX, clientY) {
    const box = this.element.getBoundingClientRect();
    const x = clientX - box.left - 0.5 * box.width, y = 0.5 * box.height - (clientY - box.top);
    const shift = this.metresPerPixel() * (1 - factor);
    this.target.addScaledVector(this.right(), x * shift).addScaledVector(this.up(), y * shift);
    this.distance *= factor;
    this.update();
  }

  /** The pixel of a point, from the upper left corner of the picture. */
  project(point) {
    const at = point.clone().project(this.camera);
    return {x: 0.5 * (1 + at.x) * this.width, y: 0.5 * (1 - at.y) * this.height};
  }
}
