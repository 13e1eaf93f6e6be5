import { reportedBlock, reportedCycle } from '../cycles.js';
import { element } from '../dom.js';
import { deviceValue, lotQuantities } from '../lot.js';
import { devices, headingOf, report } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, enumerate, fixed, significant, unitText } from '../text.js';
import { verdictBadge } from '../verdicts.js';
import { commonlyOpen, deviceVerdict } from './verdict.js';

export const certificateDevicesFigure = {
  id: 'certificate-devices',
  title: 'Devices',
  long: true,
  caption: certificateCaption,
  csv: certificateData,
  build: certificateTable,
};

// Properties of the certificate: those of the lot where a rule set says which, else of the reported cycle.
const certificateProperties = () =>
  lotQuantities.length > 0
    ? lotQuantities.map((quantity) => ({
        title: quantity.quantity,
        unit: quantity.unit,
        value: (device) => deviceValue(device, quantity.quantity)?.value,
      }))
    : ['K_eff_kN_per_mm', 'damping_percent'].map((key) => ({
        ...headingOf('cycles', key),
        value: (device) => reportedCycle(device)?.[key],
      }));

// What sets a device apart, in its test and in the laws' misfits.
function apart(device) {
  const own = (outliers) => outliers.filter((outlier) => outlier.device === device.name);
  const tested = lotQuantities.length > 0;
  return [
    ...(tested ? own(report.assessment.lot.outliers).map((outlier) => outlier.quantity) : []),
    // Misfits have no unit; of the others the lot has spoken.
    ...own(report.outliers).filter((outlier) => !tested || outlier.unit === '').map((outlier) => outlier.property),
  ];
}

function certificateCaption() {
  const marked = devices.some((device) => apart(device).length > 0);
  const unjudged = [...new Set(lotQuantities.map((quantity) => quantity.outlier_note).filter(Boolean))];
  return (
    (report.assessment?.rule_set
      ? 'Values over the cycles that the rule set counts. '
      : 'Values of the third counted cycle of the largest amplitude. ') +
    (marked
      ? '\u25be: stands apart from the lot (modified z-score above 3.5).'
      : unjudged.length > 0 || lotQuantities.length === 0
        ? 'Outliers not judged' + (unjudged.length > 0 ? ': ' + unjudged.join('; ') : '') + '.'
        : 'No device stands apart from the lot.')
  );
}

function certificateColumns() {
  // What all devices share stands in the head.
  const known = (key) => new Set(devices.map((device) => device[key]).filter((value) => value !== null && value !== '')).size > 1;
  const given = (key) => devices.some((device) => device[key] !== null && device[key] !== '');
  return [
    { key: 'serial', title: 'Serial', cell: (d) => d.serial },
    { key: 'lot', title: 'Lot', cell: (d) => d.lot },
    { key: 'test_date', title: 'Tested', tight: true, cell: (d) => d.test_date },
    { key: 'temperature_C', title: 'Temp.', unit: '\u00b0C', number: true, cell: (d) => fixed(d.temperature_C, 1) },
  ].filter((fact) => given(fact.key) && (fact.key === 'serial' || known(fact.key)));
}

function certificateTable() {
  const common = commonlyOpen();
  const same = (digits) => (key) => new Set(devices.map((device) => fixed(reportedBlock(device)?.[key], digits))).size === 1;
  const sameAmplitude = same(1)('amplitude_mm'), // then it stands in the head
    sameFrequency = same(2)('frequency_Hz');
  const judged = (device) => {
    const { verdict, failed, open } = deviceVerdict(device),
      outlying = apart(device),
      missing = open.filter((quantity) => !common.includes(quantity));
    const remark =
      device.status !== 'ok' ? 'refused: ' + device.message : device.properties_refusal ? device.properties_refusal : [enumerate(failed), missing.length > 0 ? 'not assessed: ' + enumerate(missing) : '', outlying.length > 0 ? '\u25be ' + enumerate(outlying, 3) : ''].filter(Boolean).join('; ');
    const below = remark ? element('small', {}, remark) : null;
    return element('td', { class: 'reasoned' }, verdict ? verdictBadge(verdict) : DASH, below);
  };
  const hash = ({ sha256 }) => element('span', { class: 'hash', title: sha256 }, sha256.slice(0, 8));
  const columns = [
    { title: 'Device', pinned: true, cell: (device) => element('b', { class: 'strong' }, device.name) },
    ...certificateColumns(),
    { title: 'Amplitude', unit: 'mm', number: true, screen: sameAmplitude, cell: (device) => fixed(reportedBlock(device)?.amplitude_mm, 1) },
    { title: 'Frequency', unit: 'Hz', number: true, screen: sameFrequency, cell: (device) => significant(reportedBlock(device)?.frequency_Hz, 2) },
    ...certificateProperties().map(({ title, unit, value }) => ({
      title, unit: unitText(unit), number: true, cell: (device) => significant(value(device), 4),
    })),
    { title: 'Verdict', cell: judged },
    { title: 'File', screen: true, cell: hash },
  ];
  return tableOf(columns, devices, 'The certificate: devices');
}

function certificateData() {
  const properties = certificateProperties();
  return {
    columns: [
      'device', 'serial', 'lot', 'tested', 'temperature [°C]', 'amplitude [mm]', 'frequency [Hz]',
      ...properties.map(({ title, unit }) => title + ' [' + (unit || '-') + ']'),
      'verdict', 'outside the limits', 'not assessed', 'stands apart by', 'file', 'sha256',
    ],
    rows: devices.map((device) => {
      const block = reportedBlock(device);
      const { verdict, failed, open } = deviceVerdict(device);
      return [
        device.name, device.serial, device.lot, device.test_date, device.temperature_C,
        block?.amplitude_mm ?? null, block?.frequency_Hz ?? null,
        ...properties.map(({ value }) => value(device) ?? null),
        verdict ?? '', device.status === 'ok' ? failed.join('; ') || device.properties_refusal : device.message, open.join('; '), apart(device).join('; '), device.file, device.sha256,
      ];
    }),
  };
}
