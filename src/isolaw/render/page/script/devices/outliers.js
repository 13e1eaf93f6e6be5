import { element } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report } from '../report.js';
import { tableOf } from '../tables.js';
import { withUnit } from '../text.js';

export const outliersFigure = {
  id: 'outliers',
  title: 'Outliers',
  wanted: () => lotQuantities.length > 0 && report.assessment.lot.outliers.length > 0,
  csv: () => ({
    columns: ['device', 'quantity', 'value', 'unit', 'why'],
    rows: report.assessment.lot.outliers.map((o) => [o.device, o.quantity, o.value, o.unit, o.why]),
  }),
  build: outlierTable,
};

function outlierTable() {
  const columns = [
    { title: 'Device', pinned: true, cell: (outlier) => element('b', { class: 'strong' }, outlier.device) },
    { title: 'Property', cell: (outlier) => outlier.quantity },
    { title: 'Value', number: true, cell: (outlier) => withUnit(outlier.value, outlier.unit) },
    { title: 'Why', cell: (outlier) => element('td', { class: 'note text' }, outlier.why) },
  ];
  return tableOf(columns, report.assessment.lot.outliers, 'Outliers');
}
