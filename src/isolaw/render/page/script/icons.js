import { svg } from './element.js';

// A circle as an SVG path. icon() draws shapes, each given as [path, fill, stroke], in a square of 12 by 12 units.
export const ROUND = 'M6 .8 A5.2 5.2 0 1 1 5.99 .8 Z';

export function icon(...shapes) {
  const paths = shapes.map(([d, fill, stroke]) => svg('path', { d, style: `fill: ${fill}; stroke: ${stroke}` }));
  return svg('svg', { viewBox: '0 0 12 12', 'aria-hidden': 'true' }, ...paths);
}

const TONES = { 'held by its box': 'care', dominated: 'poor', 'not adequate': 'poor', 'not ranked': 'muted' };
export const roleTone = (role) => TONES[role] ?? 'good';

const CIRCLE = 'M6 1 A5 5 0 1 1 5.99 1 Z',
  DIAMOND = 'M6 1 L11 6 L6 11 L1 6 Z',
  CROSS = 'M2 2 L10 10 M10 2 L2 10';

// Returns the marker of a law as in the plot of the front: a filled circle for a law on the front, an open diamond for
// a law that another law beats, and a cross for an inadequate law.
export function marker(role, tone = roleTone(role)) {
  const colour = 'var(--' + tone + ')';
  const path = role === 'not adequate' ? CROSS : tone === 'poor' ? DIAMOND : CIRCLE;
  const drawing = icon([path, roleTone(role) === 'good' ? colour : 'none', colour]);
  drawing.firstChild.setAttribute('stroke-width', '1.8');
  return drawing;
}
