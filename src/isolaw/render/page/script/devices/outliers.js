import { element } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report, resultColumns } from '../report.js';
import { tableOf } from '../tables.js';
import { withUnit } from '../text.js';

export const outliersFigure = {
  id: 'outliers',
  title: 'Outliers',
  wanted: () => lotQuantities.length > 0 && report.assessment.lot.outliers.length > 0,
  csv: () => {
    const { columns, cells } = resultColumns('lot_outliers');
    return { columns, rows: report.assessment.lot.outliers.map(cells) };
  },
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
