import { element, shortList, strong } from '../dom.js';
import { report, resultData } from '../report.js';
import { THIN, signed, withUnit } from '../text.js';

export const lotOutliersFigure = {
  id: 'lot-outliers',
  title: 'Outliers of the lot',
  wanted: () => report.outliers.length > 0,
  caption: () =>
    'Properties and misfits far from the median of the lot. Check the test of such a device before you use the lot\u2019s law.',
  csv: () => resultData('outliers', report.outliers.map((outlier) => [outlier])),
  build: apartList,
};

function apartList() {
  const byDevice = new Map();
  for (const one of report.outliers) byDevice.set(one.device, [...(byDevice.get(one.device) ?? []), one]);
  const said = ({ property, value, unit, percent }) =>
    property + ' ' + withUnit(value, unit) + ' (' + signed(percent, 0) + THIN + '% from the median)';
  const items = [...byDevice].map(([name, found]) => element('li', {}, strong(name), ': ' + found.map(said).join('; ')));
  return element('div', { class: 'prose' }, ...shortList(items, 8, 6, 'sentences'));
}
