import { choose, chosen } from '../choice.js';
import { element, onScreen } from '../dom.js';
import { lawName } from '../laws.js';
import { devices, fitData, laws } from '../report.js';
import { keyOf, sortedBy, tableOf } from '../tables.js';
import { fixed, isNumber, objectiveText, signed, significant } from '../text.js';

// True if the objective of any fit is a weighted mean (option --weights). The table then also shows the objective as
// the plain mean over time.
const weighed = laws.some((law) => law.devices.some((fit) => isNumber(fit.objective_by_time)));

export const fitsFigure = {
  id: 'fits',
  title: 'All laws on this device',
  depends: ['device'],
  wanted: () => chosen.device !== null,
  caption: () =>
    'Best run of each law on ' + devices[chosen.device].name +
    ': objective, and errors of effective stiffness, dissipated energy and damping in the third counted cycle of the largest amplitude' +
    (devices[chosen.device].scored ? ' used for the fit' : '') + ', or in the largest swings where no cycle counts.' +
    onScreen(' Press a column head to sort the table and the loops below.'),
  csv: () =>
    fitData([
      'objective', ...(weighed ? ['objective_by_time'] : []), 'K_eff_error_percent', 'energy_error_percent',
      'damping_error_percent', 'runs', 'failed_runs', 'evaluations', 'message',
    ]),
  build: fitTable,
};

const errorColumns = [['K_eff', 'stiffness'], ['energy', 'energy'], ['damping', 'damping']].map(([name, title]) => {
  const key = name + '_error_percent';
  return {
    title: title + ' error', unit: '%', number: true, cell: ({ fit }) => signed(fit[key], 1),
    by: ({ fit }) => (isNumber(fit[key]) ? Math.abs(fit[key]) : null),
  };
});

const COLUMNS = [
  { title: 'Law', pinned: true, tight: true, cell: ({ law }) => lawName(law), by: ({ law }) => law.name },
  { title: 'best OF', unit: '-', number: true, cell: ({ fit }) => fixed(fit.objective.best, 4), by: ({ fit }) => fit.objective.best },
  ...(weighed
    ? [{
        title: 'best OF by time', unit: '-', number: true, cell: ({ fit }) => fixed(fit.objective_by_time, 4),
        by: ({ fit }) => fit.objective_by_time,
      }]
    : []),
  ...errorColumns,
  {
    title: 'mean OF \u00b1 std', unit: 'over the runs', number: true, cell: ({ fit }) => objectiveText(fit.objective),
    by: ({ fit }) => fit.objective.mean,
  },
  {
    title: 'runs', number: true, cell: ({ fit }) => String(fit.runs) + (fit.failed_runs > 0 ? ', ' + fit.failed_runs + ' failed' : ''),
    by: ({ fit }) => fit.runs,
  },
  {
    title: 'parameter sets', unit: 'tried', number: true, cell: ({ fit }) => significant(fit.evaluations, 3),
    by: ({ fit }) => fit.evaluations,
  },
];
const REMARK = { title: 'Remark', cell: ({ fit }) => element('td', { class: 'note text' }, fit.message), by: ({ fit }) => fit.message };

const current = () => chosen.order && COLUMNS.concat(REMARK).find((column) => keyOf(column) === chosen.order.key);

export const inOrder = (fits) => (current() ? sortedBy(fits, (one) => current().by(one) ?? null, chosen.order.down) : fits);

export const orderText = () =>
  current() ? 'sorted by ' + current().title + ', ' + (chosen.order.down ? 'descending' : 'ascending') : 'in the order of the laws';

function fitTable() {
  const device = devices[chosen.device];
  const fits = laws.map((law) => ({ law, fit: law.fitOn.get(device.index) })).filter(({ fit }) => fit);
  const remarks = fits.some(({ fit }) => fit.message);
  return tableOf([...COLUMNS, ...(remarks ? [REMARK] : [])], fits, 'All laws on the chosen device', {
    order: chosen.order, follow: (order) => choose({ order }),
  });
}
