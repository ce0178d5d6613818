// SPDX-License-Identifier: Apache-2.0
"use strict";

const largestZoom = 64;

/** Which part of a picture a pane shows: `zoom` 1 fits it; (x, y) is the middle, in pixels. */
class View {
  constructor(width, height) {
    Object.assign(this, { width, height, zoom: 1, x: width / 2, y: height / 2 });
  }

  /** Screen pixels per picture pixel in a pane. */
  scale(pane) { return this.zoom * Math.min(pane.width / this.width, pane.height / this.height); }

  toPicture(pane, sx, sy) {
    const s = this.scale(pane);
    return [this.x + (sx - pane.left - pane.width / 2) / s, this.y + (sy - pane.top - pane.height / 2) / s];
  }

  toScreen(pane, x, y) {
    const s = this.scale(pane);
    return [pane.left + pane.width / 2 + (x - this.x) * s, pane.top + pane.height / 2 + (y - this.y) * s];
  }

  fit() { Object.assign(this, { zoom: 1, x: this.width / 2, y: this.height / 2 }); }

  panBy(dx, dy) {
    this.x = Math.min(this.width, Math.max(0, this.x + dx));
    this.y = Math.min(this.height, Math.max(0, this.y + dy));
  }

  /** Zooms so that the picture's point (x, y) stays where it is on the screen. */
  zoomAt(amount, x, y) {
    const zoom = Math.min(largestZoom, Math.max(1, this.zoom * amount));
    if (zoom === 1) return this.fit();
    const part = 1 - this.zoom / zoom;
    this.zoom = zoom;
    this.panBy((x - this.x) * part, (y - this.y) * part);
  }
}

function drawPane(context, pane, clip, picture, view) {
  context.save();
  context.beginPath();
  context.rect(clip.left, clip.top, clip.width, clip.height);
  context.clip();
  const s = view.scale(pane);
  const [left, top] = view.toScreen(pane, 0, 0);
  context.imageSmoothingEnabled = s < 1;
  context.drawImage(picture, left, top, view.width * s, view.height * s);
  context.restore();
}

/** Marks the pixel under the cursor, visible on any ground. */
function drawCursor(context, pane, view, [x, y]) {
  const s = view.scale(pane);
  const [left, top] = view.toScreen(pane, x, y);
  const size = Math.max(s, 5);
  context.lineWidth = 3;
  context.strokeStyle = "#000";
  context.strokeRect(left + s / 2 - size / 2, top + s / 2 - size / 2, size, size);
  context.lineWidth = 1;
  context.strokeStyle = "#fff";
  context.strokeRect(left + s / 2 - size / 2, top + s / 2 - size / 2, size, size);
}
