// The results of `isolaw conditions` as the page shows them: how temperature, frequency, load, ageing and history change
// the properties of devices.

import { chosen } from '../choice.js';
import { report } from '../report.js';
import { DASH, THIN, count, fixed, isNumber, trimmed } from '../text.js';
import { KN } from '../units.js';

export const conditions = report.conditions ?? null;
// The warnings about the conditions.
export const findings = report.findings.warnings.filter(({ topic }) => topic === 'conditions');

// The effects whose condition is a number. The conditions of ageing and history are not single numbers.
const CONDITIONS = {
  temperature: { key: 'temperature_C', title: 'temperature', unit: '\u00b0C' },
  rate: { key: 'frequency_Hz', title: 'frequency', unit: 'Hz', log: true },
  load: { key: 'load_kN', title: 'vertical load', unit: KN },
};
export const conditionOf = (effect) => CONDITIONS[effect] ?? null;

// The keys under which the objects of tests and of cycles hold each property.
export const KEYS = { K_eff: 'K_eff_kN_per_mm', damping: 'damping_percent', energy: 'energy_kN_mm', Q_d: 'Q_d_kN', K_d: 'K_d_kN_per_mm' };

// The status of a factor, from the best supported by tests to the least, and the colour that shows it.
const STATUSES = {
  shown: 'good', interpolated: 'accent', extrapolated: 'care', unpaired: 'care', scaled: 'care', assumed: 'poor', 'not covered': 'poor',
};
export const toneOf = (status) => STATUSES[status];
export const statusesAmong = (among) => Object.keys(STATUSES).filter((status) => among.includes(status));
const IN_CAPITALS = ['assumed', 'not covered'];
export const statusWord = (status) => (IN_CAPITALS.includes(status) ? status.toUpperCase() : status);
export const factorText = (value) => fixed(value, 3);
export const intervalText = (interval) => factorText(interval.low) + ' to ' + factorText(interval.high);
// Returns the status of a factor as text. If no device shows the factor and it is neither assumed nor "not covered", it
// is the factor 1 of the reference itself. `all` is given for the bound of all effects together, which has no devices
// of its own.
export const statusText = ({ status, devices, all = null }) =>
  devices === 0 && !all && !IN_CAPITALS.includes(status)
    ? 'reference'
    : statusWord(status) + (devices > 0 ? ' on\u00a0' + count(devices, 'device').replace(' ', '\u00a0') : '');

export const allLevels = conditions?.levels ?? [];
const among = (all) => (effect, quantity) => all.filter((one) => one.effect === effect && one.quantity === quantity);
export const levelsOf = among(allLevels);
export const endsOf = among(conditions?.ends ?? []);
export const curvesOf = among(report.condition_curves ?? []);
export const referenceAt = (effect) => conditions.reference[conditionOf(effect)?.key] ?? null;
export const rangeOf = (effect) => conditions.design_conditions[conditionOf(effect)?.key] ?? null;
export const atText = (effect, at) => trimmed(at, 3) + THIN + conditionOf(effect).unit;
export const agedText = ({ days, at_C: at }) => trimmed(days) + ' days at ' + trimmed(at) + THIN + '\u00b0C';
export const levelText = ({ effect, at, level, aged_days: days, aged_at_C: atC }) =>
  conditionOf(effect) ? atText(effect, at) : isNumber(days) ? agedText({ days, at_C: atC }) : level;

export const EFFECTS = [...new Set([...allLevels, ...(conditions?.design ?? [])].map(({ effect }) => effect))];
const has = (quantity) => allLevels.some((level) => level.quantity === quantity);
// Groups of properties; the figures show the group that the reader chooses.
export const PROPERTIES = [['K_eff', 'damping'], ['energy'], ['Q_d', 'K_d']].map((group) => group.filter(has)).filter((group) => group.length > 0);
export const chosenProperties = () => PROPERTIES[Number(chosen.conditionsGroup)] ?? [];

// Tests whose loop is known. A device that was tested under several conditions has its loops drawn over each other.
const testsWithLoop = (conditions?.tests ?? []).filter((test) => test.loop_mm.length > 0);
export const testsOf = (device) => testsWithLoop.filter((test) => test.device === device);
export const loopDevices = [...new Set(testsWithLoop.map(({ device }) => device))].filter((device) => testsOf(device).length > 1);
const stiffnessRatio = (device) => {
  const values = testsOf(device).map((test) => test.K_eff_kN_per_mm).filter(isNumber);
  return Math.max(...values) / Math.min(...values);
};
// At first the page shows the device with the largest ratio between its largest and its smallest K_eff.
Object.assign(chosen, {
  conditionsGroup: '0', // index in PROPERTIES, as text
  conditionsDevice: [...loopDevices].sort((a, b) => stiffnessRatio(b) - stiffnessRatio(a))[0] ?? null,
});

export const cyclesText = ({ first_cycle: first, last_cycle: last }) =>
  first === last ? 'cycle ' + first : 'mean of cycles ' + first + ' to ' + last;
// The loop shown is a single cycle, the first, even if the values at reference are means over several cycles.
export const referenceCycle = () => cyclesText({ ...conditions.reference, last_cycle: conditions.reference.first_cycle });
export const restText = (hours) => (isNumber(hours) ? trimmed(hours) + THIN + 'h' : DASH);

// Returns ticks with round numbers for a logarithmic axis of factors.
export function factorTicks(low, high) {
  const all = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.5, 1.75, 2, 2.5, 3, 4, 5].filter((value) => value >= low && value <= high);
  const every = Math.ceil(all.length / 7);
  const one = all.indexOf(1);
  return all.filter((_, i) => (i - one) % every === 0);
}
