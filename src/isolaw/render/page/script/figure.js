// Places a figure on the page, draws it, and draws it again. A figure is an object {id, title, width ('half', 'wide',
// 'narrow'), wanted, depends, caption, csv, controls, build, height, draw, clicked, below}. wanted() says whether the
// page shows the figure. build() returns its content as nodes. A plot has instead height(width), and draw(look, width),
// which returns Plotly's traces and layout. `depends` names the choices that change the figure; `clicked` is called for
// a click on a point; below() returns the nodes under the plot.

import { button, element } from './dom.js';
import { csvText, download } from './download.js';
import { PLOT_CONFIG, styled, theme } from './plotting.js';
import { typeset, unset } from './symbols.js';

// figure -> {node, body, caption, seen, stale}. seen: whether the figure is in the window or near it; stale: whether
// its content must be made again.
export const drawn = new Map();

// Gives a plot its height before it is drawn, so that the page does not move later.
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
  if (figure.caption) place.caption.replaceChildren(...typeset(figure.caption()));
  if (!figure.draw) return;
  const look = theme();
  const width = place.body.clientWidth,
    height = reserve(figure);
  const { traces, layout } = figure.draw(look, width);
  Plotly.react(place.body, traces, styled({ ...layout, width, height }, look), {
    ...PLOT_CONFIG,
    displayModeBar: width > 480 ? 'hover' : false,
  });
  if (figure.clicked && !place.listens) {
    place.body.on('plotly_click', ({ points }) => points.length > 0 && figure.clicked(points[0]));
    place.listens = true;
  }
  describe(place.body, [figure.title, figure.caption?.()].filter(Boolean).join('. '));
}

// Screen readers take a plot as one picture. Its buttons stay outside that picture.
function describe(body, text) {
  body.querySelectorAll('.main-svg').forEach((svg, i) => {
    if (i > 0) return svg.setAttribute('aria-hidden', 'true');
    svg.setAttribute('role', 'img');
    return svg.setAttribute('aria-label', unset(text));
  });
}

export function buildFigure(figure, observer) {
  const head = figure.title === '' ? null : element('div', { class: 'figure-head' }, element('h3', {}, figure.title));
  if (head && figure.csv) {
    const save = () => download('isolaw-' + figure.id + '.csv', csvText(figure.csv()), 'text/csv;charset=utf-8');
    head.append(button('CSV', save, { class: 'csv', 'aria-label': 'Download the data of \u201c' + figure.title + '\u201d as CSV' }));
  }
  const controls = figure.controls ? element('div', { class: 'controls' }, ...figure.controls()) : null;
  const body = element('div', figure.draw ? { class: 'plot' } : {});
  const caption = figure.caption ? element('figcaption') : null;
  const node = element(
    'figure',
    { id: 'figure-' + figure.id, class: [figure.width ?? '', figure.long ? 'long' : ''].join(' ').trim() || null },
    head,
    controls,
    body,
    figure.below ? figure.below() : null,
    caption,
  );
  if (figure.build) body.append(figure.build());
  if (figure.caption) caption.replaceChildren(...typeset(figure.caption()));
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

export function redrawDependents(changes) {
  for (const [figure, place] of drawn) {
    if (!figure.depends?.some((key) => key in changes)) continue;
    place.stale = true;
    if (place.seen) render(figure);
  }
}
