// Creates elements of the HTML document and changes them.

import { elementsWith } from '../src/isolaw/render/page/script/element.js';
import { icon } from '../src/isolaw/render/page/script/icons.js';
import { patchChildren } from './patch.js';

export const element = elementsWith((text) => [text], (text) => text);

export const place = (id) => document.getElementById(id);

// Makes `children` the content of `node`. Elements that do not change stay in place, with their focus and scroll
// position.
export const fill = (node, ...children) => patchChildren(node, element('div', {}, children));

export const button = (title, click, attributes = {}) => element('button', { type: 'button', click, ...attributes }, title);

// Matches control characters, and invisible characters that change the direction of writing.
export const unseen = /[\u0000-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;

// Replaces control characters and direction marks by their codes, for example \x1b, so that the user sees them. Line
// ends and tabs stay.
export const visible = (words) =>
  String(words).replace(unseen, (sign) => (sign === '\n' || sign === '\t' ? sign : '\\x' + sign.codePointAt(0).toString(16).padStart(2, '0')));

const shapes = {
  tick: 'M2 6.4 L4.9 9.2 L10 3',
  cross: 'M2.5 2.5 L9.5 9.5 M9.5 2.5 L2.5 9.5',
  care: 'M6 1.2 L11.2 10.6 L.8 10.6 Z M6 4.6 L6 7.4 M6 8.9 L6 9.1',
};

// Draws an icon. The words beside an icon say the same, so screen readers skip the icon.
export function sign(name, tone) {
  const svg = icon([shapes[name], '', '']);
  svg.setAttribute('class', 'sign ' + (tone ?? ''));
  return svg;
}
