// SPDX-License-Identifier: Apache-2.0
"use strict";

/** Makes an element with properties, attributes (in `attributes`) and children. */
function make(tag, properties = {}, ...children) {
  const { attributes = {}, ...rest } = properties;
  const element = Object.assign(document.createElement(tag), rest);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

function makeSelect(label, options, chosen) {
  const select = make("select", {}, ...options.map(({ id, title }) =>
    make("option", { value: id, textContent: title, selected: id === chosen })));
  return { select, field: make("label", {}, label, select) };
}

function makeRange(label, { min, max, step, value }) {
  const input = make("input", { type: "range", min, max, step, value });
  const text = make("span");
  return { input, text, field: make("label", {}, `${label} `, text, input) };
}

function makeButton(text, label, press) {
  const button = make("button", { type: "button", textContent: text, attributes: { "aria-label": label } });
  button.addEventListener("click", press);
  return button;
}

/** Buttons of which one is pressed. */
function makeChoice(label, options, chosen, choose) {
  const buttons = options.map(([id, text]) => {
    const button = makeButton(text, text, () => pick(id));
    button.dataset.id = id;
    return button;
  });
  const pick = (id) => {
    for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.id === id));
    choose(id);
  };
  for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.id === chosen));
  return { pick, field: make("fieldset", {}, make("legend", { textContent: label }), ...buttons) };
}
