import { FOLLOWED } from './cycles.js';
import { lotQuantities } from './lot.js';
import { paddedRange } from './plotting.js';
import { fixed, isNumber } from './text.js';
import { concerns } from './verdicts.js';

export function followedPanels(stacked, largest) {
  const layout = { annotations: [] };
  FOLLOWED.forEach((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1),
      gap = stacked ? 0.09 : 0.08,
      size = (1 - 2 * gap) / 3;
    const along = [i * (size + gap), i * (size + gap) + size];
    const down = [1 - along[1], 1 - along[0]];
    layout['xaxis' + suffix] = {
      domain: stacked ? [0, 1] : along, anchor: 'y' + suffix, range: [0.6, largest + 0.4], tickformat: 'd',
      dtick: Math.max(1, Math.ceil(largest / 10)), tick0: 1, zeroline: false, title: stacked && i < 2 ? '' : 'cycle',
      showticklabels: !stacked || i === 2,
    };
    layout['yaxis' + suffix] = {
      domain: stacked ? down : [0, 1], anchor: 'x' + suffix, title: property.title, zeroline: false, nticks: 5,
    };
  });
  return layout;
}

export function limitBand(limited) {
  const { nominal, lower_percent: lower, upper_percent: upper } = limited ?? {};
  if (!isNumber(nominal) || !(isNumber(lower) || isNumber(upper))) return null;
  return [lower, upper].map((percent) => (isNumber(percent) ? nominal * (1 + percent / 100) : null));
}

export function designOf(name, assessments) {
  const own = assessments.find((a) => concerns(a, name) && isNumber(a.nominal));
  const lot = lotQuantities.find((quantity) => quantity.quantity === name);
  return { nominal: own?.nominal ?? lot?.nominal ?? null, band: limitBand(own) ?? limitBand(lot) };
}

// Returns the range of the axis. It spans at least a tenth of the largest value, so that a property that hardly changes
// from cycle to cycle looks steady.
function steadyRange(values) {
  const [low, high] = paddedRange(values, 0.08);
  const missing = Math.max(0, 0.1 * Math.max(...values.map(Math.abs)) - (high - low));
  return [low - missing / 2, high + missing / 2];
}

export function framePanel(layout, look, i, { nominal, band }, values) {
  const some = values.filter(isNumber);
  if (some.length === 0) return;
  const suffix = i === 0 ? '' : String(i + 1);
  const [low, high] = steadyRange([...some, nominal, ...(band ?? [])].filter(isNumber));
  layout['yaxis' + suffix].range = [low, high];
  layout.shapes ??= [];
  const whole = { xref: 'x' + suffix + ' domain', yref: 'y' + suffix, x0: 0, x1: 1, layer: 'below' };
  if (band)
    layout.shapes.push({
      ...whole, type: 'rect', y0: band[0] ?? low, y1: band[1] ?? high, fillcolor: look.colour('band'),
      line: { width: 0 },
    });
  if (isNumber(nominal))
    layout.shapes.push({
      ...whole, type: 'line', y0: nominal, y1: nominal,
      line: { color: look.colour('good'), width: 1.2, dash: 'dash' },
    });
}

export function followedText(property, block, cycle, place) {
  const ratio = block.stability?.[property.name]?.ratio_to_third?.[place];
  return property.text(cycle[property.key]) + (isNumber(ratio) ? ', ' + fixed(ratio, 3) + ' of cycle 3' : '');
}
