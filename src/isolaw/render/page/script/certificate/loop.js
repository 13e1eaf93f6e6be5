import { assessedBlock, assessedCycle } from '../cycles.js';
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
  LEFT = 44,
  BELOW = 34;
const NAMESPACE = 'http://www.w3.org/2000/svg';

function drawn(tag, attributes, text = null) {
  const node = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  if (text !== null) node.textContent = text;
  return node;
}

// Round values from -most to most, about three on each side of zero.
function ticks(most) {
  const rough = most / 2.5,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((size) => size >= rough);
  const count = Math.floor(most / step);
  return Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * step);
}

// The measured loop of a device as a drawing for paper: the cycle that counts black, all others grey.
export function loopDrawing(device) {
  const { raw } = device;
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  const most = (values) => 1.06 * Math.max(...values.map(Math.abs)) || 1;
  const [mostX, mostF] = [most(x), most(F)];
  const across = (value) => LEFT + ((value / mostX + 1) / 2) * (WIDE - LEFT),
    down = (value) => ((1 - value / mostF) / 2) * (HIGH - BELOW);
  const line = (xs, Fs) => xs.map((value, i) => (i === 0 ? 'M' : 'L') + across(value).toFixed(1) + ' ' + down(Fs[i]).toFixed(1)).join('');
  const svg = drawn('svg', { viewBox: `0 0 ${WIDE} ${HIGH}`, class: 'loop-drawing', role: 'img', 'aria-label': 'Force over displacement of ' + device.name });
  for (const value of ticks(mostX)) {
    svg.append(drawn('path', { d: `M${across(value)} 0V${HIGH - BELOW}`, class: 'grid' }));
    svg.append(drawn('text', { x: across(value), y: HIGH - BELOW + 13, 'text-anchor': 'middle' }, trimmed(value)));
  }
  for (const value of ticks(mostF)) {
    svg.append(drawn('path', { d: `M${LEFT} ${down(value)}H${WIDE}`, class: 'grid' }));
    svg.append(drawn('text', { x: LEFT - 5, y: down(value) + 3.5, 'text-anchor': 'end' }, trimmed(value)));
  }
  svg.append(drawn('path', { d: line(x, F), class: 'all' }));
  const cycle = assessedCycle(device);
  if (cycle) svg.append(drawn('path', { d: line(slice(raw, x, cycle.first, cycle.last), slice(raw, F, cycle.first, cycle.last)), class: 'reported' }));
  const title = (cycle ? 'cycle ' + cycle.number + ' of block ' + assessedBlock(device).number + ' black' : 'whole record') + '; displacement [' + MM + '], force [' + KN + ']';
  svg.append(drawn('text', { x: (WIDE + LEFT) / 2, y: HIGH - 5, 'text-anchor': 'middle' }, title));
  return svg;
}
