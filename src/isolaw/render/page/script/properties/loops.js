import { chosen } from '../choice.js';
import { chosenBlocks, cycleText, largestNumber, noCycles } from '../cycles.js';
import { peakLabels } from '../labels.js';
import { rawData, slice } from '../raw.js';
import { curve, devices } from '../report.js';
import { count, isNumber, plain } from '../text.js';
import { cycleScale, shareOf } from './scale.js';
import { KN, LOOP_HOVER, MM } from '../units.js';

export const CYCLES_HEIGHT = 470;

export const cyclesFigure = {
  id: 'cycles',
  width: 'wide',
  title: 'Loops, cycle by cycle',
  depends: ['tested', 'block'],
  wanted: () => chosen.tested !== null,
  caption: cyclesCaption,
  csv: rawData,
  height: () => CYCLES_HEIGHT,
  draw: drawCycles,
};

function cyclesCaption() {
  const device = devices[chosen.tested],
    blocks = chosenBlocks(device);
  const uncounted = blocks.flatMap((block) => block.cycles).filter((cycle) => !cycle.counts).length;
  if (device.blocks.length === 0) return device.name + ', as recorded. No cycles: ' + noCycles(device);
  return (
    device.name + ', raw values' +
    (device.corrections.length > 0 ? ' after ' + count(device.corrections.length, 'correction') : '') +
    '. Each loop has its ' + (blocks.length > 1 ? 'block and cycle' : 'number') + ' at its positive peak; the colour runs from the first cycle (orange) to the last (blue).' +
    (uncounted > 0
      ? ' Dashed: ' + count(uncounted, 'cycle') + ' that ' + (uncounted === 1 ? 'does' : 'do') + ' not count.'
      : '') +
    (device.raw.stride > 1 ? ' Drawn: one sample in ' + device.raw.stride + '.' : '')
  );
}

function drawCycles(look, width) {
  const device = devices[chosen.tested],
    raw = device.raw,
    colour = cycleScale(look),
    largest = largestNumber(device);
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  const blocks = chosenBlocks(device);
  const hover = (name) => LOOP_HOVER + '<extra>' + plain(name) + '</extra>';
  const traces = [],
    labels = [];
  if (device.blocks.length === 0)
    traces.push({
      mode: 'lines', x, y: F, line: { color: look.colour('measured'), width: 1.4 }, hovertemplate: hover('no cycle'),
    });
  for (const block of blocks) {
    for (const cycle of [...block.cycles].sort((a, b) => a.number - b.number)) {
      const share = shareOf(cycle, largest);
      traces.push({
        mode: 'lines',
        x: slice(raw, x, cycle.first, cycle.last),
        y: slice(raw, F, cycle.first, cycle.last),
        line: cycle.counts
          ? { color: colour(share), width: 1.6 }
          : { color: look.colour('muted'), width: 1.2, dash: 'dash' },
        hovertemplate: hover(cycleText(block, cycle)),
      });
      if (cycle.counts && isNumber(cycle.d_plus_mm) && isNumber(cycle.F_plus_kN))
        labels.push({
          x: cycle.d_plus_mm, y: cycle.F_plus_kN, number: cycle.number,
          text: (blocks.length > 1 ? block.number + '\u00b7' : '') + cycle.number, color: colour(share),
        });
    }
  }
  const xs = traces.flatMap((trace) => trace.x),
    ys = traces.flatMap((trace) => trace.y);
  const margin = { l: 58, r: 10, t: 26, b: 44 };
  const plotWidth = width - margin.l - margin.r,
    plotHeight = CYCLES_HEIGHT - margin.t - margin.b;
  const extent = (values) => values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
  const [left, right] = extent(xs),
    [low, high] = extent(ys);
  const tail = labels.length > 0 ? 52 : 0; // room for the cycles' numbers at the right
  const wide = right - left || 1,
    tall = high - low || 1;
  const xRange = [left - 0.04 * wide, right + 0.04 * wide + (tail / (plotWidth - tail)) * 1.08 * wide],
    yRange = [low - 0.05 * tall, high + 0.05 * tall];
  const pixel = (px, py) => [
    ((px - xRange[0]) / (xRange[1] - xRange[0])) * plotWidth,
    (1 - (py - yRange[0]) / (yRange[1] - yRange[0])) * plotHeight,
  ];
  return {
    traces,
    layout: {
      margin,
      xaxis: { title: 'displacement [' + MM + ']', range: xRange, automargin: false },
      yaxis: { title: 'force [' + KN + ']', range: yRange, automargin: false },
      annotations: peakLabels(labels, pixel, 26, plotHeight).map((label) => ({
        ...label, color: undefined, text: '<b>' + label.text + '</b>', arrowhead: 0, arrowwidth: 0.8,
        arrowcolor: look.colour('muted'), font: { size: 11.5, color: label.color }, bgcolor: look.colour('paper'),
        borderpad: 0.5,
      })),
    },
  };
}
