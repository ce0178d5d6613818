// SPDX-License-Identifier: Apache-2.0
"use strict";

function seconds(value) {
  return value < 1 ? `${(value * 1e3).toPrecision(3)} ms` : `${value.toPrecision(3)} s`;
}

/** A logarithmic axis for these values, with a little room on both sides. */
function logarithmic(title, color, format, values) {
  const shown = values.filter((value) => value > 0);
  return {
    type: "logarithmic",
    min: Math.min(...shown) / 1.5,
    max: Math.max(...shown) * 1.5,
    title: { display: true, text: title, color },
    ticks: { color, maxTicksLimit: 8, callback: (value) => (/^[125]e/.test((+value).toExponential()) ? format(value) : null) },
    grid: { color: themeColor("line") },
  };
}

function frontierData(scene) {
  const line = {
    label: "path tracer", data: scene.frontier.path_tracer, showLine: true, borderColor: themeColor("path"),
    backgroundColor: themeColor("path"), borderWidth: 2, pointRadius: 4,
  };
  const models = scene.frontier.models.map(({ title, color, points }) => ({
    label: title, data: points, borderColor: themeColor(color), borderWidth: 2,
    backgroundColor: themeColor(color), pointRadius: 7, pointHoverRadius: 9, showLine: true, borderDash: [2, 4],
    pointBackgroundColor: points.map(({ hollow }) => (hollow ? themeColor("paper") : themeColor(color))),
  }));
  const all = [...scene.frontier.path_tracer, ...scene.frontier.models.flatMap(({ points }) => points)];
  const xs = all.map(({ x }) => x);
  const floor = {
    label: "noise of the truth", showLine: true, pointRadius: 0, borderDash: [8, 5], borderWidth: 1.5,
    borderColor: themeColor("truth"), backgroundColor: themeColor("truth"),
    data: [Math.min(...xs), Math.max(...xs)].map((x) => ({ x, y: scene.frontier.noise_floor })),
  };
  return { datasets: scene.frontier.noise_floor > 0 ? [line, ...models, floor] : [line, ...models] };
}

function frontierChart(canvas, scene) {
  const ink = themeColor("ink");
  const points = [...scene.frontier.path_tracer, ...scene.frontier.models.flatMap((model) => model.points)];
  const floor = { y: scene.frontier.noise_floor };
  return new Chart(canvas, {
    type: "scatter",
    data: frontierData(scene),
    options: {
      animation: false, maintainAspectRatio: false,
      scales: {
        x: logarithmic("seconds", ink, seconds, points.map(({ x }) => x)),
        y: logarithmic("RMSE, indirect", ink, String, [...points, floor].map(({ y }) => y)),
      },
      plugins: {
        legend: { labels: { color: ink, usePointStyle: true } },
        tooltip: { callbacks: { label: ({ dataset, raw }) =>
          `${dataset.label}${raw.note ? `, ${raw.note}` : ""}: RMSE ${raw.y.toPrecision(3)} in ${seconds(raw.x)}` } },
      },
    },
  });
}

/** Draws each bar's interval, `low` to `high`, as a whisker. */
const whiskers = {
  id: "whiskers",
  afterDatasetsDraw(chart) {
    const { ctx, data, scales } = chart;
    ctx.save();
    ctx.strokeStyle = themeColor("ink");
    ctx.lineWidth = 1.5;
    data.datasets.forEach(({ intervals = [] }, index) => chart.getDatasetMeta(index).data.forEach((bar, i) => {
      if (!intervals[i]) return;
      const [low, high] = intervals[i].map((value) => scales.x.getPixelForValue(Math.max(value, scales.x.min)));
      ctx.beginPath();
      ctx.moveTo(low, bar.y);
      ctx.lineTo(high, bar.y);
      for (const x of [low, high]) { ctx.moveTo(x, bar.y - 4); ctx.lineTo(x, bar.y + 4); }
      ctx.stroke();
    }));
    ctx.restore();
  },
};

function splitChart(canvas, scene) {
  const ink = themeColor("ink");
  const rows = scene.split;
  return new Chart(canvas, {
    type: "bar",
    data: {
      labels: rows.map(({ title }) => title),
      datasets: [
        { label: "bias", data: rows.map(({ bias }) => bias), intervals: rows.map(({ interval }) => interval), backgroundColor: themeColor("bias") },
        { label: "noise", data: rows.map(({ noise }) => noise), backgroundColor: themeColor("noise") },
      ],
    },
    plugins: [whiskers],
    options: {
      indexAxis: "y", animation: false, maintainAspectRatio: false,
      scales: { x: logarithmic("root mean square, indirect", ink, String, rows.flatMap(({ bias, noise }) => [bias, noise])), y: { ticks: { color: ink }, grid: { display: false } } },
      plugins: {
        legend: { labels: { color: ink } },
        tooltip: { callbacks: { label: ({ dataset, raw, dataIndex }) => {
          const interval = dataset.intervals?.[dataIndex];
          return `${dataset.label}: ${raw.toPrecision(3)}${interval ? `, 95 % within ${interval.map((v) => v.toPrecision(3)).join(" to ")}` : ""}`;
        } } },
      },
    },
  });
}

const chartKinds = { frontier: frontierChart, split: splitChart };

for (const canvas of document.querySelectorAll("canvas[data-chart]")) {
  const scene = report.scenes[Number(canvas.dataset.scene)];
  let chart = chartKinds[canvas.dataset.chart](canvas, scene);
  onThemeChange.push(() => {
    chart.destroy();
    chart = chartKinds[canvas.dataset.chart](canvas, scene);
  });
}
