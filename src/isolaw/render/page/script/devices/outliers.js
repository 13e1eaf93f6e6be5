import { element } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report } from '../report.js';
import { table } from '../tables.js';
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
    { title: 'Device', pinned: true },
    { title: 'Property' },
    { title: 'Value', number: true },
    { title: 'Why' },
  ];
  const rows = report.assessment.lot.outliers.map((outlier) => ({
    cells: [
      element('b', { class: 'strong' }, outlier.device),
      outlier.quantity,
      withUnit(outlier.value, outlier.unit),
      element('td', { class: 'note text' }, outlier.why),
    ],
  }));
  return table(columns, rows, 'Outliers');
}
