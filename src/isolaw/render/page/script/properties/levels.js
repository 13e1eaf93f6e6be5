import { chosen } from '../choice.js';
import { element } from '../dom.js';
import { devices, numberColumn, resultData } from '../report.js';
import { tableOf } from '../tables.js';

const levels = () => devices[chosen.tested]?.levels ?? [];

export const levelsFigure = {
  id: 'levels',
  title: 'Over amplitudes, frequencies and loads',
  long: true,
  depends: ['tested'],
  wanted: () => devices.some((device) => device.levels?.length > 1),
  caption: () =>
    'The third counted cycle of each block, and its ratio to the reference block' +
    (levels().some(({ reference }) => reference) ? ' (' + levels().find(({ reference }) => reference).block + ')' : '') + '.',
  csv: () => resultData('levels', devices.flatMap((device) => (device.levels ?? []).map((level) => [device.name, level])), ['device']),
  build: levelsTable,
};

function levelsTable() {
  const known = (key) => devices.some((device) => device.levels?.some((level) => level[key] !== null));
  const keys = ['amplitude_mm', 'strain_percent', 'frequency_Hz', 'N_mean_kN', 'K_eff_kN_per_mm', 'K_eff_ratio', 'damping_percent', 'damping_ratio', 'K_1_kN_per_mm', 'K_d_kN_per_mm', 'D_y_mm', 'F_y_kN'];
  const columns = [
    { title: 'Block', pinned: true, cell: (level) => element('b', { class: level.reference ? 'strong' : null }, String(level.block)) },
    ...keys
      .filter(known)
      .map((key) => numberColumn('levels', key))
      .map((column) => ({ ...column, cell: column.text })),
  ];
  return tableOf(columns, levels(), 'Levels of the test');
}

