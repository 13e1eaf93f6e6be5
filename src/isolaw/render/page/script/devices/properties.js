import { counted, countedCycles, countingCycle, cycleData, isReported, noCycles, reportedCycle } from '../cycles.js';
import { element, onScreen, strong } from '../dom.js';
import { devices, headingOf, numberColumn } from '../report.js';
import { said, table } from '../tables.js';
import { DASH, THIN, count, fixed, isNumber, significant, spanText } from '../text.js';

export const testPropertiesFigure = {
  id: 'properties',
  title: 'Test properties per device and block',
  long: true,
  caption: propertiesCaption,
  csv: () => cycleData(devices),
  build: propertiesTable,
};

function propertiesCaption() {
  const cycles = devices.map(reportedCycle).filter(Boolean);
  if (cycles.length === 0) return 'No record has a complete cycle with enough samples.';
  const span = (key) =>
    (spanText(cycles.map((cycle) => cycle[key]), 3, significant) ?? DASH) + THIN + headingOf('cycles', key).unit;
  return (
    'Third counted cycle of each block, or its last' +
    (devices.some((device) => device.blocks.length > 1) ? '; in bold the reported one' : '') + '.' +
    onScreen(' Every cycle is in the CSV.') + ' Over ' + count(cycles.length, 'device') + ': effective stiffness ' +
    span('K_eff_kN_per_mm') + ', equivalent viscous damping ' + span('damping_percent') + '.'
  );
}

function propertiesTable() {
  const some = (key) => devices.some((device) => device[key] !== null && device[key] !== '');
  const facts = [
    { key: 'serial', title: 'Serial', text: (d) => d.serial },
    { key: 'lot', title: 'Lot', text: (d) => d.lot },
    { key: 'test_date', title: 'Tested', text: (d) => d.test_date },
    { key: 'temperature_C', title: 'Temp.', unit: '°C', number: true, text: (d) => fixed(d.temperature_C, 1) },
  ].filter((fact) => some(fact.key));
  const strained = devices.some((device) => countedCycles(device).some((cycle) => isNumber(cycle.strain_percent)));
  const ofBlock = (column) => ({ ...column, of: (block) => column.text(block) });
  const ofCycle = (column) => ({ ...column, of: (_, cycle) => column.text(cycle) });
  const scragging = numberColumn('stability', 'first_to_third', { title: 'Scragging', unit: 'K_eff 1st/3rd' });
  const several = devices.some((device) => device.blocks.length > 1);
  const numbers = [
    ofBlock({ title: 'Block', number: true, text: (block) => String(block.number) }),
    ofCycle({ title: 'Cycle', number: true, text: (cycle) => String(cycle.number) }),
    ofCycle(numberColumn('cycles', 'amplitude_mm')),
    ...(strained ? [ofCycle(numberColumn('cycles', 'strain_percent', { title: 'Shear strain' }))] : []),
    ofBlock(numberColumn('blocks', 'frequency_Hz')),
    ofCycle(numberColumn('cycles', 'K_eff_kN_per_mm', { title: 'Effective stiffness' })),
    ofCycle(numberColumn('cycles', 'energy_kN_mm')),
    ofCycle(numberColumn('cycles', 'damping_percent')),
    ofBlock({ ...scragging, text: (block) => scragging.text(block.stability?.K_eff ?? {}) }),
  ];
  const columns = [{ title: 'Device', pinned: true }, ...facts, ...numbers, { title: 'Remark' }];
  const rows = devices.flatMap((device) => {
    const remark = [
      device.status !== 'ok' ? 'refused: ' + device.message : device.reported === null ? device.properties_refusal : '',
      device.warnings.length > 0 ? count(device.warnings.length, 'warning') : '',
      device.corrections.length > 0 ? count(device.corrections.length, 'correction') : '',
    ]
      .filter(Boolean)
      .join('; ');
    const lead = (first) => [
      said(first, strong(device.name)),
      ...facts.map((fact) => said(first, element('span', {}, fact.text(device)))),
    ];
    const blocks = device.blocks.filter((block) => counted(block).length > 0);
    if (blocks.length === 0) {
      const none = element('td', { class: 'note', colspan: numbers.length + 1 }, remark || noCycles(device));
      return [{ className: 'group', cells: [...lead(true), none] }];
    }
    return blocks.map((block, i) => {
      const cycle = countingCycle(block);
      return {
        className:
          [i === 0 ? 'group' : '', several && isReported(device, block, cycle) ? 'strong' : ''].join(' ').trim() ||
          null,
        cells: [
          ...lead(i === 0),
          ...numbers.map(({ of }) => of(block, cycle)),
          element('td', { class: 'note text' }, i === 0 ? remark : ''),
        ],
      };
    });
  });
  return table(columns, rows, 'Test properties per device and block');
}
