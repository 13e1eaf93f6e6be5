import { chosen } from './choice.js';
import { curve, devices } from './report.js';
import { KN, MM } from './units.js';

export const rawIndex = (raw, k) => Math.min(k * raw.stride, raw.samples - 1);

function valueAt(raw, values, index) {
  const k = Math.min(Math.max(0, Math.floor(index / raw.stride)), values.length - 2);
  const from = rawIndex(raw, k),
    to = rawIndex(raw, k + 1);
  return values[k] + ((index - from) / (to - from || 1)) * (values[k + 1] - values[k]);
}

export function slice(raw, values, first, last) {
  if (values.length < 2) return [...values];
  const inside = values.filter((_, k) => rawIndex(raw, k) > first && rawIndex(raw, k) < last);
  return [valueAt(raw, values, first), ...inside, valueAt(raw, values, last)];
}

export function rawTime(device) {
  const { raw } = device;
  const t = raw?.time_s ? curve(raw.time_s) : null;
  const timed = t !== null && t.length > 1;
  return {
    timed,
    title: timed ? 'time [s]' : 'sample',
    of: (index) => (timed ? valueAt(raw, t, index) : index),
  };
}

export function rawData() {
  const device = devices[chosen.tested],
    raw = device.raw,
    axis = rawTime(device);
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  let position = 0;
  const spans = device.blocks.flatMap((block) => block.cycles.map((cycle) => ({ block, cycle })));
  return {
    columns: ['sample', ...(axis.timed ? ['time [s]'] : []), 'displacement [' + MM + ']', 'force [' + KN + ']', 'block', 'cycle'],
    rows: x.map((value, k) => {
      const index = rawIndex(raw, k);
      while (position < spans.length && spans[position].cycle.last < index) ++position;
      const span = spans[position];
      const inside = span !== undefined && index >= span.cycle.first;
      return [
        index,
        ...(axis.timed ? [axis.of(index)] : []),
        value,
        F[k],
        inside ? span.block.number : null,
        inside && span.cycle.counts ? span.cycle.number : null,
      ];
    }),
  };
}
