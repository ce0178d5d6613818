// SPDX-License-Identifier: Apache-2.0
"use strict";

/** Dashed vertical lines at the chart's marks: where an animation begins and ends. */
const marksPlugin = {
  id: "marks",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea, scales } = chart;
    ctx.save();
    ctx.strokeStyle = themeColor("quiet");
    ctx.setLineDash([6, 4]);
    for (const mark of chart.options.plugins.marks.at ?? []) {
      const x = scales.x.getPixelForValue(mark);
      ctx.beginPath();
      ctx.moveTo(x, chartArea.top);
      ctx.lineTo(x, chartArea.bottom);
      ctx.stroke();
    }
    ctx.restore();
  },
};

function axis(title, logarithmic, fromZero) {
  const color = themeColor("ink");
  return {
    type: logarithmic ? "logarithmic" : "linear",
    beginAtZero: fromZero,
    title: { display: title !== "", text: title, color },
    ticks: { color, maxTicksLimit: 9, callback: (value) => (!logarithmic || /^[125]e/.test((+value).toExponential()) ? String(+Number(value).toPrecision(3)) : null) },
    grid: { color: themeColor("line") },
  };
}

function lineSet({ label, color, x, y, dashed, dots, line, names }) {
  return {
    label, showLine: line, borderColor: themeColor(color), backgroundColor: themeColor(color),
    borderWidth: 1.5, borderDash: dashed ? [5, 4] : [], pointRadius: dots ? 4 : 0, pointHitRadius: 6,
    data: x.map((value, i) => ({ x: value, y: y[i], name: names[i] })).filter(({ x, y }) => x !== null && y !== null),
  };
}

/** Whether the legend names a series: a dashed companion of a line of its colour, the caption does. */
function inLegend({ dashed, color }, all) {
  return !dashed || !all.some((other) => !other.dashed && other.color === color);
}

/** What the pointer reads off a point. */
function pointText({ dataset, raw }) {
  return `${dataset.label}${raw.name ? `, ${raw.name}` : ""}: ${raw.x.toPrecision(3)}, ${raw.y.toPrecision(3)}`;
}

function studyChart(canvas, chart) {
  const bars = chart.labels.length > 0;
  const color = themeColor("ink");
  // Every bar has its name, where there is room for it.
  const skipped = chart.labels.length * 16 > canvas.parentElement.clientWidth;
  const x = bars ? { ticks: { color, autoSkip: skipped }, grid: { display: false } } : axis(chart.x_title, chart.log_x, false);
  return new Chart(canvas, {
    type: bars ? "bar" : "scatter",
    data: bars
      ? { labels: chart.labels, datasets: chart.series.map(({ label, color, y }) => ({ label, data: y, backgroundColor: themeColor(color) })) }
      : { datasets: chart.series.map(lineSet) },
    plugins: [marksPlugin],
    options: {
      animation: false, maintainAspectRatio: false,
      scales: { x, y: axis(chart.y_title, chart.log_y, !chart.log_y) },
      plugins: { legend: { labels: { color, boxHeight: 2, filter: ({ datasetIndex }) => inLegend(chart.series[datasetIndex], chart.series) } }, marks: { at: chart.marks }, ...(bars ? {} : { tooltip: { callbacks: { label: pointText } } }) },
    },
  });
}

for (const canvas of document.querySelectorAll("canvas[data-study]")) {
  const drawn = report.charts[Number(canvas.dataset.study)];
  let chart = studyChart(canvas, drawn);
  onThemeChange.push(() => {
    chart.destroy();
    chart = studyChart(canvas, drawn);
  });
}
