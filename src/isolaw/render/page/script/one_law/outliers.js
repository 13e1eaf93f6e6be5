import { element, shortList } from '../dom.js';
import { report, resultColumns } from '../report.js';
import { THIN, signed, withUnit } from '../text.js';

export const lotOutliersFigure = {
  id: 'lot-outliers',
  title: 'Outliers of the lot',
  wanted: () => report.outliers.length > 0,
  caption: () =>
    'Properties and misfits far from the median of the lot. Check the test of such a device before you use the lot\u2019s law.',
  csv: () => {
    const { columns, cells } = resultColumns('outliers');
    return { columns, rows: report.outliers.map(cells) };
  },
  build: apartList,
};

function apartList() {
  const byDevice = new Map();
  for (const one of report.outliers) byDevice.set(one.device, [...(byDevice.get(one.device) ?? []), one]);
  const items = [...byDevice].map(([name, found]) =>
    element(
      'li',
      {},
      element('b', { class: 'strong' }, name),
      ': ' +
        found
          .map(
            (one) =>
              one.property +
              ' ' + withUnit(one.value, one.unit) + ' (' + signed(one.percent, 0) + THIN + '% from the median)',
          )
          .join('; '),
    ),
  );
  return element('div', { class: 'prose' }, ...shortList(items, 8, 6, 'sentences'));
}
