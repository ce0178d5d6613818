// SPDX-License-Identifier: Apache-2.0
"use strict";

/** Wipes, flips or sets side by side any two pictures or error maps of a scene. */
class Viewer {
  constructor(root, scene) {
    this.scene = scene;
    this.view = new View(scene.width, scene.height);
    this.state = { layer: scene.layers[0].id, a: "truth", b: scene.best, mode: "wipe", stops: 0, wipe: 0.5, flipped: false };
    this.cursor = [Math.floor(scene.width / 2), Math.floor(scene.height / 2)];
    this.unpacked = new Map();
    this.drawn = new Map();
    this.build(root);
    this.listen();
    this.reload();
  }

  sources() {
    const { pictures } = this.scene;
    const tests = pictures.filter(({ id }) => id !== "truth");
    return [
      ...pictures.map(({ id, title }) => ({ id, title })),
      ...tests.map(({ id, title }) => ({ id: `signed ${id}`, title: `signed error: ${title}` })),
      ...tests.map(({ id, title }) => ({ id: `absolute ${id}`, title: `absolute error: ${title}` })),
    ];
  }

  build(root) {
    const { state } = this;
    const layer = makeSelect("Layer", this.scene.layers, state.layer);
    const a = makeSelect("A", this.sources(), state.a);
    const b = makeSelect("B", this.sources(), state.b);
    for (const [key, { select }] of Object.entries({ layer, a, b }))
      select.addEventListener("change", () => { state[key] = select.value; this.reload(); });
    this.mode = makeChoice("Compare by", [["wipe", "Wipe"], ["flip", "Flip"], ["side", "Side by side"]], state.mode,
      (id) => { state.mode = id; this.draw(); });
    this.exposure = makeRange("Exposure", { min: -10, max: 10, step: 0.1, value: 0 });
    this.exposure.input.addEventListener("input", () => this.expose(Number(this.exposure.input.value)));
    const zoom = make("fieldset", {}, make("legend", { textContent: "Zoom" }),
      makeButton("−", "Zoom out", () => this.zoom(0.5)), makeButton("+", "Zoom in", () => this.zoom(2)),
      makeButton("Reset", "Reset zoom and exposure", () => this.reset()));
    this.canvas = make("canvas", { tabIndex: 0, attributes: { role: "application",
      "aria-label": `Pictures of ${this.scene.name}; arrows move the pixel cursor, plus and minus zoom` } });
    this.nameA = make("output", { className: "name-a" });
    this.nameB = make("output", { className: "name-b" });
    this.wipe = makeRange("Wipe", { min: 0, max: 1, step: 0.002, value: state.wipe });
    this.wipe.input.addEventListener("input", () => { state.wipe = Number(this.wipe.input.value); this.draw(); });
    this.inspector = makeInspector();
    this.bars = make("div", { className: "bars" });
    this.message = make("p", { className: "warning", hidden: true });
    const keys = make("p", { className: "keys" });
    keys.innerHTML = "On the picture: drag or <kbd>Shift</kbd> arrows pan, wheel or <kbd>+</kbd> <kbd>−</kbd> zoom, arrows move the pixel cursor, " +
      "<kbd>F</kbd> flips, <kbd>W</kbd> wipes, <kbd>S</kbd> sets side by side, <kbd>,</kbd> <kbd>.</kbd> move the wipe, <kbd>[</kbd> <kbd>]</kbd> change the exposure, <kbd>0</kbd> resets.";
    root.replaceChildren(
      make("div", { className: "controls" }, layer.field, a.field, b.field, this.mode.field, this.exposure.field, zoom),
      this.message, make("div", { className: "stage" }, this.canvas, this.nameA, this.nameB), this.wipe.field,
      make("div", { className: "under" }, this.inspector.table, this.bars), keys);
  }

  /** The planes of a picture's layer, unpacked once. */
  planes(id) {
    const { layer } = this.state;
    const key = `${layer} ${id}`;
    if (!this.unpacked.has(key)) {
      const picture = this.scene.pictures.find((candidate) => candidate.id === id);
      this.unpacked.set(key, unpackLayer(picture.layers[layer]));
    }
    return this.unpacked.get(key);
  }

  /** What the selects ask for, ready to be shown; error maps are made against the truth. */
  async source(id) {
    const { title } = this.sources().find((candidate) => candidate.id === id);
    const [kind, model] = id.includes(" ") ? id.split(" ") : ["picture", id];
    return { id, title, kind, planes: await this.planes(model), truth: await this.planes("truth") };
  }

  async reload() {
    const wanted = JSON.stringify([this.state.layer, this.state.a, this.state.b]);
    try {
      const { noise } = this.scene;
      this.unpacked.set("noise", this.unpacked.get("noise") ?? {});
      const noises = this.unpacked.get("noise");
      const { layer } = this.state;
      if (noise[layer]) noises[layer] ??= unpackLayer(noise[layer]);
      const loaded = await Promise.all([this.source(this.state.a), this.source(this.state.b), noises[layer]]);
      if (wanted !== JSON.stringify([this.state.layer, this.state.a, this.state.b])) return;
      [this.a, this.b, this.noise] = loaded;
      this.drawn.clear();
      this.draw();
    } catch (error) {
      this.message.hidden = false;
      this.message.textContent = `This browser cannot unpack the pictures (${error.message}); the still pictures above are the same.`;
    }
  }

  /** The range of an error map's scale: the still maps' range, narrowed by the exposure. */
  range() { return this.scene.error_range[this.state.layer] / 2 ** this.state.stops; }

  /** A source as a canvas at the exposure of the moment. */
  picture(source) {
    const key = `${source.id} ${this.state.stops}`;
    if (this.drawn.has(key)) return this.drawn.get(key);
    const { width, height, exposure } = this.scene;
    const canvas = make("canvas", { width, height });
    const context = canvas.getContext("2d");
    const image = context.createImageData(width, height);
    if (source.kind === "picture") showPicture(source.planes, exposure + this.state.stops, image.data);
    else showError(source.kind, source.truth, source.planes, this.range(), image.data);
    context.putImageData(image, 0, 0);
    this.drawn.set(key, canvas);
    return canvas;
  }

  panes() {
    const { width, height } = this.canvas;
    const whole = { left: 0, top: 0, width, height };
    if (this.state.mode !== "side") return [whole, whole];
    return [{ ...whole, width: width / 2 - 1 }, { ...whole, left: width / 2 + 1, width: width / 2 - 1 }];
  }

  draw() {
    if (!this.a) return;
    const { state, canvas, view } = this;
    const ratio = devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round((width * view.height / view.width) / (state.mode === "side" ? 2 : 1));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    context.fillStyle = "#000";
    context.fillRect(0, 0, width, height);
    const [paneA, paneB] = this.panes();
    if (state.mode === "flip") {
      drawPane(context, paneA, paneA, this.picture(state.flipped ? this.b : this.a), view);
    } else if (state.mode === "side") {
      drawPane(context, paneA, paneA, this.picture(this.a), view);
      drawPane(context, paneB, paneB, this.picture(this.b), view);
      drawCursor(context, paneB, view, this.cursor);
    } else {
      const at = Math.round(state.wipe * width);
      drawPane(context, paneA, { ...paneA, width: at }, this.picture(this.a), view);
      drawPane(context, paneB, { ...paneB, left: at, width: width - at }, this.picture(this.b), view);
      context.fillStyle = "#fff";
      context.fillRect(at - ratio, 0, 2 * ratio, height);
    }
    drawCursor(context, paneA, view, this.cursor);
    this.describe();
  }

  describe() {
    const { state } = this;
    this.nameA.textContent = state.mode === "flip" ? (state.flipped ? `B: ${this.b.title}` : `A: ${this.a.title}`) : `A: ${this.a.title}`;
    this.nameB.hidden = state.mode === "flip";
    this.nameB.textContent = `B: ${this.b.title}`;
    this.wipe.field.hidden = state.mode !== "wipe";
    this.exposure.text.textContent = `${state.stops >= 0 ? "+" : ""}${state.stops.toFixed(1)} stops`;
    const [x, y] = this.cursor;
    this.inspector.show(x, y, inspectorRows(this.a, this.b, this.noise, y * this.view.width + x, this.view.width * this.view.height));
    const kinds = new Set([this.a, this.b].map(({ kind }) => kind).filter((kind) => kind !== "picture"));
    this.bars.replaceChildren(...[...kinds].map((kind) => this.scaleBar(kind)));
  }

  scaleBar(kind) {
    const map = colorMaps[kind];
    const count = map.length / 3;
    const bar = make("canvas", { width: count, height: 1 });
    const context = bar.getContext("2d");
    const image = context.createImageData(count, 1);
    for (let i = 0; i < count; ++i) image.data.set([map[3 * i], map[3 * i + 1], map[3 * i + 2], 255], 4 * i);
    context.putImageData(image, 0, 0);
    const range = this.range();
    const ticks = kind === "signed" ? [-range, 0, range] : [0, range / 2, range];
    return make("div", {}, `${kind} error, mean of channels`, bar,
      make("div", { className: "ticks" }, ...ticks.map((tick) => make("span", { textContent: showNumber(tick) }))));
  }

  expose(stops) {
    this.state.stops = Math.min(10, Math.max(-10, Math.round(stops * 10) / 10));
    this.exposure.input.value = this.state.stops;
    this.drawn.clear();
    this.draw();
  }

  zoom(amount, at = this.cursor) { this.view.zoomAt(amount, ...at); this.draw(); }

  reset() { this.view.fit(); this.expose(0); }

  moveWipe(to) {
    this.state.wipe = Math.min(1, Math.max(0, to));
    this.wipe.input.value = this.state.wipe;
    this.draw();
  }

  moveCursor(x, y) {
    this.cursor = [Math.min(this.view.width - 1, Math.max(0, Math.floor(x))), Math.min(this.view.height - 1, Math.max(0, Math.floor(y)))];
    this.draw();
  }
}
