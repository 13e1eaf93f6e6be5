import { chosen } from '../choice.js';
import { CYCLE_COLUMNS, blockText, cycleData, isReported, noCycles } from '../cycles.js';
import { element, onScreen } from '../dom.js';
import { devices } from '../report.js';
import { table } from '../tables.js';
import { DASH, isNumber } from '../text.js';

export const cycleTableFigure = {
  id: 'cycle-table',
  title: 'Properties of every cycle',
  long: true,
  depends: ['tested'],
  wanted: () => chosen.tested !== null,
  caption: cycleTableCaption,
  csv: () => cycleData([devices[chosen.tested]]),
  build: cycleTable,
};

function cycleTableCaption() {
  const device = devices[chosen.tested];
  if (device.blocks.length === 0) return 'No cycles: ' + noCycles(device);
  return (
    device.name +
    ', from raw values. In bold the reported cycle: the third of the block of largest amplitude, or its last; grey: not counted.' +
    onScreen(' K+ and K\u2212: force over displacement per side. The CSV holds more columns.')
  );
}

function cycleTable() {
  const device = devices[chosen.tested];
  const all = device.blocks.flatMap((block) => block.cycles.map((cycle) => ({ block, cycle })));
  if (all.length === 0) return element('p', { class: 'empty' }, 'No cycles: ' + noCycles(device));
  const shown = CYCLE_COLUMNS.filter(
    (column) => !column.csvOnly && all.some(({ cycle }) => isNumber(cycle[column.key])),
  );
  const columns = [
    { title: 'Block', pinned: true, name: true },
    { title: 'Cycle', number: true },
    ...shown.map((column) => ({ title: column.title, unit: column.unit, number: true, screen: column.screen })),
  ];
  const rows = all.map(({ block, cycle }, i) => {
    const first = i === 0 || all[i - 1].block !== block;
    return {
      className:
        [first ? 'group' : '', isReported(device, block, cycle) ? 'strong' : '', cycle.counts ? '' : 'uncounted']
          .filter(Boolean)
          .join(' ') || null,
      cells: [
        element(
          'span',
          {},
          first ? blockText(block).replace(/^block /, '') : '',
          cycle.counts ? null : element('small', {}, 'not counted: ' + cycle.reason),
        ),
        cycle.counts ? String(cycle.number) : DASH,
        ...shown.map((column) => column.text(cycle[column.key])),
      ],
    };
  });
  return table(columns, rows, 'Properties of every cycle of the chosen device');
}
