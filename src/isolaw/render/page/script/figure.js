// A figure of the page: its place, its drawing, and when it is drawn again.
// In its file: {id, title, width ('half', 'wide', 'narrow'), wanted, depends, caption, csv, controls, build or height
// and draw}. `depends` names the choices that change it.

import { download } from './csv.js';
import { element } from './dom.js';
import { PLOT_CONFIG, styled, theme } from './plotting.js';

export const drawn = new Map(); // figure -> {node, body, caption, seen, stale}

// Room for a plot before it is drawn, so that nothing moves when it is.
export function reserve(figure) {
  const { body } = drawn.get(figure);
  const height = figure.height(body.clientWidth);
  body.style.height = height + 'px';
  return height;
}

export function render(figure) {
  const place = drawn.get(figure);
  if (place.stale && figure.build) place.body.replaceChildren(figure.build());
  place.stale = false;
  if (figure.caption) place.caption.textContent = figure.caption();
  if (!figure.draw) return;
  const look = theme();
  const width = place.body.clientWidth,
    height = reserve(figure);
  const { traces, layout } = figure.draw(look, width);
  place.body.setAttribute('aria-label', figure.title + '. ' + (figure.caption ? figure.caption() : ''));
  Plotly.react(place.body, traces, styled({ ...layout, width, height }, look), {
    ...PLOT_CONFIG,
    displayModeBar: width > 480 ? 'hover' : false,
  });
}

export function buildFigure(figure, observer) {
  const head = figure.title === '' ? null : element('div', { class: 'figure-head' }, element('h3', {}, figure.title));
  if (head && figure.csv) {
    const button = element(
      'button',
      { type: 'button', class: 'csv', 'aria-label': 'Download the data of \u201c' + figure.title + '\u201d as CSV' },
      'CSV',
    );
    button.addEventListener('click', () => download('isolaw-' + figure.id + '.csv', figure.csv()));
    head.append(button);
  }
  const controls = figure.controls ? element('div', { class: 'controls' }, ...figure.controls()) : null;
  const body = element('div', figure.draw ? { class: 'plot', role: 'img', 'aria-label': figure.title } : {});
  const caption = figure.caption ? element('figcaption') : null;
  const node = element(
    'figure',
    { id: 'figure-' + figure.id, class: [figure.width ?? '', figure.long ? 'long' : ''].join(' ').trim() || null },
    head,
    controls,
    body,
    caption,
  );
  if (figure.build) body.append(figure.build());
  if (figure.caption) caption.textContent = figure.caption();
  drawn.set(figure, { node, body, caption, seen: false, stale: Boolean(figure.draw) });
  observer.observe(node);
  node.figure = figure;
  return node;
}

export function redraw({ everything = false } = {}) {
  for (const [figure, place] of drawn) {
    if (figure.draw) {
      place.stale = true;
      reserve(figure);
    }
    if (everything || (place.seen && place.stale)) render(figure);
  }
}

// Everything that depends on what changes is drawn again; what is out of sight waits until it is seen.
export function redrawDependents(changes) {
  for (const [figure, place] of drawn) {
    if (!figure.depends?.some((key) => key in changes)) continue;
    place.stale = true;
    if (place.seen) render(figure);
  }
}
