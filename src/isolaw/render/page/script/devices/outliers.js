import { element, strong } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report, resultData } from '../report.js';
import { tableOf } from '../tables.js';
import { withUnit } from '../text.js';

export const outliersFigure = {
  id: 'outliers',
  title: 'Outliers',
  wanted: () => lotQuantities.length > 0 && report.assessment.lot.outliers.length > 0,
  csv: () => resultData('lot_outliers', report.assessment.lot.outliers.map((outlier) => [outlier])),
  build: outlierTable,
};

function outlierTable() {
  const columns = [
    { title: 'Device', pinned: true, cell: (outlier) => strong(outlier.device) },
    { title: 'Property', cell: (outlier) => outlier.quantity },
    { title: 'Value', number: true, cell: (outlier) => withUnit(outlier.value, outlier.unit) },
    { title: 'Why', cell: (outlier) => element('td', { class: 'note text' }, outlier.why) },
  ];
  return tableOf(columns, report.assessment.lot.outliers, 'Outliers');
}
