// Creates elements of the HTML document. Text is always inserted as text and never read as HTML.

import { listen, patchChildren } from './patch.js';

const present = (children) => children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false);

export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') listen(node, name, value);
    else node.setAttribute(name, value === true ? '' : String(value));
  }
  node.append(...present(children));
  return node;
}

export const place = (id) => document.getElementById(id);

// Makes `children` the content of `node`. Elements that do not change stay in place, with their focus and scroll
// position.
export function fill(node, ...children) {
  const next = document.createDocumentFragment();
  next.append(...present(children));
  patchChildren(node, next);
}

export const button = (title, press, attributes = {}) => element('button', { type: 'button', click: press, ...attributes }, title);

// Control characters, and invisible characters that change the direction of writing.
export const unseen = /[\u0000-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;

// Replaces control characters and direction marks by their codes, for example \x1b, so that the user sees them. Line
// ends and tabs stay.
export const visible = (words) =>
  String(words).replace(unseen, (sign) => (sign === '\n' || sign === '\t' ? sign : '\\x' + sign.codePointAt(0).toString(16).padStart(2, '0')));

const shapes = {
  tick: 'M2 6.4 L4.9 9.2 L10 3',
  cross: 'M2.5 2.5 L9.5 9.5 M9.5 2.5 L2.5 9.5',
  care: 'M6 1.2 L11.2 10.6 L.8 10.6 Z M6 4.6 L6 7.4 M6 8.9 L6 9.1',
  down: 'M6 1 L6 8 M2.8 5 L6 8.2 L9.2 5 M1.5 11 L10.5 11',
};

// Draws an icon. Words beside it say the same, so screen readers skip it.
export function sign(name, tone) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('class', 'sign ' + (tone ?? ''));
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', shapes[name]);
  svg.append(path);
  return svg;
}
