// SPDX-License-Identifier: Apache-2.0
"use strict";

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** How near the wipe's line a press takes hold of it, in CSS pixels. */
const wipeReach = 8;

const keyActions = {
  "+": (viewer) => viewer.zoom(1.5),
  "=": (viewer) => viewer.zoom(1.5),
  "-": (viewer) => viewer.zoom(1 / 1.5),
  0: (viewer) => viewer.reset(),
  "[": (viewer) => viewer.expose(viewer.state.stops - 0.5),
  "]": (viewer) => viewer.expose(viewer.state.stops + 0.5),
  ",": (viewer) => viewer.moveWipe(viewer.state.wipe - 0.02),
  ".": (viewer) => viewer.moveWipe(viewer.state.wipe + 0.02),
  w: (viewer) => viewer.mode.pick("wipe"),
  s: (viewer) => viewer.mode.pick("side"),
  f: (viewer) => {
    if (viewer.state.mode === "flip") viewer.state.flipped = !viewer.state.flipped;
    viewer.mode.pick("flip");
  },
};

function pressKey(viewer, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = arrows[event.key];
  if (arrow && event.shiftKey) {
    const step = viewer.view.width / (10 * viewer.view.zoom);
    viewer.view.panBy(arrow[0] * step, arrow[1] * step);
    viewer.draw();
  } else if (arrow) {
    viewer.moveCursor(viewer.cursor[0] + arrow[0], viewer.cursor[1] + arrow[1]);
  } else if (keyActions[event.key.toLowerCase()]) {
    keyActions[event.key.toLowerCase()](viewer);
  } else {
    return;
  }
  event.preventDefault();
}

/** The pane and the picture's point under a pointer. */
function pointUnder(viewer, event) {
  const box = viewer.canvas.getBoundingClientRect();
  const ratio = viewer.canvas.width / box.width;
  const sx = (event.clientX - box.left) * ratio;
  const sy = (event.clientY - box.top) * ratio;
  const panes = viewer.panes();
  const pane = sx >= panes[1].left ? panes[1] : panes[0];
  return { sx, ratio, pane, point: viewer.view.toPicture(pane, sx, sy) };
}

Viewer.prototype.listen = function listen() {
  const { canvas } = this;
  let drag = null;
  canvas.addEventListener("keydown", (event) => pressKey(this, event));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    this.zoom(2 ** (-event.deltaY / 300), pointUnder(this, event).point);
  }, { passive: false });
  canvas.addEventListener("pointerdown", (event) => {
    const { sx, ratio, point } = pointUnder(this, event);
    const onLine = this.state.mode === "wipe" && Math.abs(sx - this.state.wipe * canvas.width) < wipeReach * ratio;
    drag = { wipe: onLine, x: event.clientX, y: event.clientY };
    canvas.setPointerCapture(event.pointerId);
    if (!onLine) this.moveCursor(...point);
  });
  canvas.addEventListener("pointermove", (event) => {
    const { sx, ratio, pane, point } = pointUnder(this, event);
    if (!drag) return this.moveCursor(...point);
    if (drag.wipe) return this.moveWipe(sx / canvas.width);
    const s = this.view.scale(pane) / ratio;
    this.view.panBy((drag.x - event.clientX) / s, (drag.y - event.clientY) / s);
    Object.assign(drag, { x: event.clientX, y: event.clientY });
    this.draw();
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (drag = null));
  new ResizeObserver(() => this.draw()).observe(canvas);
};

for (const root of document.querySelectorAll(".viewer"))
  root.viewer = new Viewer(root, report.scenes[Number(root.dataset.scene)]);
