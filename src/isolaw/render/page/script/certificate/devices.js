import { assessedBlock, assessedCycle } from '../cycles.js';
import { element, strong } from '../dom.js';
import { deviceValue, lotQuantities } from '../lot.js';
import { devices, headingOf, recordsOf, report } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, enumerate, fixed, sentence, significant, unitText } from '../text.js';
import { verdictBadge } from '../verdicts.js';
import { commonlyOpen, deviceVerdict, sameRecord } from './verdict.js';
import { MM, decimalsIn } from '../units.js';

export const certificateDevicesFigure = {
  id: 'certificate-devices',
  title: 'Devices',
  long: true,
  caption: certificateCaption,
  csv: certificateData,
  build: certificateTable,
};

const certificateProperties = () =>
  lotQuantities.length > 0
    ? lotQuantities.map((quantity) => ({
        title: quantity.quantity,
        quantity: quantity.quantity,
        unit: quantity.unit,
        value: (device) => deviceValue(device, quantity.quantity)?.value,
      }))
    : ['K_eff_kN_per_mm', 'damping_percent'].map((key) => ({
        ...headingOf('cycles', key),
        value: (device) => assessedCycle(device)?.[key],
      }));

// Returns the measured quantities in which a device is an outlier of the lot. Outliers in the parameters of fitted laws
// are not for a certificate.
const apart = (device) =>
  lotQuantities.length > 0
    ? report.assessment.lot.outliers.filter((outlier) => outlier.device === device.name).map((outlier) => outlier.quantity)
    : [];

// Lists doubts about the tests, such as friction of the rig. If a doubt is true, a value would be different. Each doubt
// gets a letter, which the caption explains.
const conditions = [...new Set(devices.flatMap((device) => device.doubts.map(({ condition }) => condition)))];
const letter = (condition) => String.fromCharCode(97 + conditions.indexOf(condition));
const doubtsOf = (device, quantity) =>
  device.doubts
    .filter((doubt) => doubt.quantity === quantity)
    .sort((a, b) => conditions.indexOf(a.condition) - conditions.indexOf(b.condition));

function certificateCaption() {
  const marked = devices.some((device) => apart(device).length > 0);
  const unjudged = [...new Set(lotQuantities.map((quantity) => quantity.outlier_note).filter(Boolean))];
  return (
    (report.assessment?.rule_set
      ? 'Values over the cycles that the rule set counts. '
      : 'Values of the third counted cycle of the block that counts. ') +
    (marked
      ? '\u25be: outlier of the lot (modified z-score above 3.5).'
      : unjudged.length > 0 || lotQuantities.length === 0
        ? 'Outliers not assessed' + (unjudged.length > 0 ? ': ' + unjudged.join('; ') : '') + '.'
        : 'No device is an outlier of the lot.') +
    conditions.map((condition) => ' ' + letter(condition) + ': another value if ' + sentence(condition) + '.').join('')
  );
}

function certificateColumns() {
  // A fact that is the same for all devices is in the certificate's head and needs no column. Serial numbers always
  // have a column.
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
  // Compares ratios and not differences, so that the result does not depend on the units of the page.
  const same = (key) => {
    const values = devices.map((device) => assessedBlock(device)?.[key] ?? null);
    return values.every((value) => value === values[0] || Math.abs(value / values[0] - 1) < 0.002);
  };
  const sameAmplitude = same('amplitude_mm'),
    sameFrequency = same('frequency_Hz');
  const judged = (device) => {
    const { verdict, failed, open } = deviceVerdict(device),
      outlying = apart(device),
      missing = open.filter((quantity) => !common.includes(quantity));
    const remark =
      device.status !== 'ok' ? 'refused: see the remarks' : device.properties_refusal ? device.properties_refusal : [sameRecord(device), enumerate(failed), missing.length > 0 ? 'not assessed: ' + enumerate(missing) : '', outlying.length > 0 ? '\u25be ' + enumerate(outlying, 3) : ''].filter(Boolean).join('; ');
    const below = remark ? element('small', {}, remark) : null;
    return element('td', { class: 'reasoned' }, verdict ? verdictBadge(verdict, device.verdict_brief) : DASH, below);
  };
  // A letter after a value stands for a doubt that would change the value. If there is one device, the changed value
  // stands below it. If there are several, the changed values are on the page of each device.
  const doubted = (device, quantity, value) => {
    const doubts = doubtsOf(device, quantity);
    return element(
      'td',
      { class: 'number' },
      significant(value, 4),
      ...(devices.length > 1
        ? [element('sup', {}, doubts.map(({ condition }) => letter(condition)).join(','))]
        : doubts.map(({ otherwise, condition }) => element('small', {}, 'or ' + significant(otherwise, 3), element('sup', {}, letter(condition))))),
    );
  };
  const hash = (device) =>
    element('span', {}, ...recordsOf(device).map(({ sha256 }, i) => element('span', { class: 'hash', title: sha256 }, (i > 0 ? ' ' : '') + sha256.slice(0, 8))));
  const columns = [
    { title: 'Device', pinned: true, cell: (device) => strong(device.name) },
    ...certificateColumns(),
    ...(sameAmplitude ? [] : [{ title: 'Amplitude', unit: MM, number: true, cell: (device) => fixed(assessedBlock(device)?.amplitude_mm, decimalsIn('mm', 1)) }]),
    ...(sameFrequency ? [] : [{ title: 'Frequency', unit: 'Hz', number: true, cell: (device) => significant(assessedBlock(device)?.frequency_Hz, 2) }]),
    ...certificateProperties().map(({ title, quantity = title, unit, value }) => ({
      title, unit: unitText(unit), number: true, cell: (device) => doubted(device, quantity, value(device)),
    })),
    { title: 'Verdict', cell: judged },
    { title: 'File', cell: hash },
  ];
  return tableOf(columns, devices, 'The certificate: devices');
}

function certificateData() {
  const properties = certificateProperties();
  return {
    columns: [
      'device', 'serial', 'lot', 'tested', 'temperature [°C]', 'amplitude [' + MM + ']', 'frequency [Hz]',
      ...properties.map(({ title, unit }) => title + ' [' + (unit || '-') + ']'),
      'verdict', 'outside the limits', 'not assessed', 'stands apart by', 'in doubt', 'file', 'sha256',
    ],
    rows: devices.map((device) => {
      const block = assessedBlock(device);
      const { verdict, failed, open } = deviceVerdict(device);
      return [
        device.name, device.serial, device.lot, device.test_date, device.temperature_C,
        block?.amplitude_mm ?? null, block?.frequency_Hz ?? null,
        ...properties.map(({ value }) => value(device) ?? null),
        verdict ?? '', device.status === 'ok' ? failed.join('; ') || device.properties_refusal || sameRecord(device) : device.message, open.join('; '), apart(device).join('; '),
        device.doubts.map(({ quantity, otherwise, unit, condition }) => quantity + ' ' + otherwise + ' ' + unit + ' if ' + condition).join('; '), device.file, recordsOf(device).map(({ sha256 }) => sha256).join(' '),
      ];
    }),
  };
}
