"use strict";

/** Joins the elements of the page to the viewer, in both directions. */
class Controls {
  constructor(viewer) {
    this.viewer = viewer;
    this.joinColours();
    this.joinLayers();
    this.joinSection();
    this.joinPicture();
    this.joinCharts();
    this.joinPlayer();
    document.addEventListener("keydown", (event) => this.press(event));
  }

  joinColours() {
    const {viewer} = this;
    fillOptions(element("field"), viewer.fields.map((field) => field.name));
    fillOptions(element("map"), Object.keys(colourMaps));
    element("field").addEventListener("change", ({target}) => viewer.setField(viewer.fields[target.selectedIndex]));
    element("map").addEventListener("change", ({target}) => viewer.setMap(target.value));
    for (const id of ["low", "high"]) {
      element(id).addEventListener("change", () => {
        const values = ["low", "high"].map((end) => Number(element(end).value.replace("−", "-")) * this.unit.factor);
        if (values.every(Number.isFinite) && values[0] < values[1]) viewer.range = values;
        viewer.applyColours();
        this.showColours();
      });
    }
    element("range-run").addEventListener("click", async () => {
      await viewer.setRangeOfRun();
      this.showColours();
    });
    element("range-frame").addEventListener("click", async () => {
      await viewer.setRangeOfFrame();
      this.showColours();
    });
    element("log").addEventListener("change", ({target}) => {
      viewer.setLog(target.checked);
      this.showColours();
    });
  }

  showColours() {
    const {field, range, isLog, map} = this.viewer;
    this.unit = scaledUnit(field.unit, Math.max(...range.map(Math.abs)));
    element("field").selectedIndex = this.viewer.fields.indexOf(field);
    element("map").value = map;
    element("log").checked = isLog;
    element("low").value = shortNumber(range[0] / this.unit.factor);
    element("high").value = shortNumber(range[1] / this.unit.factor);
    document.querySelector(".only-scalar").hidden = field.categories !== null;
  }

  joinLayers() {
    const {viewer} = this, {layers, recording} = viewer, available = layers.available();
    const kinds = {
      forces: ["Force chains", "compression"], points: ["Contact points", "point"], bolts: ["Bolts", "bolt"],
      joints: ["Open joints", "joint"], cracks: ["Cracks", "tensileCrack"], water: ["Water table", "water"],
    };
    for (const name of available) {
      const [text, colour] = kinds[name], label = document.createElement("label");
      label.className = "check";
      label.innerHTML = `<input type="checkbox"><i class="swatch"></i><span>${text}</span>`;
      label.querySelector("i").style.background = `rgb(${layerColours[colour].map((c) => Math.round(255 * c))})`;
      const box = label.querySelector("input");
      box.id = `layer-${name}`;
      box.checked = layers.isShown[name];
      box.addEventListener("change", () => viewer.setLayer(name, box.checked));
      element("layers").append(label);
    }
    element("force-row").hidden = !available.includes("forces");
    element("force-scale").addEventListener("input", ({target}) => {
      layers.forceScale = 10 ** Number(target.value);
      viewer.update();
    });
    if (recording.left_out_contacts > 0) {
      element("left-out").textContent = "Of each frame the largest contact forces are here; "
        + `up to ${recording.left_out_contacts} smaller ones are left out.`;
    }
    element("opacity").addEventListener("input", ({target}) => viewer.setOpacity(Number(target.value)));
    element("edges").addEventListener("input", ({target}) => {
      viewer.picture.blockMesh.uniforms.edgeOpacity.value = Number(target.value);
      viewer.redraw();
    });
  }

  showLayer(name, isShown) {
    element(`layer-${name}`).checked = isShown;
  }

  showOpacity(opacity) {
    element("opacity").value = opacity;
  }

  joinSection() {
    const buttons = [...element("section-axis").children];
    let axis = -1, isFlipped = false;
    const apply = () => this.viewer.setSection(axis, Number(element("section-place").value), isFlipped);
    for (const button of buttons) {
      button.addEventListener("click", () => {
        axis = Number(button.dataset.axis);
        buttons.forEach((other) => other.classList.toggle("on", other === button));
        apply();
      });
    }
    element("section-place").addEventListener("input", apply);
    element("section-flip").addEventListener("click", ({target}) => {
      isFlipped = !isFlipped;
      target.classList.toggle("on", isFlipped);
      apply();
    });
  }

  joinPicture() {
    const {viewer} = this, {control} = viewer.picture, canvas = element("picture");
    this.views = {
      fit: () => control.fit(control.box), x: () => control.look(Math.PI / 2, 0), y: () => control.look(0, 0),
      z: () => control.look(0, 1.55),
    };
    for (const button of document.querySelectorAll("[data-view]"))
      button.addEventListener("click", () => this.views[button.dataset.view]());
    element("save").addEventListener("click", () => viewer.savePicture());
    element("theme").addEventListener("click", () => this.switchTheme());
    element("panel").hidden = window.matchMedia("(max-width: 760px)").matches;
    element("panel-toggle").addEventListener("click", () => {
      element("panel").hidden = !element("panel").hidden;
      for (const chart of this.charts) chart.draw();
    });
    let pressed = null;
    canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointerup", (event) => {
      if (!pressed || event.button !== 0) return;
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
      const box = canvas.getBoundingClientRect();
      viewer.select(viewer.blockAt(event.clientX - box.left, event.clientY - box.top));
    });
    const isDark = window.matchMedia("(prefers-color-scheme: dark)").matches;
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
  }

  switchTheme() {
    const {dataset} = document.documentElement;
    dataset.theme = dataset.theme === "dark" ? "light" : "dark";
    for (const chart of this.charts) chart.draw();
    this.viewer.update();
  }

  joinCharts() {
    const {viewer} = this, {history} = viewer, seek = (time) => viewer.goToTime(time);
    this.charts = [];
    const energies = history ? history.energies() : [];
    element("energy-section").hidden = energies.length === 0;
    element("history-section").hidden = !history || history.others().length === 0;
    if (energies.length > 0) {
      const chart = new Chart(element("energy-chart"), seek);
      chart.setSeries(energies.map((name) => history.series(name)), "J");
      this.charts.push(chart);
      element("energy-legend").append(...chart.series.map((series, index) => legendEntry(chart, series, index)));
    }
    if (!history) return;
    const columns = history.others(), chart = new Chart(element("history-chart"), seek);
    fillOptions(element("history-column"), columns);
    const show = () => chart.setSeries([history.series(element("history-column").value)], "");
    element("history-column").addEventListener("change", show);
    if (columns.includes("largest_speed")) element("history-column").value = "largest_speed";
    if (columns.length > 0) show();
    this.charts.push(chart);
  }

  joinPlayer() {
    const {player} = this.viewer;
    element("timeline").max = player.frameCount - 1;
    element("timeline").addEventListener("input", ({target}) => player.goTo(Number(target.value)));
    element("play").addEventListener("click", () => this.togglePlaying());
    element("back").addEventListener("click", () => player.goTo(player.number - 1));
    element("forth").addEventListener("click", () => player.goTo(player.number + 1));
    element("rate").addEventListener("change", ({target}) => player.setRate(Number(target.value)));
    element("repeat").addEventListener("click", () => {
      player.repeats = !player.repeats;
      element("repeat").classList.toggle("on", player.repeats);
    });
    player.onStop = () => this.showPlaying();
  }

  togglePlaying() {
    const {player} = this.viewer;
    if (player.isPlaying) player.pause();
    else player.play();
    this.showPlaying();
  }

  showPlaying() {
    const {isPlaying} = this.viewer.player;
    element("play").textContent = isPlaying ? "❚❚" : "▶";
    element("play").setAttribute("aria-label", isPlaying ? "Pause" : "Play");
  }

  showFrame(frame) {
    const {times} = this.viewer.recording;
    element("timeline").value = frame.number;
    element("time").textContent = `${shortNumber(frame.time)} s · ${frame.number + 1} / ${times.length}`;
    for (const chart of this.charts) chart.setTime(frame.time);
  }

  press(event) {
    if (["INPUT", "SELECT"].includes(event.target.tagName) && event.target.type !== "range") return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const {viewer} = this, {player} = viewer;
    const actions = {
      " ": () => this.togglePlaying(), ArrowLeft: () => player.goTo(player.number - 1),
      ArrowRight: () => player.goTo(player.number + 1), Home: () => player.goTo(0),
      End: () => player.goTo(player.frameCount - 1), Escape: () => viewer.select(-1), f: this.views.fit,
      s: () => viewer.savePicture(), d: () => this.switchTheme(), p: () => element("panel-toggle").click(),
      r: () => element("repeat").click(),
      ...(viewer.recording.dimension === 3 ? {1: this.views.x, 2: this.views.y, 3: this.views.z} : {}),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

function fillOptions(select, names) {
  select.replaceChildren(...names.map((name) => new Option(name)));
}
