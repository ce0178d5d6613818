// SPDX-License-Identifier: Apache-2.0
"use strict";

const report = JSON.parse(document.getElementById("report-data").textContent);

/** The colour that a custom property of style.css stands for in the theme of the moment. */
function themeColor(name) {
  const probe = document.createElement("span");
  probe.style.color = `var(--${name})`;
  document.body.append(probe);
  const color = getComputedStyle(probe).color;
  probe.remove();
  return color;
}

/** Calls `draw` whenever the theme changes, for what CSS does not reach. */
const onThemeChange = [];

function announceTheme() {
  for (const draw of onThemeChange) draw();
}

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");

function setUpTheme() {
  const root = document.documentElement;
  const dark = () => (root.dataset.theme ?? (systemIsDark.matches ? "dark" : "light")) === "dark";
  const button = document.getElementById("theme");
  const label = () => (button.textContent = dark() ? "Light theme" : "Dark theme");
  button.addEventListener("click", () => {
    root.dataset.theme = dark() ? "light" : "dark";
    label();
    announceTheme();
  });
  systemIsDark.addEventListener("change", () => { label(); announceTheme(); });
  // Paper is white: canvases follow, as the style sheet does.
  let before;
  addEventListener("beforeprint", () => { before = root.dataset.theme; root.dataset.theme = "light"; announceTheme(); });
  addEventListener("afterprint", () => {
    if (before) root.dataset.theme = before; else delete root.dataset.theme;
    announceTheme();
  });
  label();
}

setUpTheme();
