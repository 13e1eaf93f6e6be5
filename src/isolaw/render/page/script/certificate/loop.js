import { assessedBlock, assessedCycle } from '../cycles.js';
import { svg } from '../element.js';
import { slice } from '../raw.js';
import { curve, devices, tested } from '../report.js';
import { trimmed } from '../text.js';
import { KN, MM } from '../units.js';

// The certificate of a single device has one page, which shows its loop.
export const certificateLoopFigure = {
  id: 'certificate-loop',
  title: '',
  wanted: () => devices.length === 1 && tested.length === 1,
  build: () => loopDrawing(tested[0]),
};

const WIDE = 330,
  HIGH = 250,
  BELOW = 34;

// Returns round numbers for an axis from -most to most, about three on each side of zero.
function ticks(most) {
  const rough = most / 2.5,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((size) => size >= rough);
  const count = Math.floor(most / step);
  return Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * step);
}

// Draws the measured loop of a device for paper. The cycle whose values stand for the device is black, all other cycles
// are grey.
export function loopDrawing(device) {
  const { raw } = device;
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  const most = (values) => 1.06 * Math.max(...values.map(Math.abs)) || 1;
  const [mostX, mostF] = [most(x), most(F)];
  const left = Math.max(44, 6 + 6 * trimmed(ticks(mostF)[0]).length); // with room for a label such as -1000000
  const across = (value) => left + ((value / mostX + 1) / 2) * (WIDE - left),
    down = (value) => ((1 - value / mostF) / 2) * (HIGH - BELOW);
  const line = (xs, Fs) => xs.map((value, i) => (i === 0 ? 'M' : 'L') + across(value).toFixed(1) + ' ' + down(Fs[i]).toFixed(1)).join('');
  const cycle = assessedCycle(device);
  const title = (cycle ? 'cycle ' + cycle.number + ' of block ' + assessedBlock(device).number + ' black' : 'whole record') + '; displacement [' + MM + '], force [' + KN + ']';
  return svg(
    'svg',
    { viewBox: `0 0 ${WIDE} ${HIGH}`, class: 'loop-drawing', role: 'img', 'aria-label': 'Force over displacement of ' + device.name },
    ...ticks(mostX).flatMap((value) => [
      svg('path', { d: `M${across(value)} 0V${HIGH - BELOW}`, class: 'grid' }),
      svg('text', { x: across(value), y: HIGH - BELOW + 13, 'text-anchor': 'middle' }, trimmed(value)),
    ]),
    ...ticks(mostF).flatMap((value) => [
      svg('path', { d: `M${left} ${down(value)}H${WIDE}`, class: 'grid' }),
      svg('text', { x: left - 5, y: down(value) + 3.5, 'text-anchor': 'end' }, trimmed(value)),
    ]),
    svg('path', { d: line(x, F), class: 'all' }),
    ...(cycle ? [svg('path', { d: line(slice(raw, x, cycle.first, cycle.last), slice(raw, F, cycle.first, cycle.last)), class: 'reported' })] : []),
    svg('text', { x: (WIDE + left) / 2, y: HIGH - 5, 'text-anchor': 'middle' }, title),
  );
}
