import { chosen } from '../choice.js';
import { amplitudeText, counted, countedCycles, cycleText, largestNumber, noCycles } from '../cycles.js';
import { rawData, rawIndex, rawTime } from '../raw.js';
import { curve, devices, inspection } from '../report.js';
import { THIN, count, enumerate, isNumber, plain, significant } from '../text.js';
import { cycleScale, shareOf } from './scale.js';
import { MM, hovered } from '../units.js';

export const cycleHistoryFigure = {
  id: 'cycle-history',
  title: 'Displacement history with blocks and cycles',
  depends: ['tested'],
  // In an inspection whose devices have one block each, the loops are coloured by cycle and already show what the
  // history would show.
  wanted: () => chosen.tested !== null && !(inspection && devices.every((device) => device.blocks.length === 1 || device.status !== 'ok')),
  caption: cycleHistoryCaption,
  csv: rawData,
  height: () => 320,
  draw: drawCycleHistory,
};

function cycleHistoryCaption() {
  const device = devices[chosen.tested];
  const reasons = new Map();
  for (const cycle of device.blocks.flatMap((block) => block.cycles))
    if (!cycle.counts) reasons.set(cycle.reason, (reasons.get(cycle.reason) ?? 0) + 1);
  const said = [...reasons].map(([reason, times]) => reason + (times > 1 ? ' (' + times + ' times)' : ''));
  return (
    (device.blocks.length === 0
      ? 'No cycles: ' + noCycles(device)
      : count(device.blocks.length, 'block') + ', ' + count(countedCycles(device).length, 'cycle') + ' counted.') +
    (said.length > 0 ? ' Pale and marked \u2013, not counted: ' + enumerate(said, 4) + '.' : '') +
    (!inspection && device.scored ? ' Bar along the bottom: the part used for the fit.' : '')
  );
}

function drawCycleHistory(look, width) {
  const device = devices[chosen.tested],
    raw = device.raw,
    axis = rawTime(device),
    colour = cycleScale(look),
    largest = largestNumber(device);
  const x = curve(raw.disp_mm);
  const margin = { l: 58, r: 12, t: 26, b: 44 };
  const perSample = (width - margin.l - margin.r) / raw.samples;
  const [STRIP, BOTTOM] = [0.84, 0];
  const shapes = [],
    annotations = [],
    marks = { x: [], text: [] };
  const strip = (x0, x1, y0, y1, look) =>
    shapes.push({ type: 'rect', yref: 'y2', x0: axis.of(x0), x1: axis.of(x1), y0, y1, line: { width: 0 }, ...look });
  const write = (index, y, text, size, color, xanchor = 'center') =>
    annotations.push({
      x: axis.of(index), y, yref: 'y2', text, showarrow: false, xanchor, yanchor: 'bottom', font: { size, color },
      borderpad: 0,
    });
  for (const block of device.blocks) {
    const first = block.cycles[0].first,
      last = block.cycles[block.cycles.length - 1].last;
    const amplitude = amplitudeText(block);
    const frequency = isNumber(block.frequency_Hz) ? ', ' + significant(block.frequency_Hz, 2) + THIN + 'Hz' : '';
    const name = 'Block ' + block.number;
    const fitting = [name + ': ' + amplitude + frequency, name + ': ' + amplitude, name, String(block.number)].find(
      (text) => 6.8 * text.length < perSample * (last - first),
    );
    strip(first, last, 0.58, 0.6, { fillcolor: look.colour('muted') });
    if (fitting) write(first, 0.62, plain(fitting), 11.5, look.colour('ink'), 'left');
    const narrowest = Math.min(...counted(block).map((cycle) => cycle.last - cycle.first)) * perSample;
    const every = Math.max(1, Math.ceil((6 + 7 * String(counted(block).length).length) / narrowest));
    for (const cycle of block.cycles) {
      const middle = (cycle.first + cycle.last) / 2,
        gap = Math.min(1 / perSample, 0.1 * (cycle.last - cycle.first));
      marks.x.push(axis.of(middle));
      marks.text.push(plain(cycleText(block, cycle)));
      if (cycle.counts) {
        strip(cycle.first + gap, cycle.last - gap, 0.02, 0.14, { fillcolor: colour(shareOf(cycle, largest)) });
        if (cycle.number % every === 1 % every)
          write(middle, 0.17, String(cycle.number), 11, colour(shareOf(cycle, largest)));
      } else {
        write(middle, 0.17, '\u2013', 11, look.colour('muted'));
        shapes.push({
          type: 'rect', layer: 'below', yref: 'y domain', x0: axis.of(cycle.first), x1: axis.of(cycle.last), y0: 0,
          y1: 1, fillcolor: look.colour('uncounted'), line: { width: 0.8, dash: 'dot', color: look.colour('muted') },
        });
      }
    }
  }
  for (const { from, to } of (!inspection && device.scored) || [])
    shapes.push({
      type: 'rect', yref: 'y domain', x0: from, x1: to, y0: BOTTOM, y1: 0.03,
      fillcolor: look.colour('accent'), line: { width: 0 },
    });
  return {
    traces: [
      {
        mode: 'lines',
        x: x.map((_, k) => axis.of(rawIndex(raw, k))),
        y: x,
        line: { color: look.colour('measured'), width: 1.3 },
        hovertemplate: axis.timed
          ? '%{x:.2f} s, ' + hovered('y', 'mm', 1) + '<extra></extra>'
          : 'sample %{x}, ' + hovered('y', 'mm', 1) + '<extra></extra>',
      },
      {
        mode: 'markers', x: marks.x, y: marks.x.map(() => 0.2), yaxis: 'y2', text: marks.text,
        marker: { size: 16, opacity: 0, color: look.colour('muted') }, hovertemplate: '%{text}<extra></extra>',
      },
    ],
    layout: {
      margin,
      shapes,
      annotations,
      xaxis: { title: axis.title, zeroline: false, range: [axis.of(0), axis.of(raw.samples - 1)] },
      yaxis: { title: 'displacement [' + MM + ']', domain: [0, STRIP - 0.03], automargin: false },
      yaxis2: { domain: [STRIP, 1], range: [0, 1], visible: false, fixedrange: true },
    },
  };
}
