import { panelHeading } from '../plotting.js';
import { isNumber, plain } from '../text.js';
import { conditions, factorText, factorTicks, intervalText, statusText, statusWord, statusesAmong, toneOf } from './data.js';

// The properties whose bounds are told at the head of the section.
const shown = () => conditions.bounds.slice(0, 2).map(({ quantity }) => quantity);
const rowsOf = (quantity) => {
  const bound = conditions.bounds.find((one) => one.quantity === quantity);
  const all = ({ factor, interval, status, not_covered: missing }) => ({ lambda: factor, mean: interval, status, devices: 0, missing });
  return [
    ...conditions.design.filter((row) => row.quantity === quantity),
    { quantity, effect: 'all together', max: all(bound.max), min: all(bound.min) },
  ];
};
const SIDES = ['max', 'min'];


const COLOURS = { good: 'green', accent: 'blue', care: 'yellow', poor: 'red' };
// "green shown, red ASSUMED or NOT COVERED"
function colourKey() {
  const present = statusesAmong(shown().flatMap(rowsOf).flatMap((row) => SIDES.map((side) => row[side].status)));
  return Object.entries(COLOURS)
    .map(([tone, colour]) => [colour, present.filter((status) => toneOf(status) === tone).map(statusWord).join(' or ')])
    .filter(([, words]) => words)
    .map((pair) => pair.join(' '))
    .join(', ');
}

export const factorsFigure = {
  id: 'conditions-factors',
  title: 'What each effect does over the design conditions',
  width: 'half',
  wanted: () => conditions.bounds.length > 0,
  caption: () =>
    'Largest and smallest factor on the value at reference. Colour: ' +
    colourKey() + '.',
  csv: () => ({
    columns: ['property', 'effect', 'side', 'factor [-]', 'interval lower', 'interval upper', 'status', 'devices'],
    rows: conditions.bounds.flatMap(({ quantity }) => rowsOf(quantity)).flatMap((row) =>
      SIDES.map((side) => {
        const { lambda, mean, status, devices } = row[side];
        return [row.quantity, row.effect, side, lambda, mean?.low ?? null, mean?.high ?? null, status, devices];
      }),
    ),
  }),
  height: (width) => (width < 480 ? shown().reduce((sum, quantity) => sum + 70 + 30 * rowsOf(quantity).length, 0) : 400),
  draw: drawFactors,
};


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
          color: covered.map(({ of }) => look.colour(toneOf(of.status))), opacity: covered.map(({ k }) => (k === rows.length - 1 ? 1 : 0.8)),
        },
        text: covered.map(beside), textposition: 'outside', cliponaxis: false,
        textfont: { size: 11.5, color: look.colour('ink') }, customdata: covered.map(says), hovertemplate: '%{customdata}<extra></extra>',
      });
    }
    rows.forEach((row, k) => {
      const missing = row.missing ?? [];
      if (isNumber(row.max.lambda) || missing.length > 0) return;
      layout.annotations.push({
        xref: 'x' + suffix, yref: 'y' + suffix, x: 0, y: k, xanchor: 'left', showarrow: false,
        text: ' ' + statusWord(row.max.status), font: { size: 11.5, color: look.colour('poor') },
      });
    });
  });
  return { traces, layout };
}
