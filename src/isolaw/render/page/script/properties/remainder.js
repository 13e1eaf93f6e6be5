import { chosen } from '../choice.js';
import { paddedRange } from '../plotting.js';
import { rawTime } from '../raw.js';
import { curve, devices } from '../report.js';
import { enumerate, significant } from '../text.js';
import { KN, MM, hovered } from '../units.js';

function channelOf({ force_kN, disp_mm, gaps }) {
  const values = [...curve(force_kN ?? disp_mm)];
  for (const k of gaps) values[k] = null;
  return force_kN ? { name: 'force', values, unit: 'kN', shown: KN } : { name: 'displacement', values, unit: 'mm', shown: MM };
}

const indexOf = ({ first, stride, samples }, k) => first + Math.min(k * stride, samples - 1);

export const remainderFigure = {
  id: 'remainder',
  title: 'A doubtful channel less its mean loop, over time',
  depends: ['tested'],
  wanted: () => devices.some((device) => device.remainder),
  caption: remainderCaption,
  csv: remainderData,
  height: () => 260,
  draw: drawRemainder,
};

function remainderCaption() {
  const device = devices[chosen.tested],
    found = device.remainder;
  if (!found) return 'No channel of this record is in doubt.';
  const { timed } = rawTime(device);
  return (
    'The ' + channelOf(found).name + ' in block ' + found.block + ', less the mean of the cycles of this block at the same part of the cycle. A sound channel leaves its noise, and in the first cycle what the device softens.' +
    (found.at.length > 0 ? ' Red lines: where a warning finds a change, at ' + enumerate(found.at.map((at) => (timed ? significant(at, 4) + ' s' : 'sample ' + (at + 1))), 5) + '.' : '')
  );
}

function remainderData() {
  const device = devices[chosen.tested],
    found = device.remainder,
    axis = rawTime(device);
  if (!found) return { columns: ['sample'], rows: [] };
  const { name, values, shown } = channelOf(found);
  return {
    columns: [axis.title, name + ' less the mean loop [' + shown + ']'],
    rows: values.map((value, k) => [axis.of(indexOf(found, k)), value]).filter(([, value]) => value !== null),
  };
}

function drawRemainder(look) {
  const device = devices[chosen.tested],
    found = device.remainder,
    axis = rawTime(device);
  const { name, values, unit, shown } = found ? channelOf(found) : { name: '', values: [], unit: 'kN', shown: KN };
  // The values are large in the first half of the first cycle, in which the device goes from rest to its steady loop.
  // The scale of the axis ignores them.
  const { first, last } = found ? device.blocks[found.block - 1].cycles.find((cycle) => !cycle.partial) : {};
  const later = values.filter((value, k) => value !== null && indexOf(found, k) > (first + last) / 2);
  return {
    traces: [
      {
        mode: 'lines', x: values.map((_, k) => axis.of(indexOf(found, k))), y: values,
        line: { color: look.colour('measured'), width: 1.2 },
        hovertemplate: (axis.timed ? '%{x:.2f} s, ' : 'sample %{x}, ') + hovered('y', unit, 2) + '<extra></extra>',
      },
    ],
    layout: {
      shapes: (found?.at ?? []).map((at) => ({
        type: 'line', yref: 'y domain', x0: at, x1: at, y0: 0, y1: 1, line: { color: look.colour('poor'), width: 1.2 },
      })),
      xaxis: { title: axis.title, zeroline: false },
      yaxis: { title: name + ' less the mean [' + shown + ']', ...(later.length > 0 ? { range: paddedRange(later, 0.1) } : {}) },
    },
  };
}
