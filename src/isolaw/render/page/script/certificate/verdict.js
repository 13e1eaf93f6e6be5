import { devices, report } from '../report.js';
import { worstVerdict } from '../verdicts.js';

// A rule set that could say nothing of a device, for its record has no properties.
export const isLeftOut = (device) =>
  Boolean(report.assessment?.rule_set) && device.assessments.length === 0 && Boolean(device.properties_refusal);

// The worst of a device's verdicts, with what could not be assessed of it.
export function deviceVerdict(device) {
  const worst = isLeftOut(device) ? 'not assessed' : worstVerdict(device.assessments.map((a) => a.verdict));
  // Of a device that is tested in shear a compression test alone says too little to pass.
  const inShear = device.assessments.some((a) => a.verdict === 'pass' && a.quantity !== 'K_v');
  const verdict = worst === 'pass' && !inShear ? 'not assessed' : worst;
  const named = (wanted) => [
    ...new Set(device.assessments.filter((a) => a.verdict === wanted).map((a) => a.quantity)),
  ];
  return { verdict, failed: named('fail'), open: verdict === 'pass' ? named('not assessed') : [] };
}

// What no device could be assessed for: said once, for all of them.
export function commonlyOpen() {
  const judged = devices.filter((device) => device.assessments.length > 0);
  if (judged.length === 0 || judged.every((device) => deviceVerdict(device).verdict !== 'pass')) return [];
  const open = (device) => device.assessments.filter((a) => a.verdict === 'not assessed').map((a) => a.quantity);
  return [...new Set(open(judged[0]))].filter((quantity) => judged.every((device) => open(device).includes(quantity)));
}
