import { chosen } from '../choice.js';
import { dashOf, paddedRange } from '../plotting.js';
import { curve, devices, ranking } from '../report.js';
import { THIN, enumerate, plain, significant } from '../text.js';
import { KN, MM } from '../units.js';

export const LOOP_HEIGHT = 400;

export function fitsOn(device, among) {
  return among
    .map((law) => ({ law, fit: law.fitOn.get(device.index), force: curve(law.fitOn.get(device.index)?.force_kN) }))
    .filter((entry) => entry.force);
}

export const chosenLaws = () => ranking.filter((law) => chosen.laws.has(law.index));

export const record = (device) => ({
  t: curve(device.record.time_s),
  x: curve(device.record.disp_mm),
  F: curve(device.record.force_kN),
});

export const measuredCurve = (look, x, y, hover) => ({
  name: 'measured', mode: 'lines', x, y, line: { color: look.colour('measured'), width: 3.5 }, opacity: 0.75,
  hovertemplate: hover + '<extra>measured</extra>',
});

export const fitCurves = (look, fits, x, hover) =>
  fits.map(({ law, force }, place) => ({
    name: plain(law.name), mode: 'lines', x, y: force, line: { color: look.law(law), width: 1.8, dash: dashOf(place) },
    hovertemplate: hover + '<extra>' + plain(law.name) + '</extra>',
  }));

export const isScored = (device, time) =>
  !device.scored || device.scored.some(({ from, to }) => time >= from && time <= to);

export const isLargeSwing = (device, time) => device.large_swings.some(({ from, to }) => time >= from && time <= to);

// Returns the range of forces to draw. It includes all measured forces. Computed forces extend it by at most half of
// the measured range on each side; computed forces beyond it are cut off.
export function forceRange(measured, computed) {
  const low = Math.min(...measured),
    high = Math.max(...measured),
    spare = 0.5 * (high - low || 1);
  const all = computed.flatMap((force) => [Math.min(...force), Math.max(...force)]).concat(low, high);
  return paddedRange(all.map((force) => Math.min(Math.max(force, low - spare), high + spare)), 0.06);
}

// Returns the chosen device, its record, the fits of the laws `among` to it, and the range of forces to draw.
export function shownLoops(among = chosenLaws()) {
  const device = devices[chosen.device],
    measured = record(device),
    fits = fitsOn(device, among);
  return { device, measured, fits, range: forceRange(measured.F, fits.map(({ force }) => force)) };
}

export function cutOff(among) {
  const { fits, range: [low, high] } = shownLoops(among);
  const away = fits.filter(({ force }) => force.some((f) => f < low || f > high));
  if (away.length === 0) return '';
  const largest = ({ law, force }) => law.name + ' to ' + significant(Math.max(...force.map(Math.abs)), 2) + THIN + KN;
  return ' Off the scale: ' + enumerate(away.map(largest)) + '.';
}

export function loopData(among) {
  const { device, measured, fits } = shownLoops(among);
  const forces = ['measured', ...fits.map(({ law }) => law.name)].map((name) => name + ' force [' + KN + ']');
  return {
    columns: [device.record.has_time ? 'time [s]' : 'sample', 'displacement [' + MM + ']', ...forces],
    rows: measured.x.map((x, i) => [measured.t[i], x, measured.F[i], ...fits.map(({ force }) => force[i])]),
  };
}
