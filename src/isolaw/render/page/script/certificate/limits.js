import { element, strong } from '../dom.js';
import { devices, report } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, THIN, deviation, enumerate, isNumber, limitText, spanText, trimmed, unitText } from '../text.js';
import { verdictBadge } from '../verdicts.js';

// This table lists every requirement of the rule set, including those that were not tested.
export const certificateLimitsFigure = {
  id: 'certificate-limits',
  title: 'Requirements',
  wanted: () => report.result.requirements.length > 0,
  build: limitsTable,
};

// Returns the assessments that decide whether a requirement is met: one for each device or for each side of its loop,
// or one for the lot.
function assessmentsOf({ name }) {
  const { lot } = report.assessment;
  const all = [...devices.flatMap((device) => device.assessments.map((a) => ({ ...a, device: device.name }))), ...(lot ? [lot.sample] : [])];
  const means = (lot?.quantities ?? []).flatMap((quantity) => quantity.mean_limits);
  return [...all, ...means].filter((a) => a && a.limit && (a.subject === 'device' ? a.property : a.quantity) === name);
}

function limitsTable() {
  const rows = report.result.requirements.map((requirement) => ({ requirement, found: assessmentsOf(requirement) }));
  const values = (found) => found.filter(({ value }) => isNumber(value));
  const measured = ({ found }) => {
    const some = values(found);
    if (some.length === 0) return 'not tested';
    return spanText(some.map(({ value }) => value), 4, trimmed) + THIN + unitText(some[0].unit).replace(/^-$/, '');
  };
  const limit = ({ found: [first] }) => {
    if (!first) return DASH;
    return [isNumber(first.nominal) ? trimmed(first.nominal) + THIN + unitText(first.unit) : '', limitText(first.limit)].filter(Boolean).join(', ');
  };
  const farthest = ({ found }) => {
    const some = found.filter(({ deviation_percent: percent }) => isNumber(percent));
    if (some.length === 0) return DASH;
    const worst = some.reduce((a, b) => (Math.abs(b.deviation_percent) > Math.abs(a.deviation_percent) ? b : a));
    return deviation(worst.deviation_percent) + (devices.length > 1 && worst.device ? ', ' + worst.device : '');
  };
  const verdict = ({ requirement, found }) => {
    const reasons = [...new Set(found.filter((a) => a.verdict === requirement.verdict).map(({ reason }) => reason).filter(Boolean))];
    return element('td', { class: 'reasoned' }, verdictBadge(requirement.verdict), reasons.length > 0 ? element('small', {}, enumerate(reasons)) : null);
  };
  const columns = [
    { title: 'Requirement', pinned: true, cell: ({ requirement }) => strong(requirement.name) },
    { title: 'Measured', cell: measured },
    { title: 'Limit', cell: limit },
    { title: 'Farthest off', cell: farthest },
    { title: 'Clause', cell: ({ found: [first] }) => element('td', { class: 'note' }, first?.clause ?? DASH) },
    { title: 'Verdict', cell: verdict },
  ];
  return tableOf(columns, rows, 'The certificate: requirements');
}
