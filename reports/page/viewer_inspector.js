// SPDX-License-Identifier: Apache-2.0
"use strict";

function showNumber(value) {
  if (!Number.isFinite(value)) return String(value);
  return value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(2) : value.toPrecision(4);
}

/** The table of values under the cursor. */
function makeInspector() {
  const body = make("tbody");
  const caption = make("caption");
  const head = make("thead", {}, make("tr", {}, ...["", "R", "G", "B"].map((c) =>
    make("th", { textContent: c, attributes: { scope: "col" } }))));
  const table = make("table", {}, caption, head, body);
  const show = (x, y, rows) => {
    caption.textContent = `Pixel ${x}, ${y}`;
    body.replaceChildren(...rows.map(([name, values]) => make("tr", {},
      make("th", { textContent: name, attributes: { scope: "row" } }),
      ...values.map((value) => make("td", { textContent: typeof value === "string" ? value : showNumber(value) })))));
  };
  return { table, show };
}

/** Rows of the inspector at pixel i of n: both values, their difference, the truth's noise. */
function inspectorRows(a, b, noise, i, n) {
  const at = (planes) => [0, 1, 2].map((c) => planes[c * n + i]);
  const valuesA = at(a.planes);
  const valuesB = at(b.planes);
  const rows = [[`A: ${a.title}`, valuesA], [`B: ${b.title}`, valuesB],
    ["B − A", valuesB.map((value, c) => value - valuesA[c])]];
  if (noise) {
    const sigma = at(noise);
    rows.push(["truth's standard error", sigma]);
    rows.push(["(B − A) / standard error", valuesB.map((value, c) => {
      const z = (value - valuesA[c]) / sigma[c];
      return Number.isFinite(z) ? z.toFixed(1) : "–";
    })]);
  }
  return rows;
}
