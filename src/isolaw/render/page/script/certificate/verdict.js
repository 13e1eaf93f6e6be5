import { devices } from '../report.js';

export function deviceVerdict(device) {
  const { verdict } = device;
  const named = (wanted) => [
    ...new Set(device.assessments.filter((a) => a.verdict === wanted).map((a) => a.quantity)),
  ];
  return { verdict, failed: named('fail'), open: verdict === 'pass' ? named('not assessed') : [] };
}

export const sameRecord = (device) => (device.copy_of ? 'the same record as ' + device.copy_of : '');

// Returns the quantities that are "not assessed" on every device that has any assessment. The certificate names them
// once instead of in every row. The list is empty if no device passes, because only rows of passing devices name such
// quantities.
export function commonlyOpen() {
  const judged = devices.filter((device) => device.assessments.length > 0 && !device.copy_of);
  if (judged.length === 0 || judged.every((device) => deviceVerdict(device).verdict !== 'pass')) return [];
  const open = (device) => device.assessments.filter((a) => a.verdict === 'not assessed').map((a) => a.quantity);
  return [...new Set(open(judged[0]))].filter((quantity) => judged.every((device) => open(device).includes(quantity)));
}
