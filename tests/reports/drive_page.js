// SPDX-License-Identifier: Apache-2.0
// Runs inside the page, works every control, and tells the page around it what it saw.
"use strict";

addEventListener("load", async () => {
  const seen = {};
  const viewer = document.querySelector(".viewer").viewer;
  const { canvas } = viewer;
  const settled = async () => {
    await viewer.reload();
    viewer.draw();
  };
  const pixels = () => canvas.toDataURL();
  const key = (name, shiftKey = false) =>
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: name, shiftKey, cancelable: true }));
  /** Whether doing this changes what the canvas shows. */
  const changes = async (act) => {
    const before = pixels();
    await act();
    return pixels() !== before;
  };
  const choose = async (label, value) => {
    const field = [...document.querySelectorAll(".controls label")].find((one) => one.textContent.startsWith(label));
    const select = field.querySelector("select");
    select.value = value;
    select.dispatchEvent(new Event("change"));
    await settled();
  };
  const press = (text) => [...document.querySelectorAll(".controls button")].find((one) => one.textContent === text).click();

  await settled();
  seen.caption = document.querySelector(".under caption").textContent;
  seen.values = [...document.querySelectorAll(".under tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent));
  seen.exposure = await changes(() => key("]"));
  seen.exposure_text = viewer.exposure.text.textContent;
  seen.reset = await changes(() => key("0"));
  seen.zoom = await changes(() => press("+"));
  seen.pan = await changes(() => key("ArrowRight", true));
  press("Reset");
  seen.cursor = (key("ArrowRight"), key("ArrowDown"), document.querySelector(".under caption").textContent);
  seen.wipe = await changes(() => key("."));
  seen.flip = await changes(() => { press("Flip"); key("f"); });
  seen.flip_name = document.querySelector(".name-a").textContent;
  seen.side = await changes(() => press("Side by side"));
  press("Wipe");
  seen.layer = await changes(() => choose("Layer", "indirect"));
  seen.map = await changes(() => choose("B", "signed thesis"));
  seen.bars = [...document.querySelectorAll(".bars .ticks span")].map((tick) => tick.textContent);

  const table = [...document.querySelectorAll("table.sortable")].find((one) => one.caption?.textContent === "Indirect light");
  const first = () => table.tBodies[0].rows[0].cells[0].textContent;
  table.tHead.rows[0].cells[2].querySelector("button").click();
  seen.least_ratio = first();
  table.tHead.rows[0].cells[2].querySelector("button").click();
  seen.sorted = table.tHead.rows[0].cells[2].getAttribute("aria-sort");

  const paper = () => getComputedStyle(document.body).backgroundColor;
  const before = paper();
  document.getElementById("theme").click();
  seen.theme = paper() !== before;
  seen.charts = [...document.querySelectorAll("canvas[data-chart]")].map((chart) => Chart.getChart(chart).data.datasets.length);
  const studies = [...document.querySelectorAll("canvas[data-study]")].map((canvas) => ({ canvas, chart: Chart.getChart(canvas) }));
  seen.studies = studies.map(({ chart }) => chart.data.datasets.map(({ label, data }) => [label, data.length]));
  const { canvas: drawn, chart } = studies[1];
  const point = chart.getDatasetMeta(0).data[1];
  const box = drawn.getBoundingClientRect();
  drawn.dispatchEvent(new MouseEvent("mousemove", { clientX: box.left + point.x, clientY: box.top + point.y, bubbles: true }));
  await new Promise((done) => setTimeout(done, 200));
  seen.hover = (chart.tooltip?.body ?? []).map(({ lines }) => lines[0]);
  seen.wide = document.documentElement.scrollWidth > document.documentElement.clientWidth;

  parent.postMessage(JSON.stringify(seen), "*");
});
