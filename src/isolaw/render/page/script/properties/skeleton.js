import { chosen } from '../choice.js';
import { counted } from '../cycles.js';
import { panelHeading } from '../plotting.js';
import { curve, devices, resultData } from '../report.js';
import { fixed, isNumber, plain } from '../text.js';
import { KN, KN_MM, LOOP_HOVER, MM, hovered } from '../units.js';

const isSeveral = (device) => device.skeleton?.filter(({ cycle }) => cycle === 1).length > 1;

export const skeletonFigure = {
  id: 'skeleton',
  title: 'Skeleton curve, energy so far and decay of stiffness',
  depends: ['tested'],
  wanted: () => devices.some(isSeveral),
  caption: skeletonCaption,
  csv: () => resultData('skeleton', devices.flatMap((device) => (device.skeleton ?? []).map((point) => [device.name, point])), ['device']),
  height: () => 430,
  draw: drawSkeleton,
};

function skeletonCaption() {
  const device = devices[chosen.tested];
  const last = device.blocks.flatMap(counted).at(-1);
  return (
    'Left: peaks of the first (solid) and the third cycle (dashed) of each amplitude, over the measured loops. Right, over the cycles that count: work of the force since the first sample, and K_eff over that of the first cycle of the record (filled) and of its block (hollow).' +
    (isNumber(last?.K_eff_in_test) ? ' In the last cycle K_eff is ' + fixed(last.K_eff_in_test, 2) + ' of that of the first.' : '')
  );
}

function drawSkeleton(look) {
  const device = devices[chosen.tested];
  const cycles = device.blocks.flatMap((block, place) => counted(block).map((cycle) => ({ block, place, cycle })));
  const points = (number) => (device.skeleton ?? []).filter(({ cycle }) => cycle === number);
  // The line runs along the negative side, has a gap, and runs along the positive side.
  const along = (some) => [
    ...[...some].reverse().map((point) => [point.d_minus_mm, point.F_minus_kN]), [null, null],
    ...some.map((point) => [point.d_plus_mm, point.F_plus_kN]),
  ];
  const skeleton = (number, name, colour, dash, symbol) => {
    const path = along(points(number));
    return {
      name, mode: 'lines+markers', x: path.map(([x]) => x), y: path.map(([, y]) => y), showlegend: true,
      line: { color: look.colour(colour), width: 2, dash }, marker: { color: look.colour(colour), symbol, size: 7 },
      hovertemplate: LOOP_HOVER + '<extra>' + name + '</extra>',
    };
  };
  const ofCycle = ({ block, cycle }) => plain('block ' + block.number + ', cycle ' + cycle.number);
  const course = (key, axis, open, text) => ({
    mode: 'markers', showlegend: false, xaxis: 'x' + axis, yaxis: 'y' + axis, x: cycles.map((_, i) => i + 1),
    y: cycles.map(({ cycle }) => cycle[key]), text: cycles.map(ofCycle),
    marker: {
      size: 6, symbol: open ? 'circle-open' : 'circle', color: cycles.map(({ place }) => look.law({ index: place })),
    },
    hovertemplate: '%{text}: ' + text + '<extra></extra>',
  });
  const right = { range: [0.4, cycles.length + 0.6], domain: [0.62, 1], zeroline: false, tickformat: 'd' };
  return {
    traces: [
      {
        mode: 'lines', x: curve(device.raw.disp_mm), y: curve(device.raw.force_kN),
        line: { color: look.colour('faint'), width: 0.8 }, hoverinfo: 'skip', showlegend: false,
      },
      skeleton(1, 'first cycle', 'cycle-first', 'solid', 'circle'),
      skeleton(3, 'third cycle', 'cycle-last', 'dash', 'square'),
      course('work_kN_mm', 2, false, hovered('y', 'kN mm', 0)),
      course('K_eff_in_test', 3, false, '%{y:.3f} of the first of the record'),
      course('K_eff_in_block', 3, true, '%{y:.3f} of the first of its block'),
    ],
    layout: {
      showlegend: true,
      margin: { l: 58, r: 12, t: 30, b: 44 },
      annotations: [panelHeading(look, 0.62, 1.0, 'energy so far'), panelHeading(look, 0.62, 0.44, 'K_eff over the first')],
      xaxis: { title: 'displacement [' + MM + ']', domain: [0, 0.52] },
      yaxis: { title: 'force [' + KN + ']' },
      xaxis2: { ...right, anchor: 'y2', showticklabels: false },
      yaxis2: { title: 'energy [' + KN_MM + ']', domain: [0.56, 1], anchor: 'x2', rangemode: 'tozero' },
      xaxis3: { ...right, anchor: 'y3', title: 'cycle, in the order of the test' },
      yaxis3: { title: 'ratio', domain: [0, 0.44], anchor: 'x3', rangemode: 'tozero' },
    },
  };
}
