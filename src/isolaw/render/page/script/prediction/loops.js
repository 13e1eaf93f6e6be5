import { chosen } from '../choice.js';
import { deviceChooser, lawChooser } from '../choosers.js';
import { blockText } from '../cycles.js';
import { fitsOn, forceRange, record } from '../loops/fits.js';
import { NARROW, emptyPlot, panelHeading } from '../plotting.js';
import { rawTime } from '../raw.js';
import { devices, drawable, laws, predictedByFit } from '../report.js';
import { THIN, enumerate, fixed, mean, plain, significant } from '../text.js';
import { KN, LOOP_HOVER, MM } from '../units.js';

const PANEL_HEIGHT = 300;

export const predictedLoopsFigure = {
  id: 'predicted-loops',
  title: 'Measured and predicted loops',
  depends: ['device', 'predicted'],
  wanted: () => chosen.device !== null && drawable.some((device) => keptBlocks(device).length > 0),
  controls: () => [
    deviceChooser('predicted-device', drawable, 'device'),
    ...(predictedByFit.length > 1
      ? [lawChooser('predicted', predictedByFit.slice(1), { id: 'predicted-law', title: 'Beside ' + predictedByFit[0].name })]
      : []),
  ],
  caption: predictedCaption,
  csv: predictedData,
  height: (width) => (width < NARROW ? 2 : 1) * PANEL_HEIGHT,
  draw: drawPredicted,
};

function keptBlocks(device) {
  const kept = predictedByFit.flatMap((law) => law.fitOn.get(device.index)?.blocks ?? []).filter(({ fitted }) => !fitted);
  return device.blocks.filter(({ number }) => kept.some(({ block }) => block === number));
}

function predicted() {
  const device = devices[chosen.device];
  const { t, x, F } = record(device),
    axis = rawTime(device);
  const fits = fitsOn(device, [predictedByFit[0], laws[chosen.predicted]].filter(Boolean));
  const blocks = keptBlocks(device);
  const inside = blocks.map(({ cycles }) => {
    const [from, to] = [axis.of(cycles[0].first), axis.of(cycles[cycles.length - 1].last)];
    return t.map((time, i) => (time >= from && time <= to ? i : -1)).filter((i) => i >= 0);
  });
  // All blocks form one line of the plot. The nulls make gaps between them.
  const of = (values) => inside.flatMap((places) => [...places.map((i) => values[i]), null]);
  return { device, blocks, fits: fits.map((one) => ({ ...one, force: of(one.force) })), t: of(t), x: of(x), F: of(F) };
}

const ends = (values) => values.filter((value) => value !== null);
const rangeOf = ({ F, fits }) => forceRange(ends(F), fits.map(({ force }) => ends(force)));

function predictedCaption() {
  const all = predicted(),
    { device, blocks, fits, F } = all;
  if (ends(F).length === 0) return 'No block of ' + device.name + ' was left out of the fit.';
  const objective = ({ fit }) => mean(fit.blocks.filter(({ fitted }) => !fitted).map((score) => score.objective));
  const said = fits.map((one) => one.law.name + ': OF ' + (objective(one) < 10 ? fixed(objective(one), 4) : significant(objective(one), 3)));
  const [low, high] = rangeOf(all);
  const away = fits.filter(({ force }) => ends(force).some((f) => f < low || f > high));
  const largest = ({ law, force }) => law.name + ' to ' + significant(Math.max(...ends(force).map(Math.abs)), 2) + THIN + KN;
  return (
    device.name + ', ' + enumerate(blocks.map(blockText)) + ', left out of the fit: measured (grey) and predicted loops, the best prediction first. ' +
    said.join('; ') + '.' + (away.length > 0 ? ' Off the scale: ' + enumerate(away.map(largest)) + '.' : '')
  );
}

function predictedData() {
  const { fits, t, x, F } = predicted();
  return {
    columns: ['time [s] or sample', 'displacement [' + MM + ']', 'measured force [' + KN + ']', ...fits.map(({ law }) => law.name + ' force [' + KN + ']')],
    rows: t.map((time, i) => [time, x[i], F[i], ...fits.map(({ force }) => force[i])]).filter(([time]) => time !== null),
  };
}

function drawPredicted(look, width) {
  const all = predicted(),
    { device, fits, x, F } = all;
  if (ends(F).length === 0) return emptyPlot(look, 'no block of ' + device.name + ' was left out of the fit');
  const stacked = width < NARROW,
    gap = stacked ? 0.16 : 0.07,
    size = (1 - gap) / 2,
    range = rangeOf(all);
  const layout = { margin: { l: 58, r: 10, t: 26, b: 44 }, annotations: [] };
  const traces = fits.flatMap(({ law, force }, i) => {
    const suffix = i === 0 ? '' : '2',
      along = [i * (size + gap), i * (size + gap) + size],
      up = [1 - along[1], 1 - along[0]];
    layout['xaxis' + suffix] = {
      domain: stacked ? [0, 1] : along, anchor: 'y' + suffix, title: stacked && i === 0 && fits.length > 1 ? '' : 'displacement [' + MM + ']',
    };
    layout['yaxis' + suffix] = {
      domain: stacked ? up : [0, 1], anchor: 'x' + suffix, range, title: stacked || i === 0 ? 'force [' + KN + ']' : '', automargin: false,
    };
    layout.annotations.push(panelHeading(look, stacked ? 0 : along[0], stacked ? up[1] : 1, '<b>' + plain(law.name) + '</b>', 12.5));
    const axes = { xaxis: 'x' + suffix, yaxis: 'y' + suffix, mode: 'lines', x };
    return [
      { ...axes, y: F, hoverinfo: 'skip', opacity: 0.75, line: { color: look.colour('measured'), width: 3 } },
      {
        ...axes, y: force, line: { color: look.law(law), width: 1.7 },
        hovertemplate: LOOP_HOVER + '<extra>' + plain(law.name) + '</extra>',
      },
    ];
  });
  return { traces, layout };
}
