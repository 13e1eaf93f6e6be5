import { chosen } from '../choice.js';
import { limitBand } from '../followed.js';
import { spread } from '../labels.js';
import { deviceValue, lotQuantities } from '../lot.js';
import { LEGEND, NARROW, paddedRange, panelHeading } from '../plotting.js';
import { devices, report } from '../report.js';
import { isNumber, plain, short, trimmed, unitText, withUnit } from '../text.js';
import { VERDICTS } from '../verdicts.js';

export const lotStripsFigure = {
  id: 'lot-strips',
  title: 'Every device of the lot',
  depends: ['tested'],
  wanted: () => stripRows().length > 0,
  caption: () =>
    'One mark per device; ringed: ' +
    (chosen.tested === null ? 'none' : devices[chosen.tested].name) +
    '. Outliers and devices outside their limits are named.',
  csv: stripData,
  height: () => stripLayout().height,
  draw: drawStrips,
};

const stripRows = () =>
  lotQuantities
    .map((quantity) => ({
      quantity,
      points: devices
        .map((device) => ({ device, ...deviceValue(device, quantity.quantity) }))
        .filter((point) => isNumber(point.value)),
    }))
    .filter(({ points }) => points.length > 0);

// Sizes in pixels. A strip is a horizontal axis for one quantity of the lot, with a mark for each device.
const STRIP_HEIGHT = 62;
const STRIP_BETWEEN = 52;

function stripLayout() {
  const rows = stripRows();
  const margin = { l: 14, r: 14, t: 52, b: 30 };
  const inner = rows.length * STRIP_HEIGHT + (rows.length - 1) * STRIP_BETWEEN;
  return { rows, margin, inner, height: margin.t + inner + margin.b };
}

function stripData() {
  return {
    columns: ['device', 'quantity', 'unit', 'value', 'verdict', 'outlier'],
    rows: stripRows().flatMap(({ quantity, points }) =>
      points.map(({ device, value, verdict }) => [
        device.name, quantity.quantity, quantity.unit, value, verdict, outlierOf(device, quantity) ? 'yes' : 'no',
      ]),
    ),
  };
}

const outlierOf = (device, quantity) =>
  report.assessment.lot.outliers.find((o) => o.device === device.name && o.quantity === quantity.quantity);

function drawStrips(look, width) {
  const { rows, margin, inner } = stripLayout();
  const traces = [],
    layout = { margin, shapes: [], annotations: [], showlegend: true, legend: { ...LEGEND, y: 1 + 24 / inner } };
  const present = Object.keys(VERDICTS).filter((verdict) =>
    rows.some(({ points }) => points.some((p) => p.verdict === verdict)),
  );
  rows.forEach(({ quantity, points }, i) => {
    const suffix = i === 0 ? '' : String(i + 1);
    const top = 1 - (i * (STRIP_HEIGHT + STRIP_BETWEEN)) / inner,
      bottom = top - STRIP_HEIGHT / inner;
    const band = limitBand(quantity);
    const values = points.map((point) => point.value);
    const range = paddedRange([...values, quantity.nominal, ...(band ?? [])].filter(isNumber), 0.06);
    layout['xaxis' + suffix] = {
      domain: [0, 1], anchor: 'y' + suffix, range, zeroline: false, nticks: width > NARROW ? 9 : 5, automargin: false,
    };
    layout['yaxis' + suffix] = {
      domain: [bottom, top], anchor: 'x' + suffix, range: [-1, 1], showticklabels: false, showgrid: false,
      zeroline: false, fixedrange: true, automargin: false,
    };
    const unit = quantity.unit ? ' [' + plain(unitText(quantity.unit)) + ']' : '';
    layout.annotations.push(panelHeading(look, 0, top, '<b>' + plain(quantity.quantity) + '</b>' + unit, 12.5));
    const said = limitsSaid(quantity, band);
    if (said)
      layout.annotations.push({
        text: plain(said), xref: 'paper', yref: 'paper', x: 1, y: top, xanchor: 'right', yanchor: 'bottom', showarrow: false,
        font: { size: 11.5, color: look.colour('muted') },
      });
    const whole = { xref: 'x' + suffix, yref: 'y' + suffix + ' domain', y0: 0, y1: 1, layer: 'below' };
    if (band)
      layout.shapes.push({
        ...whole, type: 'rect', x0: band[0] ?? range[0], x1: band[1] ?? range[1], fillcolor: look.colour('band'),
        line: { width: 0 },
      });
    for (const [at, dash, colour] of [
      [quantity.nominal, 'dash', 'good'],
      [quantity.mean, 'solid', 'muted'],
    ])
      if (isNumber(at))
        layout.shapes.push({
          ...whole, type: 'line', x0: at, x1: at, line: { color: look.colour(colour), width: 1.4, dash },
        });
    // Multiples of the golden ratio spread the points over the strip's height, so that neighbours do not touch.
    const height = new Map(points.map(({ device }, k) => [device, 1.3 * ((k * 0.618034) % 1) - 0.65]));
    for (const verdict of present) {
      const some = points.filter((point) => point.verdict === verdict);
      if (some.length === 0) continue;
      const known = VERDICTS[verdict];
      traces.push({
        name: verdict,
        legendgroup: verdict,
        showlegend: !traces.some((trace) => trace.name === verdict),
        mode: 'markers',
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x: some.map((point) => point.value),
        y: some.map((point) => height.get(point.device)),
        text: some.map((point) => plain(point.device.name)),
        customdata: some.map((point) => plain(withUnit(point.value, quantity.unit))),
        marker: {
          symbol: known.symbol, size: points.length > 60 ? 6 : 8,
          color: look.colour(known.tone === 'muted' ? 'accent' : known.tone),
          line: { width: known.filled ? 0 : 1.5, color: look.colour(known.tone === 'muted' ? 'accent' : known.tone) },
        },
        hovertemplate: '<b>%{text}</b>: %{customdata}<extra>' + verdict + '</extra>',
      });
    }
    const own = points.find(({ device }) => device.index === chosen.tested);
    if (own)
      traces.push({
        mode: 'markers', showlegend: false, hoverinfo: 'skip', xaxis: 'x' + suffix, yaxis: 'y' + suffix, x: [own.value],
        y: [height.get(own.device)],
        marker: { symbol: 'circle-open', size: 15, line: { width: 2 }, color: look.colour('ink') },
      });
    const axes = { xref: 'x' + suffix, yref: 'y' + suffix };
    const labels = outlierLabels(points, quantity, range, width - margin.l - margin.r - (said ? 6.5 * said.length : 0), height);
    layout.annotations.push(
      ...labels.map((label) => ({
        ...(label.xanchor ? axes : { xref: axes.xref, yref: 'paper', y: top, yanchor: 'bottom' }), showarrow: false,
        font: { size: 11.5, color: look.colour('care') }, ...label,
      })),
    );
  });
  return { traces: [...traces, ...legendOfLines(look, rows)], layout };
}

function limitsSaid(quantity, band) {
  const parts = [];
  if (band) parts.push('limits ' + band.map((limit) => (isNumber(limit) ? trimmed(limit) : 'none')).join(' to '));
  if (isNumber(quantity.nominal)) parts.push('design ' + trimmed(quantity.nominal));
  return parts.join(', ');
}

function legendOfLines(look, rows) {
  const entry = (name, style) => ({ name, x: [null], y: [null], hoverinfo: 'skip', ...style });
  const line = (colour, dash) => ({ mode: 'lines', line: { color: look.colour(colour), width: 1.4, dash } });
  const mark = (marker) => ({ mode: 'markers', marker });
  const entries = [];
  if (rows.some(({ quantity }) => isNumber(quantity.mean))) entries.push(entry('mean of the lot', line('muted', 'solid')));
  if (rows.some(({ quantity }) => isNumber(quantity.nominal))) entries.push(entry('design', line('good', 'dash')));
  if (rows.some(({ quantity }) => limitBand(quantity)))
    entries.push(entry('limits of one device', mark({ symbol: 'square', size: 13, color: look.colour('band') })));
  if (chosen.tested !== null)
    entries.push(
      entry(plain(short(devices[chosen.tested].name, 12)), mark({ symbol: 'circle-open', size: 12, line: { width: 2 }, color: look.colour('ink') })),
    );
  return entries;
}

// Labels the outliers and the devices outside their limits. If a strip has at most three of them, each name is beside
// its mark. If it has more, all names go to a row above the strip, to the right of its heading. If this row has no room
// for all names, it shows those of the devices with the largest values.
function outlierLabels(points, quantity, range, width, height) {
  const found = points.filter(({ device, verdict }) => verdict === 'fail' || outlierOf(device, quantity)).sort((a, b) => a.value - b.value);
  const few = 3;
  if (found.length <= few)
    return found.map(({ device, value }) => {
      const leftwards = value > range[0] + 0.8 * (range[1] - range[0]);
      return {
        x: value, y: height.get(device), xanchor: leftwards ? 'right' : 'left', xshift: leftwards ? -9 : 9,
        text: plain(short(device.name, 12)),
      };
    });
  const pixel = (value) => ((value - range[0]) / (range[1] - range[0])) * width;
  const names = found.map(({ device }) => '\u25be ' + short(device.name, 12));
  const widest = Math.max(0, ...names.map((name) => 7 * name.length)) + 6;
  const free = 110, // pixels for the strip's heading
    most = Math.max(1, Math.floor((width - free) / widest));
  const some = found.slice(-most);
  const places =
    some.length > 0
      ? spread(some.map((point) => pixel(point.value)), widest, free + widest / 2, width - widest / 2)
      : [];
  return some.map((_, i) => ({
    x: range[0] + (places[i] / width) * (range[1] - range[0]),
    text: plain(names[found.length - some.length + i]),
  }));
}
