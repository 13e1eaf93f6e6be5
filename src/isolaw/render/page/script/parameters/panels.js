import { chosen } from '../choice.js';
import { isPrinting } from '../dom.js';
import { NARROW, namedAxis, paddedRange, panelHeading } from '../plotting.js';
import { laws, usable } from '../report.js';
import { inFigure, symbol } from '../symbols.js';
import {
  THIN, enumerate, fixed, isNumber, mean, plain, rowFormat, signed, significant, superscript, unitText,
} from '../text.js';
import { parameterData } from './tables.js';

export const parameterPanelsFigure = {
  id: 'parameter-panels',
  title: 'Every parameter over the devices',
  depends: ['law'],
  wanted: () => usable.length > 1 && chosen.law !== null && panelPlaces(laws[chosen.law]).length > 0,
  caption: panelsCaption,
  csv: parameterData,
  height: (width) => panelGrid(panelPlaces(laws[chosen.law]).length, width).height,
  draw: drawPanels,
};

const panelPlaces = (law) =>
  law.parameters
    .map((_, place) => place)
    .filter((place) => law.parameters[place].free && law.devices.some((fit) => isNumber(fit.parameters[place]?.mean)));

const PANEL_MARGIN = { l: 62, r: 52, t: 8, b: 40 };

function panelGrid(panels, width) {
  const printing = isPrinting(); // a printed figure must fit on a page
  const columns = width > 900 || printing ? 3 : width > NARROW ? 2 : 1;
  const rows = Math.max(1, Math.ceil(panels / columns)),
    panel = printing ? 95 : 140,
    heading = 20,
    between = 34 + heading;
  const inner = heading + rows * panel + (rows - 1) * between;
  return { columns, panel, heading, between, inner, height: PANEL_MARGIN.t + inner + PANEL_MARGIN.b };
}

function overDevices(law, place) {
  const entries = usable
    .map((device, x) => ({ device, x, row: law.fitOn.get(device.index)?.parameters[place] }))
    .filter(({ row }) => isNumber(row?.mean));
  return { entries, lot: mean(entries.filter(({ device }) => !device.copy_of).map(({ row }) => row.mean)) };
}

function panelsCaption() {
  const law = laws[chosen.law];
  const strayed = panelPlaces(law)
    .map((place) => law.parameters[place])
    .filter((p) => isNumber(p.delta))
    .sort((a, b) => b.delta - a.delta);
  const bound = panelPlaces(law).filter((place) => law.devices.some((fit) => fit.parameters[place]?.at_bound));
  return (
    'Left: mean over the runs \u00b1 standard deviation. Right: difference from the mean over the devices (dotted). ' +
    (strayed.length > 1
      ? symbol(strayed[0].name) + ' differs most from device to device (' + fixed(100 * strayed[0].delta, 0) + THIN + '%), ' +
        symbol(strayed[strayed.length - 1].name) + ' least (' + fixed(100 * strayed[strayed.length - 1].delta, 0) + THIN + '%).'
      : '') +
    (usable.some((device) => device.name.length > 6) ? ' Devices are numbered in the order of the lot.' : '') +
    (bound.length > 0
      ? ' Open marks: the best run lies at a bound of its search box (' + enumerate(bound.map((place) => symbol(law.parameters[place].name))) + ').'
      : '')
  );
}

// Widens a range to at least `least`, since runs that end at the same value differ only in digits that nobody reads.
function atLeast(least, [low, high]) {
  const more = Math.max(0, least - (high - low)) / 2;
  return [low - more, high + more];
}

function drawPanels(look, width) {
  const law = laws[chosen.law],
    places = panelPlaces(law);
  const { columns, panel, heading, between, inner } = panelGrid(places.length, width);
  const layout = { margin: PANEL_MARGIN, annotations: [], shapes: [] },
    traces = [];
  const named = usable.every((device) => device.name.length <= 6); // a longer name would need a number instead
  const abscissa = namedAxis(usable.map((device, i) => (named ? device.name : String(i + 1))), columns === 1 ? 12 : 11);
  const gap = columns === 1 ? 0 : 118 / (width - PANEL_MARGIN.l - PANEL_MARGIN.r),
    wide = (1 - gap * (columns - 1)) / columns;
  places.forEach((place, i) => {
    const left = (i % columns) * (wide + gap),
      top = 1 - (heading + Math.floor(i / columns) * (panel + between)) / inner;
    const name = (number) => (number === 1 ? '' : String(number));
    const x = name(i + 1), y = name(2 * i + 1), right = name(2 * i + 2);
    const { entries, lot } = overDevices(law, place),
      { factor, exponent } = rowFormat(entries.map(({ row }) => row.mean));
    const values = entries.flatMap(({ row }) => [(row.mean - (row.std ?? 0)) / factor, (row.mean + (row.std ?? 0)) / factor]);
    const range = atLeast(0.02 * Math.abs(lot / factor), paddedRange([...values, lot / factor], 0.08));
    // Returns the difference from the lot's mean in percent. If the mean is negative, the percentages fall from the
    // bottom of the axis to the top.
    const percent = (value) => (lot !== 0 ? 100 * ((value * factor) / lot - 1) : 0);
    layout['xaxis' + x] = {
      ...abscissa, domain: [left, left + wide], anchor: 'y' + y, tickfont: { size: 10.5 }, automargin: false,
    };
    layout['yaxis' + y] = { domain: [top - panel / inner, top], anchor: 'x' + x, range, nticks: 5, zeroline: false, automargin: false };
    if (lot !== 0)
      layout['yaxis' + right] = {
        domain: [top - panel / inner, top], anchor: 'x' + x, overlaying: 'y' + y, side: 'right',
        range: range.map(percent), nticks: 5, ticksuffix: THIN + '%', showgrid: false, zeroline: false,
        automargin: false, tickmode: 'auto', // the ticks of this axis need not match those of the left axis
      };
    const { unit } = law.parameters[place];
    const scale = [exponent !== 0 ? '10' + superscript(exponent) : '', unit && unit !== '1' ? unitText(unit) : ''].filter(Boolean).join(' ');
    const title = '<b>' + inFigure(symbol(law.parameters[place].name)) + '</b>';
    layout.annotations.push(panelHeading(look, left, top, title + (scale ? ' [' + plain(scale) + ']' : '')));
    layout.shapes.push({
      type: 'line', xref: 'x' + x + ' domain', x0: 0, x1: 1, yref: 'y' + y, y0: lot / factor, y1: lot / factor,
      line: { color: look.colour('muted'), width: 1.3, dash: 'dot' },
    });
    traces.push({
      mode: 'markers',
      xaxis: 'x' + x,
      yaxis: 'y' + y,
      x: entries.map((entry) => entry.x),
      y: entries.map(({ row }) => row.mean / factor),
      error_y: {
        type: 'data', array: entries.map(({ row }) => (row.std ?? 0) / factor), color: look.law(law), thickness: 1.2,
        width: usable.length > 40 ? 0 : 3,
      },
      marker: {
        color: look.law(law), size: usable.length > 60 ? 4 : 6,
        symbol: entries.map(({ row }) => (row.at_bound ? 'circle-open' : 'circle')),
        line: { width: 1.5, color: look.law(law) },
      },
      text: entries.map(({ device }) => plain(device.name)),
      customdata: entries.map(
        ({ row }) =>
          significant(row.mean, 4) + (isNumber(row.std) ? ' \u00b1 ' + significant(row.std, 2) : '') +
          (unit && unit !== '1' ? ' ' + plain(unitText(unit)) : '') +
          (isNumber(row.std) && row.mean !== 0 ? ' (\u03c3/|\u03bc| ' + significant(Math.abs(row.std / row.mean), 2) + ')' : '') +
          (isNumber(row.percent_of_lot) ? ', ' + signed(row.percent_of_lot, 1) + THIN + '%' : '') +
          (row.at_bound ? '<br>best run at the ' + row.at_bound + ' bound' : ''),
      ),
      hovertemplate: title + ' on %{text}<br>%{customdata}<extra></extra>',
    });
    // Plotly draws no axis without a trace.
    if (lot !== 0)
      traces.push({ mode: 'markers', xaxis: 'x' + x, yaxis: 'y' + right, x: [0], y: [0], opacity: 0, hoverinfo: 'skip', marker: { size: 1 } });
  });
  return { traces, layout };
}
