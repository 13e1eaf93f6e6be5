import { chosen } from '../choice.js';
import { element, empty, strong } from '../dom.js';
import { devices } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, deviation, isNumber, limitText, withUnit } from '../text.js';
import { assessmentData, isVerified, verdictBadge } from '../verdicts.js';

export const assessmentsFigure = {
  id: 'assessments',
  title: 'Against the rule set',
  long: true,
  depends: ['tested'],
  wanted: () => chosen.tested !== null && devices.some((device) => device.assessments.length > 0),
  caption: () =>
    (devices.length > 1
      ? devices[chosen.tested].name + ' alone; the lot follows below.'
      : 'Block ' + devices[chosen.tested].counting_block + ', ' + devices[chosen.tested].counting_block_choice + '.') +
    (isVerified() ? '' : ' Deviations are given without a verdict.'),
  csv: () => assessmentData([devices[chosen.tested]]),
  build: assessmentTable,
};

function assessmentTable() {
  const device = devices[chosen.tested];
  if (device.assessments.length === 0)
    return empty(device.name + ' was not assessed' + (device.properties_refusal ? ': ' + device.properties_refusal : '.'));
  const verdict = (a) =>
    element('td', { class: 'reasoned' }, verdictBadge(a.verdict), a.reason ? element('small', {}, a.reason) : null);
  const columns = [
    { title: 'Quantity', pinned: true, cell: (a) => strong(a.quantity) },
    { title: 'Verdict', cell: verdict },
    { title: 'Block', number: true, cell: (a) => (isNumber(a.block) && a.block > 0 ? String(a.block) : DASH) },
    { title: 'Value', number: true, cell: (a) => withUnit(a.value, a.unit) },
    { title: 'Design value', number: true, cell: (a) => withUnit(a.nominal, a.unit) },
    { title: 'Deviation', number: true, cell: (a) => deviation(a.deviation_percent) },
    { title: 'Limits', cell: (a) => element('td', { class: 'tight' }, limitText(a.limit)) },
    { title: 'Formula', cell: (a) => a.formula },
    { title: 'Clause', cell: (a) => element('td', { class: 'note clause' }, a.clause) },
  ];
  return tableOf(columns, device.assessments, 'Assessment of the chosen device');
}
