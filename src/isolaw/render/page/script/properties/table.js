import { chosen } from '../choice.js';
import { blockFacts, cycleData, isReported, noCycles } from '../cycles.js';
import { element, empty, onScreen } from '../dom.js';
import { devices, numberColumn } from '../report.js';
import { said, table } from '../tables.js';
import { DASH, isNumber } from '../text.js';

const SHOWN = [
  'amplitude_mm', 'F_plus_kN', 'F_minus_kN', 'K_eff_kN_per_mm', 'K_plus_kN_per_mm', 'K_minus_kN_per_mm', 'energy_kN_mm',
  'damping_percent', 'Q_d_kN', 'K_d_kN_per_mm', 'v_max_mm_s', 'N_mean_kN', 'strain_percent', 'G_MPa',
];

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
    ', from raw values. Bold: the reported cycle, which is the third of the block of largest amplitude, or its last; grey: not counted.' +
    ' K+ and K\u2212: force over displacement per side.' +
    onScreen(' The CSV holds more columns.')
  );
}

function cycleTable() {
  const device = devices[chosen.tested];
  const all = device.blocks.flatMap((block) => block.cycles.map((cycle) => ({ block, cycle })));
  if (all.length === 0) return empty('No cycles: ' + noCycles(device));
  const shown = SHOWN.filter((key) => all.some(({ cycle }) => isNumber(cycle[key]))).map((key) =>
    numberColumn('cycles', key),
  );
  const columns = [
    { title: 'Block', pinned: true, name: true },
    { title: 'Cycle', number: true },
    ...shown,
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
          said(first, element('span', {}, blockFacts(block))),
          cycle.counts ? null : element('small', {}, 'not counted: ' + cycle.reason),
        ),
        cycle.counts ? cycle.number + (cycle.half ? ' (half)' : '') : DASH,
        ...shown.map((column) => column.text(cycle)),
      ],
    };
  });
  return table(columns, rows, 'Properties of every cycle of the chosen device');
}
