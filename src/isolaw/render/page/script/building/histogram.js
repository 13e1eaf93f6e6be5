import { isNumber, plain } from '../text.js';
import { numberText, study } from './study.js';

const NONE = { from: null, width: null, counts: [] }; // for a quantity that has no value in any draw
const histogramOf = (law, key) => law.quantities[key].histogram ?? NONE;

export function bars(look, law, key, axes = {}) {
  const { from, width, counts } = histogramOf(law, key);
  const x = counts.map((_, i) => from + (i + 0.5) * width);
  return {
    type: 'bar', name: law.name, x, y: counts.map((n) => (100 * n) / law.draws), width: counts.map(() => width),
    marker: { color: look.law(law), line: { color: look.colour('paper'), width: 0.5 } }, opacity: 0.85,
    hovertemplate: '%{x:.4g}: %{y:.1f} % of the draws<extra>' + plain(law.name) + '</extra>',
    ...axes,
  };
}

export function bounds(look, law, key, { xref = 'x', yref = 'paper', low = 0, high = 1, labelled = false, span = null } = {}) {
  const of = law.quantities[key];
  const lines = [
    { value: of.lower, text: 'lower bound', colour: look.colour('poor'), dash: 'solid' },
    { value: of.nominal, text: 'nominal', colour: look.colour('ink'), dash: 'dot' },
    { value: of.upper, text: 'upper bound', colour: look.colour('poor'), dash: 'dash' },
  ].filter(({ value }) => isNumber(value));
  const shapes = lines.map(({ value, colour, dash }) => ({
    type: 'line', xref, yref, x0: value, x1: value, y0: low, y1: high, line: { color: colour, width: 1.8, dash },
  }));
  const between = {
    type: 'rect', xref, yref, x0: Math.min(of.lower, of.upper), x1: Math.max(of.lower, of.upper), y0: low, y1: high,
    fillcolor: look.colour('band'), line: { width: 0 }, layer: 'below',
  };
  const anchor = (value) => {
    const share = span ? (value - span[0]) / (span[1] - span[0]) : 0.5;
    return share < 0.25 ? 'left' : share > 0.75 ? 'right' : 'center';
  };
  const annotations = !labelled
    ? []
    : [...lines]
        .sort((a, b) => a.value - b.value)
        .map(({ value, text, colour }, row) => ({
          xref, yref, x: value, y: high, yshift: 2 + 14 * row, xanchor: anchor(value), yanchor: 'bottom', showarrow: false,
          text: text + ' ' + numberText(value), font: { size: 11.5, color: colour },
        }));
  return { shapes: isNumber(of.lower) && isNumber(of.upper) ? [between, ...shapes] : shapes, annotations };
}

export function spanOf(among, key) {
  const values = among
    .flatMap((law) => {
      const { lower, upper, nominal } = law.quantities[key];
      const { from, width, counts } = histogramOf(law, key);
      return [...(counts.length > 0 ? [from, from + width * counts.length] : []), lower, upper, nominal];
    })
    .filter(isNumber);
  if (values.length === 0) return [0, 1];
  const low = Math.min(...values),
    high = Math.max(...values),
    free = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - free, high + free];
}

export function histogramData(among, key) {
  const { title, unit } = study.quantities.find((quantity) => quantity.key === key);
  return {
    columns: ['law', 'from: ' + title + ' [' + unit + ']', 'to', 'draws'],
    rows: among.flatMap((law) => {
      const { from, width, counts } = histogramOf(law, key);
      return counts.map((n, i) => [law.id, from + i * width, from + (i + 1) * width, n]);
    }),
  };
}
