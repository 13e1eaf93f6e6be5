import { chosen } from '../choice.js';
import { emptyPlot, paddedRange } from '../plotting.js';
import { devices, examinedLaws, laws } from '../report.js';
import { inFigure, symbol } from '../symbols.js';
import {
  MINUS, fixed, isNumber, plain, rangeText, rowFormat, significant, superscript, unitText, withUnit,
} from '../text.js';
import { chosenExamination } from './examination.js';

export const profileFigure = {
  id: 'profile',
  width: 'narrow',
  title: 'How far the parameter may go',
  depends: ['examined', 'parameter', 'device'],
  wanted: () => examinedLaws.length > 0 && chosen.device !== null,
  caption: profileCaption,
  csv: profileData,
  height: () => PROFILE_HEIGHT,
  draw: drawProfile,
};

const PROFILE_HEIGHT = 400;

function profileCaption() {
  const one = chosenExamination();
  const law = laws[chosen.examined],
    where = law.name + ' on ' + devices[chosen.device].name;
  if (!one) return where + ' was not examined.';
  const { name, unit } = one.parameter;
  const ends = one.ends[0] && one.ends[1] ? ', the whole range searched,' : one.ends[0] ? ' (searched no lower)' : ' (searched no higher)';
  return (
    where + '. ' + symbol(name) + ' is held at each point and all others are fitted again. Any ' + symbol(name) + ' from ' + rangeText(one.open, unit) +
    (one.ends.some(Boolean) ? ends : '') + ' fits as well: its OF lies below the dashed line, ' +
    significant(one.fit.rise, 2) + ' above the least, ' + fixed(one.fit.optimum, 4) +
    '. ' + symbol(name) + ' is ' + one.verdict + '.'
  );
}

function profileData() {
  const one = chosenExamination();
  return {
    columns: ['law', 'device', 'parameter', 'unit', 'value', 'least OF [-]'],
    rows: one
      ? one.values.map((value, i) => [
        one.law.id, devices[chosen.device].name, one.parameter.name, one.parameter.unit, value, one.objectives[i],
      ])
      : [],
  };
}

// Returns the axis of a parameter. It is logarithmic if all values have the same sign and differ by a factor above 20.
// Otherwise it is linear.
function parameterAxis({ name, unit }, values) {
  const sizes = values.map(Math.abs),
    largest = Math.max(...sizes),
    sign = Math.sign(values[0]);
  const log = values.every((value) => Math.sign(value) === sign && value !== 0) && largest > 20 * Math.min(...sizes);
  const format = rowFormat(values);
  const factor = log ? sign : format.factor;
  const scaled = log || format.exponent === 0 ? '' : '10' + superscript(format.exponent) + ' ';
  const places = values.map((value) => value / factor);
  const range = paddedRange(log ? places.map(Math.log10) : places, 0.04);
  const start = log && sign < 0 ? [...range].reverse() : range;
  return {
    of: (value) => value / factor,
    share: (place) => ((log ? Math.log10(place) : place) - start[0]) / (start[1] - start[0]), // as a share of the axis
    layout: {
      title: inFigure(symbol(name)) + plain(' [' + scaled + unitText(unit) + ']'),
      type: log ? 'log' : 'linear',
      range: start,
      ...(log ? { dtick: 1, exponentformat: 'power', tickprefix: sign < 0 ? MINUS : '' } : { nticks: 7 }),
      zeroline: false,
    },
  };
}

function drawProfile(look) {
  const one = chosenExamination();
  if (!one) return emptyPlot(look, 'not examined');
  const { values, objectives, optimum, fit } = one;
  const limit = fit.optimum + fit.rise;
  const bars = [
    { title: 'open range', range: one.open, colour: 'good' },
    { title: 'linearised', range: one.linear, colour: 'law-1' },
    { title: 'bootstrap', range: one.bootstrap, colour: 'law-4' },
  ].filter(({ range }) => range.every(isNumber));
  const axis = parameterAxis(one.parameter, [...values, optimum, ...bars.flatMap(({ range }) => range)]);
  const top = Math.max(fit.optimum + 2 * fit.rise, Math.min(Math.max(...objectives), fit.optimum + 6 * fit.rise)),
    low = fit.optimum - 0.12 * (top - fit.optimum);
  const level = (i) => bars.length - i;
  const ends = one.open.map(axis.of);
  const curvePoints = [
    ...values.map((value, i) => [value, objectives[i]]),
    ...one.open.filter((_, i) => !one.ends[i]).map((value) => [value, limit]), // the profile crosses the limit here
  ].sort((a, b) => a[0] - b[0]);
  const text = (value) => withUnit(value, unitText(one.parameter.unit));
  return {
    traces: [
      {
        mode: 'lines', x: [ends[0], ends[0], ends[1], ends[1], ends[0]], y: [low, 2 * top, 2 * top, low, low],
        fill: 'toself', fillcolor: look.colour('band'), line: { width: 0 }, hoverinfo: 'skip',
      },
      {
        mode: 'lines', x: curvePoints.map(([value]) => axis.of(value)),
        y: curvePoints.map(([, objective]) => objective), hoverinfo: 'skip',
        line: { color: look.colour('ink'), width: 1.8 },
      },
      {
        mode: 'markers', x: values.map(axis.of), y: objectives, text: values.map(text),
        marker: { color: look.colour('ink'), size: 6 }, hovertemplate: '%{text}<br>least OF %{y:.5f}<extra></extra>',
      },
      {
        mode: 'markers', x: [axis.of(optimum)], y: [fit.optimum], text: [text(optimum)],
        marker: { color: look.colour('good'), size: 11, line: { color: look.colour('paper'), width: 1.5 } },
        hovertemplate: 'least objective %{y:.5f}<br>at %{text}<extra></extra>',
      },
      ...bars.map(({ title, range, colour }, i) => ({
        mode: 'lines+markers', yaxis: 'y2', x: range.map(axis.of), y: [level(i), level(i)],
        line: { color: look.colour(colour), width: 5 },
        marker: { color: look.colour(colour), size: 11, symbol: 'line-ns-open', line: { width: 2.5 } },
        text: [plain(title + ': ' + rangeText(range, one.parameter.unit))], hovertemplate: '%{text}<extra></extra>',
      })),
    ],
    layout: {
      margin: { l: 70, r: 12, t: 10, b: 44 },
      xaxis: { ...axis.layout, anchor: 'y2' },
      yaxis: {
        title: 'least objective OF [-]', domain: [0.32, 1], range: [low, top + 0.05 * (top - low)], zeroline: false,
        nticks: 6,
      },
      yaxis2: {
        domain: [0, 0.2], range: [0.4, bars.length + 0.6], tickmode: 'array', tickvals: bars.map((_, i) => level(i)),
        ticktext: bars.map(({ title }) => title), showgrid: false, zeroline: false, fixedrange: true,
      },
      shapes: [
        {
          type: 'line', xref: 'paper', x0: 0, x1: 1, y0: limit, y1: limit,
          line: { color: look.colour('muted'), width: 1.2, dash: 'dash' },
        },
      ],
      annotations: [
        {
          xref: 'paper',
          x: Math.min(0.8, Math.max(0.2, axis.share((ends[0] + ends[1]) / 2))), // between the ends, where the curve lies below the label
          y: limit,
          xanchor: 'center',
          yanchor: 'bottom',
          showarrow: false,
          text: 'visibly worse above',
          font: { size: 11.5, color: look.colour('muted') },
        },
      ],
    },
  };
}
