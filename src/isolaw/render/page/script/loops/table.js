import { choose, chosen } from '../choice.js';
import { element, onScreen } from '../dom.js';
import { lawName } from '../laws.js';
import { devices, fitData, laws } from '../report.js';
import { tableOf } from '../tables.js';
import { fixed, isNumber, objectiveText, signed, significant } from '../text.js';

export const fitsFigure = {
  id: 'fits',
  title: 'All laws on this device',
  depends: ['device', 'order'],
  wanted: () => chosen.device !== null,
  caption: () =>
    'Best run of each law on ' + devices[chosen.device].name +
    ': its objective, and its effective stiffness, dissipated energy and damping against the record, on the third counted cycle of the largest amplitude' +
    (devices[chosen.device].scored ? ' among those that the laws were judged by.' : '.') +
    onScreen(' The heads of the columns sort; the loops below follow.'),
  csv: () =>
    fitData([
      'objective', 'K_eff_error_percent', 'energy_error_percent', 'damping_error_percent', 'runs', 'failed_runs',
      'evaluations', 'message',
    ]),
  build: fitTable,
};

// What the laws on a device can be sorted by; `of` is smaller the better.
export const ORDERS = [
  { key: 'objective', title: 'best OF', unit: '-', first: 'the smallest objective', of: (fit) => fit.objective.best },
  ...[['K_eff', 'stiffness'], ['energy', 'energy'], ['damping', 'damping']].map(([name, title]) => {
    const key = name + '_error_percent';
    return {
      key, title: title + ' error', unit: '%', first: 'the smallest error of ' + title,
      of: (fit) => (isNumber(fit[key]) ? Math.abs(fit[key]) : null),
    };
  }),
];

// Laws on the chosen device in the chosen order, what has no value last.
export function inOrder(fits) {
  const { of } = ORDERS.find((order) => order.key === chosen.order);
  return [...fits].sort((a, b) => (of(a.fit) ?? Infinity) - (of(b.fit) ?? Infinity));
}

function sortHead(order) {
  const current = order.key === chosen.order;
  const button = element(
    'button',
    { type: 'button', class: 'sort', id: 'sort-' + order.key },
    order.title + (current ? '\u202f\u25b4' : ''),
  );
  button.addEventListener('click', () => {
    choose({ order: order.key });
    document.getElementById('sort-' + order.key)?.focus(); // the table was built anew
  });
  const { key, unit } = order;
  const cell = ({ fit }) => (key === 'objective' ? fixed(fit.objective.best, 4) : signed(fit[key], 1));
  return { title: button, unit, number: true, sorted: current, cell };
}

function fitTable() {
  const device = devices[chosen.device];
  const fits = inOrder(laws.map((law) => ({ law, fit: law.fitOn.get(device.index) })).filter(({ fit }) => fit));
  const remarks = fits.some(({ fit }) => fit.message);
  const runs = ({ fit }) => String(fit.runs) + (fit.failed_runs > 0 ? ', ' + fit.failed_runs + ' failed' : '');
  const columns = [
    { title: 'Law', pinned: true, tight: true, cell: ({ law }) => lawName(law) },
    ...ORDERS.map(sortHead),
    { title: 'mean OF \u00b1 std', unit: 'over the runs', number: true, cell: ({ fit }) => objectiveText(fit.objective) },
    { title: 'runs', number: true, cell: runs },
    { title: 'parameter sets', unit: 'tried', number: true, screen: true, cell: ({ fit }) => significant(fit.evaluations, 3) },
    ...(remarks ? [{ title: 'Remark', cell: ({ fit }) => element('td', { class: 'note text' }, fit.message) }] : []),
  ];
  return tableOf(columns, fits, 'All laws on the chosen device');
}
