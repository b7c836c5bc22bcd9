// Templates and small helpers for elements.

export { html, svg as svgTemplate, render, nothing, repeat, live } from "./vendor.js";

/** The element with an id; what kind it is its user knows. @type {(id: string) => any} */
export const $ = (id) => document.getElementById(id);

/** @param {string} name @param {Record<string, any>} attributes @param {...any} children @returns {any} */
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key === "class") element.className = value;
    else if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.filter((c) => c !== null && c !== undefined));
  return element;
}

/** @param {string} name @param {Record<string, any>} attributes @param {...any} children @returns {any} */
export function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== null) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

// Gives a group of an SVG the children of a list, [name, attributes, text]: those that are there are changed where they
// differ, not made again.
export function renew(group, list) {
  list.forEach(([name, attributes, text], i) => {
    let child = group.children[i];
    if (child?.nodeName !== name) {
      const next = svg(name);
      if (child) child.replaceWith(next);
      else group.append(next);
      child = Object.assign(next, { given: {} });
    }
    const before = child.given;
    for (const key of Object.keys(before)) if (!(key in attributes)) child.removeAttribute(key);
    for (const [key, value] of Object.entries(attributes)) if (before[key] !== value) child.setAttribute(key, value);
    child.given = attributes;
    if (text !== undefined) say(child, text);
  });
  while (group.children.length > list.length) group.lastChild.remove();
}

export function clear(element) {
  element.replaceChildren();
  return element;
}

// Hides or shows an element; one that is so already is left alone.
export function hide(element, on = true) {
  if (element.hidden !== on) element.hidden = on;
}

// Gives an element its text; one that has it already is left alone, so that nothing is laid out again.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// A drawing of the engine as an element: the only door for markup that comes as text. Scripts and handlers are left out.
export function picture(text) {
  const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  for (const element of [root, ...root.querySelectorAll("*")]) {
    if (["script", "foreignObject"].includes(element.localName)) element.remove();
    for (const { name } of [...element.attributes]) if (name.toLowerCase().startsWith("on")) element.removeAttribute(name);
  }
  return document.importNode(root, true);
}

// An open dialog makes all outside of it inert: what has to be read and closed beside it goes inside while it is open.
export function above(box) {
  const dialog = document.querySelector("dialog[open]");
  if (!dialog || box.parentElement === dialog) return;
  dialog.append(box);
  dialog.addEventListener("close", () => document.body.append(box), { once: true });
}

// Shows a short notice that goes by itself.
let timer = 0;
export function notice(text, lasting = false) {
  const box = $("notice");
  above(box);
  $("notice-text").textContent = text;
  box.hidden = !text;
  box.dataset.lasting = String(lasting);
  clearTimeout(timer);
  if (text && !lasting) timer = setTimeout(() => { box.hidden = true; }, 6000);
}
