// Blocks and cycles of a device.

import { chosen } from './choice.js';
import { THIN, fixed, isNumber, significant } from './text.js';

// Every number of a cycle: its key in the data, its heading, and how it reads.
export const CYCLE_COLUMNS = [
  { key: 'amplitude_mm', title: 'Amplitude', unit: 'mm', text: (v) => fixed(v, 1) },
  { key: 'd_plus_mm', title: 'd+', unit: 'mm', text: (v) => fixed(v, 1), csvOnly: true },
  { key: 'd_minus_mm', title: 'd\u2212', unit: 'mm', text: (v) => fixed(v, 1), csvOnly: true },
  { key: 'F_plus_kN', title: 'F+', unit: 'kN', text: (v) => fixed(v, 1), screen: true },
  { key: 'F_minus_kN', title: 'F\u2212', unit: 'kN', text: (v) => fixed(v, 1), screen: true },
  { key: 'K_eff_kN_per_mm', title: 'K_eff', unit: 'kN/mm', text: (v) => significant(v, 4) },
  { key: 'K_plus_kN_per_mm', title: 'K+', unit: 'kN/mm', text: (v) => significant(v, 4), screen: true },
  { key: 'K_minus_kN_per_mm', title: 'K\u2212', unit: 'kN/mm', text: (v) => significant(v, 4), screen: true },
  { key: 'energy_kN_mm', title: 'Energy', unit: 'kN mm', text: (v) => fixed(v, 0) },
  { key: 'damping_percent', title: 'Damping', unit: '%', text: (v) => fixed(v, 2) },
  { key: 'Q_d_kN', title: 'Q_d', unit: 'kN', text: (v) => fixed(v, 1) },
  { key: 'K_d_kN_per_mm', title: 'K_d', unit: 'kN/mm', text: (v) => significant(v, 3) },
  { key: 'D_y_mm', title: 'D_y', unit: 'mm', text: (v) => fixed(v, 2), csvOnly: true },
  { key: 'K_1_kN_per_mm', title: 'K_1', unit: 'kN/mm', text: (v) => significant(v, 3), csvOnly: true },
  { key: 'period_s', title: 'Period', unit: 's', text: (v) => significant(v, 3), csvOnly: true },
  { key: 'v_max_mm_s', title: 'v_max', unit: 'mm/s', text: (v) => significant(v, 3), screen: true },
  { key: 'N_mean_kN', title: 'N mean', unit: 'kN', text: (v) => fixed(v, 0), screen: true },
  { key: 'N_min_kN', title: 'N min', unit: 'kN', text: (v) => fixed(v, 0), csvOnly: true },
  { key: 'N_max_kN', title: 'N max', unit: 'kN', text: (v) => fixed(v, 0), csvOnly: true },
  { key: 'strain_percent', title: 'Strain', unit: '%', text: (v) => fixed(v, 0) },
  { key: 'G_MPa', title: 'G', unit: 'MPa', text: (v) => significant(v, 3) },
  { key: 'closure_mm', title: 'Closure d', unit: 'mm', text: (v) => significant(v, 2), csvOnly: true },
  { key: 'closure_kN', title: 'Closure F', unit: 'kN', text: (v) => significant(v, 2), csvOnly: true },
];

// The three properties that are followed from cycle to cycle: their key in a cycle, in `stability` and in rule sets.
export const FOLLOWED = [
  { key: 'K_eff_kN_per_mm', name: 'K_eff', title: 'K_eff [kN/mm]', text: (v) => significant(v, 4) + THIN + 'kN/mm' },
  { key: 'damping_percent', name: 'damping', title: 'damping [%]', text: (v) => fixed(v, 2) + THIN + '%' },
  { key: 'energy_kN_mm', name: 'energy', title: 'energy [kN mm]', text: (v) => fixed(v, 0) + THIN + 'kN mm' },
];

export const counted = (block) => block.cycles.filter((cycle) => cycle.counts);
export const countedCycles = (device) => device.blocks.flatMap(counted);
export const largestNumber = (device) => Math.max(1, ...countedCycles(device).map((cycle) => cycle.number));

export const chosenBlocks = (device) =>
  device.blocks.filter((block) => chosen.block === 'all' || block.number === chosen.block);

export function blockText(block) {
  return (
    'block ' + block.number + ', ±' + significant(block.amplitude_mm, 3) + THIN + 'mm' +
    (isNumber(block.frequency_Hz) ? ', ' + significant(block.frequency_Hz, 2) + THIN + 'Hz' : '') +
    (block.waveform ? ', ' + block.waveform : '')
  );
}

export const cycleText = (block, cycle) =>
  'block ' + block.number + ', ' + (cycle.counts ? 'cycle ' + cycle.number : 'not counted: ' + cycle.reason);

export const isReported = (device, block, cycle) =>
  device.reported !== null &&
  block.number === device.reported.block &&
  cycle.counts &&
  cycle.number === device.reported.number;

export const reportedCycle = (device) =>
  device.blocks.flatMap((block) => block.cycles.filter((cycle) => isReported(device, block, cycle)))[0] ?? null;

export const reportedBlock = (device) => device.blocks.find((block) => block.number === device.reported?.block);
export const noCycles = (device) => device.properties_refusal || device.message || 'none was found';

export function cycleData(among) {
  return {
    columns: [
      'device', 'block', 'waveform', 'frequency [Hz]', 'cycle', 'counts', 'reason', 'reported', 'first sample',
      'last sample',
      ...CYCLE_COLUMNS.map(
        (column) => column.key.replace(/_(mm|kN|s|percent|kN_per_mm|kN_mm|mm_s|MPa)$/, '') + ' [' + column.unit + ']',
      ),
      ...FOLLOWED.map((property) => property.name + ' / cycle 3'),
    ],
    rows: among.flatMap((device) =>
      device.blocks.flatMap((block) =>
        block.cycles.map((cycle) => [
          device.name, block.number, block.waveform, block.frequency_Hz, cycle.counts ? cycle.number : null,
          cycle.counts ? 'yes' : 'no', cycle.reason, isReported(device, block, cycle) ? 'yes' : 'no', cycle.first,
          cycle.last,
          ...CYCLE_COLUMNS.map((column) => cycle[column.key]),
          ...FOLLOWED.map((property) =>
            cycle.counts ? block.stability?.[property.name]?.ratio_to_third?.[counted(block).indexOf(cycle)] : null,
          ),
        ]),
      ),
    ),
  };
}
