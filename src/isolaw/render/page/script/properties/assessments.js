import { chosen } from '../choice.js';
import { element } from '../dom.js';
import { devices } from '../report.js';
import { table } from '../tables.js';
import { DASH, deviation, isNumber, limitText, withUnit } from '../text.js';
import { assessmentData, isVerified, verdictBadge } from '../verdicts.js';

export const assessmentsFigure = {
  id: 'assessments',
  title: 'Against the rule set',
  long: true,
  depends: ['tested'],
  wanted: () => chosen.tested !== null && devices.some((device) => device.assessments.length > 0),
  caption: () =>
    devices[chosen.tested].name + ' alone; the lot follows below.' +
    (isVerified() ? '' : ' Deviations are information, no verdict.'),
  csv: () => assessmentData([devices[chosen.tested]]),
  build: assessmentTable,
};

function assessmentTable() {
  const device = devices[chosen.tested];
  if (device.assessments.length === 0)
    return element(
      'p',
      { class: 'empty' },
      device.name + ' was not assessed' + (device.properties_refusal ? ': ' + device.properties_refusal : '.'),
    );
  const columns = [
    { title: 'Quantity', pinned: true },
    { title: 'Verdict' },
    { title: 'Block', number: true, screen: true },
    { title: 'Value', number: true },
    { title: 'Design value', number: true },
    { title: 'Deviation', number: true },
    { title: 'Limits' },
    { title: 'Formula', screen: true },
    { title: 'Clause' },
  ];
  const rows = device.assessments.map((a) => ({
    cells: [
      element('b', { class: 'strong' }, a.quantity),
      element('td', { class: 'reasoned' }, verdictBadge(a.verdict), a.reason ? element('small', {}, a.reason) : null),
      isNumber(a.block) && a.block > 0 ? String(a.block) : DASH,
      withUnit(a.value, a.unit),
      withUnit(a.nominal, a.unit),
      deviation(a.deviation_percent),
      element('td', { class: 'tight' }, limitText(a.limit)),
      a.formula,
      element('td', { class: 'note clause' }, a.clause),
    ],
  }));
  return table(columns, rows, 'Assessment of the chosen device');
}
