import { commandLine, element, strong, termList } from '../dom.js';
import { designText } from '../lot.js';
import { devices, inspection, laws, recordsOf, report } from '../report.js';
import { tableOf } from '../tables.js';
import { count, isNumber, short } from '../text.js';

const settingsFigure = {
  id: 'settings',
  width: 'narrow',
  title: 'Settings',
  wanted: () => !inspection, // an inspection has no settings of a search
  caption: () =>
    'The same files, settings and seed give the same results, whatever the number of threads.',
  build: () => termList('settings', settingRows()),
  csv: () => ({ columns: ['setting', 'value'], rows: settingRows() }),
};

const filesFigure = {
  id: 'files',
  width: 'wide',
  title: 'Input files',
  wanted: () => !inspection, // an inspection lists its files in the certificate
  caption: () => 'SHA-256 of each file as it was read. A changed file has another SHA-256.',
  csv: () => ({
    columns: ['device', 'file', 'sha256', 'status', 'message'],
    rows: devices.flatMap(recordsOf).map(({ device: d, file, sha256 }) => [d.name, file, sha256, d.status, d.message]),
  }),
  build: filesTable,
};

const commandFigure = {
  id: 'command',
  title: 'The command that repeats this',
  wanted: () => report.command !== '',
  caption: () =>
    report.takes_lot_file
      ? 'LOT.toml: the lot file that names these devices and says how their files are read. If you gave options of reading besides it, add them. The name of a device is part of its seed.'
      : 'Every setting, and every option that the files were read with. Run it in the folder of the files, which are named without it.',
  build: () => commandLine(report.command),
};

const stepsFigure = {
  id: 'steps',
  title: 'How the records were read and corrected',
  long: true,
  build: stepsList,
};

const notesFigure = {
  id: 'notes',
  title: 'How the laws were read',
  long: true,
  wanted: () => laws.some((law) => law.notes.length > 0),
  build: lawNotes,
};

export const provenanceSection = {
  id: 'provenance',
  title: 'How it was made',
  figures: [settingsFigure, filesFigure, commandFigure, stepsFigure, notesFigure],
};

function settingRows() {
  const text = (value) => (Array.isArray(value) ? value.join(', ') || 'none' : String(value));
  const { rule_set: rules = null, lot = null } = report.assessment ?? {};
  return [
    ['isolaw', report.isolaw],
    ['seed', report.seed],
    ...Object.entries(report.settings).map(([key, value]) => [key, text(value)]),
    ...(rules ? [['rules', rules.id]] : []),
    ...(designText() ? [['design', designText()]] : []),
    ...(isNumber(lot?.size) ? [['lot-size', lot.size]] : []),
  ];
}

function filesTable() {
  const hash = ({ sha256 }) => element('span', { class: 'hash', title: sha256 }, short(sha256, 17));
  const status = ({ device }) => (device.status === 'ok' ? 'used' : element('span', { class: 'poor' }, 'refused'));
  const columns = [
    { title: 'Device', pinned: true, cell: ({ device }) => strong(device.name) },
    { title: 'File', cell: ({ file }) => file },
    { title: 'SHA-256', cell: hash },
    { title: 'Status', cell: status },
  ];
  return tableOf(columns, devices.flatMap(recordsOf), 'Input files');
}

function stepsList() {
  const items = devices.map((device) => {
    const sentences = [
      ...device.recognised.map(({ sentence }) => sentence),
      ...device.warnings.map((text) => 'Take care: ' + text),
      ...device.notes.map((text) => 'Note: ' + text),
      ...device.corrections.map((text) => 'Corrected: ' + text),
      ...device.cleaning,
    ];
    if (device.status !== 'ok') sentences.push('Refused: ' + device.message);
    const warned = device.warnings.length > 0;
    return element(
      'details',
      { class: warned ? 'steps warned' : 'steps', open: devices.length === 1 },
      element(
        'summary',
        {},
        element('b', {}, device.name),
        ' \u2013 ' + device.file + (warned ? ', ' + count(device.warnings.length, 'warning') : ''),
      ),
      element(
        'ul',
        {},
        ...sentences.map((text) => element('li', {}, text)),
        ...(inspection ? [] : recordsOf(device).map(({ file, sha256 }) => element('li', {}, 'SHA-256 of ' + file + ' ', element('code', {}, sha256)))),
      ),
    );
  });
  return element('div', {}, ...items);
}

function lawNotes() {
  return element(
    'div',
    {},
    ...laws
      .filter((law) => law.notes.length > 0)
      .map((law) =>
        element(
          'details',
          { class: 'steps' },
          element('summary', {}, element('b', {}, law.name), ' \u2013 ' + law.title),
          element('ul', {}, ...law.notes.map((note) => element('li', {}, note))),
        ),
      ),
  );
}
