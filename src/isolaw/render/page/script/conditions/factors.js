import { element } from '../dom.js';
import { panelHeading } from '../plotting.js';
import { tableOf } from '../tables.js';
import { DASH, isNumber, plain } from '../text.js';
import { conditions, factorText, factorTicks, intervalText, statusText, statusWord, statusesAmong, toneOf } from './data.js';

// Returns the properties that the figure shows: the first two that have bounds. The head of the section states the same
// two.
const shown = () => conditions.bounds.slice(0, 2).map(({ quantity }) => quantity);
const rowsOf = (quantity) => {
  const bound = conditions.bounds.find((one) => one.quantity === quantity);
  const allOf = (all) => ({ lambda: all.factor, mean: all.interval, status: all.status, devices: 0, all });
  return [
    ...conditions.design.filter((row) => row.quantity === quantity),
    { quantity, effect: ALL, max: allOf(bound.max), min: allOf(bound.min) },
  ];
};
const SIDES = ['max', 'min'];
const ALL = 'all together';

const COLOURS = { good: 'green', accent: 'blue', care: 'yellow', poor: 'red' };
// Returns the key of the colours, for example "green shown, red ASSUMED or NOT COVERED".
function colourKey() {
  const present = statusesAmong(shown().flatMap(rowsOf).flatMap((row) => SIDES.map((side) => row[side].status)));
  return Object.entries(COLOURS)
    .map(([tone, colour]) => [colour, present.filter((status) => toneOf(status) === tone).map(statusWord).join(' or ')])
    .filter(([, words]) => words)
    .map((pair) => pair.join(' '))
    .join(', ') + (present.includes('assumed') ? '; hatched: ASSUMED' : '');
}

export const factorsFigure = {
  id: 'conditions-factors',
  title: 'What each effect does over the design conditions',
  width: 'half',
  wanted: () => conditions.bounds.length > 0,
  caption: () =>
    'Largest and smallest factor on the value at reference. Colour: ' +
    colourKey() + '.',
  csv: factorData,
  height: (width) => (width < 480 ? shown().reduce((sum, quantity) => sum + 70 + 30 * rowsOf(quantity).length, 0) : 400),
  draw: drawFactors,
};

export const factorTableFigure = {
  id: 'conditions-factor-table',
  title: 'How sure each factor is',
  width: 'half',
  wanted: () => conditions.bounds.length > 0,
  csv: factorData,
  build: factorTable,
};

function factorTable() {
  const rows = new Map(shown().map((quantity) => [quantity, new Map(rowsOf(quantity).map((row) => [row.effect, row]))]));
  const cell = (quantity, side) => (effect) => {
    const factor = rows.get(quantity).get(effect)?.[side];
    if (!factor) return DASH;
    const part = factor.all && !factor.all.complete ? (side === 'max' ? '\u2265\u202f' : '\u2264\u202f') : '';
    const value = isNumber(factor.lambda) ? part + factorText(factor.lambda) : DASH;
    return element('td', { class: 'number' }, element('b', {}, value), element('small', {}, statusText(factor)));
  };
  const columns = [
    { title: 'Effect', cell: (effect) => effect },
    ...shown().flatMap((quantity) => SIDES.map((side) => ({ title: quantity, unit: side === 'max' ? 'largest' : 'smallest', number: true, cell: cell(quantity, side) }))),
  ];
  const asked = [...new Set(conditions.design.map(({ effect }) => effect))];
  return tableOf(columns, [...asked, ALL], 'Largest and smallest factor of each effect', { sorts: false });
}

function factorData() {
  return {
    columns: ['property', 'effect', 'side', 'factor [-]', 'interval lower', 'interval upper', 'status', 'devices'],
    rows: conditions.bounds.flatMap(({ quantity }) => rowsOf(quantity)).flatMap((row) =>
      SIDES.map((side) => {
        const { lambda, mean, status, devices } = row[side];
        return [row.quantity, row.effect, side, lambda, mean?.low ?? null, mean?.high ?? null, status, devices];
      }),
    ),
  };
}

function drawFactors(look, width) {
  const narrow = width < 480,
    traces = [], layout = { margin: { l: 92, r: 12, t: 26, b: 44 }, annotations: [], barmode: 'overlay' };
  const quantities = shown();
  const values = quantities.flatMap(rowsOf).flatMap((row) => SIDES.map((side) => row[side].lambda)).filter(isNumber);
  const [low, high] = [Math.min(1, ...values), Math.max(1, ...values)].map(Math.log);
  const room = 0.28 * (high - low || 0.2); // for the numbers beside the bars
  const range = [low - (low < 0 ? room : 0.1 * room), high + (high > 0 ? room : 0.1 * room)];
  const ticks = factorTicks(Math.exp(range[0]), Math.exp(range[1]));
  const gap = 0.06, size = (1 - gap * (quantities.length - 1)) / quantities.length;
  quantities.forEach((quantity, i) => {
    const rows = rowsOf(quantity), suffix = i === 0 ? '' : String(i + 1);
    const along = [i * (size + gap), i * (size + gap) + size];
    const down = [1 - along[1] + (i < quantities.length - 1 ? 0.05 : 0), 1 - along[0]];
    layout['xaxis' + suffix] = {
      domain: narrow ? [0, 1] : along, anchor: 'y' + suffix, range,
      tickmode: 'array', tickvals: ticks.map(Math.log), ticktext: ticks.map(String),
      title: narrow && i < quantities.length - 1 ? '' : 'factor [-]', zeroline: true, zerolinecolor: look.colour('muted'),
    };
    layout['yaxis' + suffix] = {
      domain: narrow ? down : [0, 1], anchor: 'x' + suffix, range: [rows.length - 0.4, -0.6], showgrid: false, zeroline: false,
      tickmode: 'array', tickvals: rows.map((_, k) => k), showticklabels: narrow || i === 0,
      ticktext: rows.map(({ effect }, k) => (k === rows.length - 1 ? '<b>' + effect + '</b>' : effect)),
    };
    layout.annotations.push(panelHeading(look, narrow ? 0 : along[0], narrow ? down[1] : 1, '<b>' + plain(quantity) + '</b>'));
    for (const side of SIDES) {
      const covered = rows.map((row, k) => ({ row, k, of: row[side] })).filter(({ of }) => isNumber(of.lambda));
      const isAssumed = ({ k, of }) => of.status === 'assumed' && k < rows.length - 1;
      const beside = (bar) => (bar.of.lambda === 1 ? '' : factorText(bar.of.lambda) + (isAssumed(bar) ? ' ' + statusWord(bar.of.status) : ''));
      const says = ({ row, of }) =>
        plain(row.effect) + ': ' + factorText(of.lambda) + (of.mean ? ' (' + intervalText(of.mean) + ')' : '') + '<br>' + statusText(of);
      traces.push({
        type: 'bar', orientation: 'h', xaxis: 'x' + suffix, yaxis: 'y' + suffix, width: 0.62, base: 0,
        x: covered.map(({ of }) => Math.log(of.lambda)), y: covered.map(({ k }) => k),
        marker: {
          color: covered.map(({ of }) => look.colour(toneOf(of.status))),
          pattern: { shape: covered.map(({ of }) => (of.status === 'assumed' ? '/' : '')), bgcolor: look.colour('paper'), size: 6 },
          opacity: covered.map(({ k }) => (k === rows.length - 1 ? 1 : 0.8)),
        },
        text: covered.map(beside), textposition: 'outside', cliponaxis: false,
        textfont: { size: 11.5, color: look.colour('ink') }, customdata: covered.map(says), hovertemplate: '%{customdata}<extra></extra>',
      });
    }
    rows.forEach((row, k) => {
      if (isNumber(row.max.lambda)) return;
      layout.annotations.push({
        xref: 'x' + suffix, yref: 'y' + suffix, x: 0, y: k, xanchor: 'left', showarrow: false,
        text: ' ' + statusWord(row.max.status), font: { size: 11.5, color: look.colour('poor') },
      });
    });
  });
  return { traces, layout };
}
