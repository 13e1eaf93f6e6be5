import { isPrinting } from '../dom.js';
import { decadeTicks, paddedRange, panelHeading } from '../plotting.js';
import { resultColumns } from '../report.js';
import { isNumber, plain } from '../text.js';
import {
  allLevels, atText, chosenProperties, conditionOf, conditions, curvesOf, endsOf, factorText, factorTicks, intervalText, levelText, levelsOf, rangeOf,
  referenceAt, statusText,
} from './data.js';

const SHOWN = ['temperature', 'rate', 'load', 'ageing'];

// Returns the sentences of the caption about marks that only some panels have.
function marksShown() {
  const quantities = chosenProperties(), levels = allLevels.filter(({ quantity }) => quantities.includes(quantity));
  const others = [...new Set(levels.map(({ factor }) => factor.status))].filter((status) => ['unpaired', 'scaled'].includes(status));
  const isCut = quantities.some((quantity) => levelsOfAll(quantity).some(({ factor }) => cutEnds(factor, rangeOfFactors(quantity)).length > 0));
  return [
    others.length > 0 && ' Open square: ' + others.join(' or ') + '.',
    isCut && ' Arrow: the interval goes on beyond the panel.',
  ].filter(Boolean).join('');
}

export const panelsFigure = {
  id: 'conditions-panels',
  title: 'The factor over each condition',
  depends: ['conditionsGroup'],
  wanted: () => effects().length > 0,
  caption: () =>
    'Thin: each device, over its own value at reference (ring). Blue: mean; thick bar: its 95\u202f% interval, thin bar: that of ' +
    'one further device. Shaded: design conditions. Dotted: extrapolated. Dashed: smooth curve, for drawing only.' + marksShown(),
  csv: panelData,
  height: (width) => grid(width).height,
  draw: drawPanels,
};

const effects = () => SHOWN.filter((effect) => allLevels.some((level) => level.effect === effect));

// Returns the data of the figure as a table. Each level has a row with the mean and its intervals, and a row for each
// device.
function panelData() {
  const ofLevel = resultColumns('conditions_levels'), ofFactor = resultColumns('conditions_factors');
  const none = { low: null, high: null };
  const whole = ({ mean, device, system, prototypes, ...factor }) => ({
    ...factor, mean: mean ?? none, device: device ?? none, system: system ?? none, prototypes: prototypes ?? none,
  });
  const row = (level, device, factor) => [...ofLevel.cells(level), device, ...ofFactor.cells(whole(factor))];
  return {
    columns: [...ofLevel.columns, 'device', ...ofFactor.columns],
    rows: allLevels.flatMap((level) => [row(level, 'mean', level.factor), ...level.ratios.map(({ device, lambda }) => row(level, device, { lambda }))]),
  };
}

const HEADING = 22, BELOW = 46;
const panelHeight = () => (isPrinting() ? 125 : 190); // a printed figure must fit on a page

// Wide pages have a column for each effect and a row for each property; narrower ones have fewer columns.
function grid(width) {
  const quantities = chosenProperties(), among = effects();
  const across = width < 900 ? 2 : among.length;
  const byProperty = across === among.length && across > 2;
  const cells = byProperty
    ? quantities.flatMap((quantity) => among.map((effect) => ({ quantity, effect })))
    : among.flatMap((effect) => quantities.map((quantity) => ({ quantity, effect })));
  const rows = Math.ceil(cells.length / across);
  return { cells, across, byProperty, height: 8 + rows * (panelHeight() + HEADING + BELOW) };
}

function drawPanels(look, width) {
  const { cells, across, height, byProperty } = grid(width);
  const panel = panelHeight();
  const margin = { l: 56, r: 12, t: 8, b: 0 };
  const inner = height - margin.t, gap = byProperty ? 26 : 62;
  const share = gap / (width - margin.l - margin.r), wide = (1 - share * (across - 1)) / across;
  const layout = { margin, annotations: [], shapes: [] }, traces = [];
  const ranges = new Map(chosenProperties().map((quantity) => [quantity, rangeOfFactors(quantity)]));
  cells.forEach(({ quantity, effect }, i) => {
    const n = i === 0 ? '' : String(i + 1), column = i % across, row = Math.floor(i / across);
    const left = column * (wide + share), top = 1 - (HEADING + row * (panel + HEADING + BELOW)) / inner;
    const range = ranges.get(quantity), ticks = factorTicks(...range.map(Math.exp));
    const shown = effect === 'ageing' ? ofAgeing(quantity) : ofCondition(effect, quantity);
    const nticks = Math.min(6, Math.floor((wide * (width - margin.l - margin.r)) / 28));
    layout['xaxis' + n] = { nticks, ...shown.axis, domain: [left, left + wide], anchor: 'y' + n, zeroline: false };
    layout['yaxis' + n] = {
      domain: [top - panel / inner, top], anchor: 'x' + n, range,
      tickmode: 'array', tickvals: ticks.map(Math.log), ticktext: ticks.map(String),
      zeroline: true, zerolinecolor: look.colour('muted'), showticklabels: !byProperty || column === 0,
      automargin: false, title: !byProperty || column === 0 ? plain(quantity) + ' factor' : '',
    };
    layout.annotations.push(panelHeading(look, left, top, '<b>' + effect + '</b>'));
    for (const [x0, x1] of shown.design)
      layout.shapes.push({
        type: 'rect', layer: 'below', xref: 'x' + n, x0, x1, yref: 'y' + n + ' domain', y0: 0, y1: 1,
        fillcolor: look.colour('band'), line: { width: 0 },
      });
    const axes = { xaxis: 'x' + n, yaxis: 'y' + n, showlegend: false };
    traces.push(...devicesOf(look, shown, axes), ...meansOf(look, shown, axes, effect, range));
  });
  return { traces, layout };
}

// The axis of a property is the same for all effects, so that they can be compared.
function rangeOfFactors(quantity) {
  const factors = [...levelsOfAll(quantity), ...effects().flatMap((effect) => endsOf(effect, quantity))];
  const logs = (values) => values.filter((value) => isNumber(value) && value > 0).map(Math.log);
  const [low, high] = paddedRange([0, ...logs(factors.flatMap(({ factor, ratios = [] }) => [factor.lambda, ...ratios.map(({ lambda }) => lambda)]))], 0);
  // A very wide interval would leave little room for the factors. The axis therefore extends beyond them by at most
  // half their own range or a factor of 1.2, whichever is more, and longer intervals are cut.
  const room = Math.max(0.5 * (high - low), 0.2), within = (value) => Math.min(high + room, Math.max(low - room, value));
  const ends = logs(factors.flatMap(({ factor: { mean, device } }) => [mean?.low, mean?.high, device?.low, device?.high]));
  return paddedRange([low, high, ...ends.map(within)], 0.08);
}

const levelsOfAll = (quantity) => effects().flatMap((effect) => levelsOf(effect, quantity));

// Returns the ends of the axis at which an interval of the factor is cut: 0 stands for the lower end and 1 for the
// upper. For example, [] means that no interval is cut.
const cutEnds = ({ mean, device }, [low, high]) =>
  [0, 1].filter((end) => [mean, device].some((of) => of && (end === 0 ? Math.log(of.low) < low : Math.log(of.high) > high)));

// Returns the points of a panel, with the reference, its lines and its axis, for an effect whose condition is a number.
function ofCondition(effect, quantity) {
  const { title, unit, log } = conditionOf(effect);
  const ends = endsOf(effect, quantity), range = rangeOf(effect);
  const points = [...levelsOf(effect, quantity), { at: referenceAt(effect), reference: true }].filter(({ at }) => isNumber(at));
  const places = [...points, ...ends].map(({ at }) => at);
  return {
    points, ends, curves: curvesOf(effect, quantity), design: range ? [range] : [],
    axis: {
      title: title + ' [' + unit + ']',
      ...(log ? { type: 'log', range: paddedRange(places.map(Math.log10), 0.05), ...decadeTicks(places) } : { range: paddedRange(places, 0.05) }),
    },
  };
}

// Returns the same as ofCondition(), for ageing. A level of ageing is not a single number, so the levels stand side by
// side at 1, 2, ..., and devices that were not aged stand at 0.
function ofAgeing(quantity) {
  const levels = levelsOf('ageing', quantity);
  const points = [{ at: 0, reference: true }, ...levels.map((level, i) => ({ ...level, at: i + 1 }))];
  const { aged } = conditions.design_conditions;
  const line = (kind, at, lambda) => ({ kind, at: [0, at], lambda: [1, lambda] });
  const curves = levels.flatMap(({ ratios, factor }, i) => [
    ...ratios.map(({ lambda }) => line('device', i + 1, lambda)),
    ...(isNumber(factor.lambda) ? [line('mean', i + 1, factor.lambda)] : []),
  ]);
  const isDesign = ({ aged_days: days, aged_at_C: at }) => aged && days === aged.days && at === aged.at_C;
  return {
    points, ends: [], curves, design: points.filter(isDesign).map(({ at }) => [at - 0.3, at + 0.3]),
    axis: {
      title: '', range: [-0.5, points.length - 0.5], tickmode: 'array', tickvals: points.map(({ at }) => at), showgrid: false,
      ticktext: points.map((point) => (point.reference ? 'not aged' : plain(levelText(point)).replace(' at ', '<br>at '))),
    },
  };
}

// Joins all lines of a kind into one trace of Plotly, with gaps between them.
function lineOf(curves, kind, axes, line) {
  const some = curves.filter((curve) => curve.kind === kind);
  return {
    ...axes, mode: 'lines', line, hoverinfo: 'skip',
    x: some.flatMap(({ at }) => [...at, null]), y: some.flatMap(({ lambda }) => [...lambda.map(Math.log), null]),
  };
}

function devicesOf(look, { points, curves }, axes) {
  const colour = look.colour('measured');
  const marks = points.flatMap((point) => (point.ratios ?? []).map((ratio) => ({ point, ...ratio })));
  return [
    lineOf(curves, 'device', axes, { color: colour, width: 0.9 }),
    {
      ...axes, mode: 'markers', x: marks.map(({ point }) => point.at), y: marks.map(({ lambda }) => Math.log(lambda)),
      marker: { color: colour, size: 4 }, hovertemplate: '%{text}<extra></extra>',
      text: marks.map(({ point, device, lambda }) => plain(device + ', ' + levelText(point) + ': ' + factorText(lambda))),
    },
  ];
}

function meansOf(look, { points, ends, curves }, axes, effect, range) {
  const colour = look.colour('accent');
  const measured = points.filter((point) => !point.reference && isNumber(point.factor.lambda));
  const bars = (kind, width, size) => {
    const some = measured.filter(({ factor }) => factor[kind]);
    return {
      ...axes, mode: 'markers', x: some.map(({ at }) => at), y: some.map(({ factor }) => Math.log(factor.lambda)),
      marker: { size: 1, color: colour }, hoverinfo: 'skip',
      error_y: {
        type: 'data', symmetric: false, color: colour, thickness: width, width: size,
        array: some.map(({ factor }) => Math.min(Math.log(factor[kind].high), range[1]) - Math.log(factor.lambda)),
        arrayminus: some.map(({ factor }) => Math.log(factor.lambda) - Math.max(Math.log(factor[kind].low), range[0])),
      },
    };
  };
  const says = (where, factor) =>
    plain(where) + ': ' + factorText(factor.lambda) + (factor.mean ? '<br>mean ' + intervalText(factor.mean) : '') +
    (factor.device ? '<br>one further device ' + intervalText(factor.device) : '') + '<br>' + statusText(factor);
  const cut = measured.flatMap(({ at, factor }) => cutEnds(factor, range).map((end) => ({ at, end })));
  const between = ends.filter(({ factor }) => isNumber(factor.lambda) && ['interpolated', 'extrapolated'].includes(factor.status));
  return [
    lineOf(curves, 'mean', axes, { color: colour, width: 1.8 }),
    lineOf(curves, 'extrapolated', axes, { color: colour, width: 1.8, dash: 'dot' }),
    lineOf(curves, 'smooth', axes, { color: look.colour('ink'), width: 1, dash: 'dash' }),
    {
      ...axes, mode: 'markers', x: cut.map(({ at }) => at), y: cut.map(({ end }) => range[end]), hoverinfo: 'skip', cliponaxis: false,
      marker: { color: colour, size: 9, symbol: cut.map(({ end }) => (end === 0 ? 'triangle-down' : 'triangle-up')) },
    },
    bars('device', 1, 4),
    bars('mean', 3, 0),
    {
      ...axes, mode: 'markers', x: measured.map(({ at }) => at), y: measured.map(({ factor }) => Math.log(factor.lambda)),
      marker: { color: colour, size: 7, symbol: measured.map(({ factor }) => (factor.status === 'shown' ? 'circle' : 'square-open')) },
      text: measured.map((point) => says(levelText(point), point.factor)), hovertemplate: '%{text}<extra></extra>',
    },
    {
      ...axes, mode: 'markers', x: between.map(({ at }) => at), y: between.map(({ factor }) => Math.log(factor.lambda)),
      marker: { color: look.colour('paper'), size: 7, symbol: 'diamond', line: { color: colour, width: 1.5 } },
      text: between.map(({ at, factor }) => says(atText(effect, at), factor)), hovertemplate: '%{text}<extra></extra>',
    },
    {
      ...axes, mode: 'markers', x: points.filter(({ reference }) => reference).map(({ at }) => at), y: [0],
      marker: { color: look.colour('paper'), size: 9, line: { color: look.colour('ink'), width: 1.8 } }, hovertemplate: 'reference<extra></extra>',
    },
  ];
}
