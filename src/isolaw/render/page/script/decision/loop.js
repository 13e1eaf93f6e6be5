import { chosen, onChoice } from '../choice.js';
import { deviceChooser } from '../choosers.js';
import { countingCycle } from '../cycles.js';
import { element } from '../dom.js';
import { drawn } from '../figure.js';
import { forceRange, isLargeSwing, isScored, record } from '../loops/fits.js';
import { rawTime } from '../raw.js';
import { curve, devices, drawable, laws } from '../report.js';
import { THIN, errorText, fixed, plain, significant } from '../text.js';
import { KN, LOOP_HOVER, MM, decimalsIn } from '../units.js';

export const MOST_LOOPS = 24; // a lot of more devices is shown as points, not as small loops

export const answerLoopFigure = {
  id: 'answer-loop',
  title: '',
  width: 'wide',
  depends: ['device', 'law'],
  wanted: () => chosen.device !== null,
  controls: drawable.length > MOST_LOOPS ? () => [deviceChooser('answer-device', drawable, 'device')] : null,
  caption: loopCaption,
  height: (width) => (width < 480 ? 320 : 440),
  draw: drawLoop,
  below: timeSlider,
};

// Returns the times [from, to] of the parts of the record that are drawn in black: one cycle of each block. Returns
// null if the record has no cycles; the whole record is then drawn in black.
export function cyclesShown(device) {
  const axis = rawTime(device);
  const cycles = device.blocks.map(countingCycle).filter(Boolean);
  return cycles.length > 0 ? cycles.map(({ first, last }) => [axis.of(first), axis.of(last)]) : null;
}

function shown() {
  const device = devices[chosen.device],
    law = laws[chosen.law],
    { t, x, F } = record(device);
  const fit = law?.fitOn.get(device.index),
    ofFit = fit?.force_kN ? curve(fit.force_kN) : null,
    predicted = fit?.larger_swings_force_kN && !device.scored ? curve(fit.larger_swings_force_kN) : null,
    parts = cyclesShown(device);
  const inside = t.map((time) => !parts || parts.some(([from, to]) => time >= from && time <= to)),
    fitted = t.map((time) => (predicted ? !isLargeSwing(device, time) : isScored(device, time)));
  // A swing is the motion from one turning point to the next. In the larger swings of a test the figure shows the force
  // that was predicted by a fit to the smaller swings. A fit to all swings would be no prediction there.
  const force = predicted ? ofFit.map((value, i) => (fitted[i] ? value : predicted[i])) : ofFit;
  return { device, law, fit, t, x, F, force, predicted, parts, inside, fitted };
}

// Keeps the values where `wanted` is true and one sample beyond on both sides, so that neighbouring lines meet. All
// other values become null.
const where = (values, wanted) => values.map((value, i) => (wanted[i] || wanted[i - 1] || wanted[i + 1] ? value : null));

function loopCaption() {
  const { device, law, fit, force, predicted, parts } = shown();
  const misfit = fit?.objective.best;
  return (
    device.name + (parts ? ', third cycles; other cycles grey.' : ', whole record.') +
    (force ? ' The law was fitted to this device: misfit ' + errorText(misfit) + '.' + (device.scored ? ' Dashed: not fitted.' : '') : '') +
    (predicted ? ' Dashed: predicted from the smaller swings.' : '') +
    (law && !force ? ' ' + law.name + ' has no fit' + (fit?.message ? ': ' + fit.message : '') + '.' : '')
  );
}

function drawLoop(look) {
  const { device, law, t, x, F, force, predicted, parts, inside, fitted } = shown();
  const hover = (name) => LOOP_HOVER + '<extra>' + plain(name) + '</extra>';
  const all = (some) => some.every((value) => value);
  const measured = look.colour('ink'),
    line = (color, width, more = {}) => ({ color, width, ...more });
  const both = (a, b) => a.map((value, i) => value && b[i]);
  const not = (some) => some.map((value) => !value);
  const traces = [
    ...(parts ? [{ mode: 'lines', x, y: F, hoverinfo: 'skip', showlegend: false, line: line(look.colour('faint'), 1) }] : []),
    { name: 'measured', mode: 'lines', x, y: where(F, inside), line: line(measured, 2), hovertemplate: hover('measured') },
  ];
  if (force) {
    const colour = look.law(law);
    traces.push({ name: plain(law.name) + ', fitted', mode: 'lines', x, y: where(force, both(inside, fitted)), line: line(colour, 2), hovertemplate: hover(law.name) });
    if (!all(fitted))
      traces.push({
        name: plain(law.name) + ', never saw this', mode: 'lines', x, y: where(force, both(inside, not(fitted))), line: line(colour, 2, { dash: 'dash' }),
        hovertemplate: hover(law.name + ', not fitted to this'),
      });
  }
  const marks = dots(t, x, F, force);
  traces.push({
    name: 'now', mode: 'markers', showlegend: false, hoverinfo: 'skip', ...marks,
    marker: { size: 11, color: look.colour('paper'), line: { width: 2, color: [measured, ...(force ? [look.law(law)] : [])] } },
  });
  const reach = Math.max(...x.map((value, i) => (fitted[i] ? Math.abs(value) : 0)));
  const beyond = !predicted && Math.max(...x.map(Math.abs)) > 1.05 * reach;
  return {
    traces,
    layout: {
      showlegend: true,
      margin: { l: 54, r: 12, t: 34, b: 44 },
      shapes: beyond
        ? [{ type: 'rect', layer: 'below', yref: 'paper', x0: -reach, x1: reach, y0: 0, y1: 1, line: { width: 0 }, fillcolor: look.colour('tint') }]
        : [],
      annotations: beyond
        ? [{ x: reach, y: 1, yref: 'paper', xanchor: 'right', yanchor: 'top', showarrow: false, text: 'fitted within ±' + significant(reach) + THIN + MM + ' ', font: { size: 11.5, color: look.colour('muted') } }]
        : [],
      xaxis: { title: 'displacement [' + MM + ']' },
      yaxis: { title: 'force [' + KN + ']', range: forceRange(F, force ? [force] : []) },
      uirevision: device.index, // the reader's zoom stays when the law changes
    },
  };
}

// The position of the time slider, from 0 to 1000.
let place = 300;
const sampleAt = (t) => Math.round((place / 1000) * (t.length - 1));

function dots(t, x, F, force) {
  const i = sampleAt(t);
  return { x: force ? [x[i], x[i]] : [x[i]], y: force ? [F[i], force[i]] : [F[i]] };
}

function timeSlider() {
  const output = element('output', { for: 'answer-time' });
  const slider = element('input', { type: 'range', id: 'answer-time', min: 0, max: 1000, value: place });
  const say = () => {
    const { device, law, t, x, F, force } = shown(),
      i = sampleAt(t);
    output.textContent =
      (device.record.has_time ? fixed(t[i], 2) + THIN + 's' : 'sample ' + fixed(t[i], 0)) + ', ' + fixed(x[i], decimalsIn('mm', 1)) + THIN + MM + ': measured ' + fixed(F[i], decimalsIn('kN', 1)) + THIN + KN +
      (force ? ', ' + law.name + ' ' + fixed(force[i], decimalsIn('kN', 1)) + THIN + KN : '');
  };
  slider.oninput = () => {
    place = Number(slider.value);
    const { t, x, F, force } = shown(),
      { body } = drawn.get(answerLoopFigure),
      marks = dots(t, x, F, force);
    if (body.data) Plotly.restyle(body, { x: [marks.x], y: [marks.y] }, [body.data.length - 1]);
    say();
  };
  onChoice(say);
  say();
  return [element('div', { class: 'time screen' }, element('label', {}, 'Time', slider), output)];
}
