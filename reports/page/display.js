// SPDX-License-Identifier: Apache-2.0
"use strict";

/** sRGB bytes [IEC 61966-2-1] of linear values i / 4095. */
const srgbTable = Uint8ClampedArray.from({ length: 4096 }, (_, i) => {
  const x = i / 4095;
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055) + 0.5;
});

function srgbByte(linear) {
  return srgbTable[Math.min(4095, Math.max(0, Math.round(linear * 4095) || 0))];
}

/** Linear RGB planes as display pixels, brightened by 2^stops. */
function showPicture(planes, stops, pixels) {
  const n = pixels.length / 4;
  const gain = 2 ** stops;
  for (let i = 0; i < n; ++i) {
    pixels[4 * i] = srgbByte(gain * planes[i]);
    pixels[4 * i + 1] = srgbByte(gain * planes[n + i]);
    pixels[4 * i + 2] = srgbByte(gain * planes[2 * n + i]);
    pixels[4 * i + 3] = 255;
  }
}

const colorMaps = Object.fromEntries(
  Object.entries(report.color_maps).map(([name, text]) => [name, bytesFromBase64(text)]));

/** The error at pixel i, the mean over channels of test - truth, or of its magnitude. */
function pixelError(kind, truth, test, i, n) {
  const d = [0, 1, 2].map((c) => test[c * n + i] - truth[c * n + i]);
  return kind === "signed" ? (d[0] + d[1] + d[2]) / 3
    : (Math.abs(d[0]) + Math.abs(d[1]) + Math.abs(d[2])) / 3;
}

/** Where an error lies on its colour map, from 0 to 1, when the map's end stands for `range`. */
function mapPosition(kind, error, range) {
  return kind === "signed" ? 0.5 + 0.5 * error / range : error / range;
}

/** An error map in false colours; magenta marks what is not finite. */
function showError(kind, truth, test, range, pixels) {
  const n = pixels.length / 4;
  const map = colorMaps[kind];
  const last = map.length / 3 - 1;
  for (let i = 0; i < n; ++i) {
    const at = mapPosition(kind, pixelError(kind, truth, test, i, n), range);
    const k = 3 * Math.round(last * Math.min(1, Math.max(0, at)));
    const finite = Number.isFinite(at);
    pixels[4 * i] = finite ? map[k] : 255;
    pixels[4 * i + 1] = finite ? map[k + 1] : 0;
    pixels[4 * i + 2] = finite ? map[k + 2] : 255;
    pixels[4 * i + 3] = 255;
  }
}
