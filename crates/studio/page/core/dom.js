// Templates and helper functions for elements.

export { html, svg as svgTemplate, render, nothing, repeat, live } from "./vendor.js";

/** Element with an id, of any type. @type {(id: string) => any} */
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

// Sets the children of an SVG group from a list of [name, attributes, text]. Existing children are changed if they differ and are not
// created again.
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

// Hides or shows an element. An element that is already in this state is not touched.
export function hide(element, on = true) {
  if (element.hidden !== on) element.hidden = on;
}

// Sets the text of an element. An element that already has the text is not touched, so that nothing is laid out again.
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// Drawing of the engine as an element. This is the only function that accepts markup as text. It removes scripts and event handlers.
export function picture(text) {
  const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  for (const element of [root, ...root.querySelectorAll("*")]) {
    if (["script", "foreignObject"].includes(element.localName)) element.remove();
    for (const { name } of [...element.attributes]) if (name.toLowerCase().startsWith("on")) element.removeAttribute(name);
  }
  return document.importNode(root, true);
}

// An open dialog makes everything outside it inert. Elements that must stay usable are therefore moved into the dialog while it is open.
export function above(box) {
  const dialog = document.querySelector("dialog[open]");
  if (!dialog || box.parentElement === dialog) return;
  dialog.append(box);
  dialog.addEventListener("close", () => document.body.append(box), { once: true });
}

// Shows a short notice, which disappears after some seconds unless `lasting` is set.
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
