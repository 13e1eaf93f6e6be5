import { element, strong } from '../dom.js';
import { devices, recordsOf, report } from '../report.js';
import { tableOf } from '../tables.js';
import { count } from '../text.js';
import { blank, echo } from './blank.js';

export const certificateSignatureFigure = {
  id: 'certificate-signature',
  title: '',
  build: signatureBlock,
};

export const certificateRecordsFigure = {
  id: 'certificate-records',
  title: 'Records',
  long: true,
  caption: () => 'SHA-256 of each file as it was read. A changed file has another SHA-256.',
  build: recordsTable,
};

// Makes the lines for signatures. A certificate with a grey mark must not be signed, so it gets no lines. A certificate
// with a red mark has tests that did not pass, and may be signed.
export function signatures() {
  const signer = (role) =>
    element(
      'div',
      { class: 'signer' },
      element('b', {}, role),
      ...['Name, rank', 'Date', 'Signature'].map((label) =>
        element('div', {}, element('span', { class: 'muted' }, label), blank(role + ': ' + label.toLowerCase())),
      ),
    );
  return report.result.mark && !report.result.mark_is_red
    ? element('p', { class: 'unsigned' }, 'Not for signature: ' + report.result.mark + '.')
    : element('div', { class: 'signers' }, signer('Tested by'), signer('Approved by'), report.result.word === 'PASS' ? signer('Accepted by') : null);
}

function signatureBlock() {
  return element(
    'div',
    { class: 'page-foot' },
    element(
      'p',
      { class: 'bound' },
      ...echo('Certificate number'),
      '\u2013 ' + (report.title || 'isolation devices') + ', ' + count(devices.length, 'device'),
    ),
    signatures(),
    element(
      'p',
      { class: 'fine' },
      'Values computed by isolaw ' + report.isolaw + ' from ' + count(devices.flatMap(recordsOf).length, 'record') +
        '. They hold for the devices named here, as they were tested.',
    ),
  );
}

function recordsTable() {
  const compressed = devices.some((device) => device.vertical?.file);
  const columns = [
    { title: 'Device', pinned: true, cell: ({ device }) => strong(device.name) },
    { title: 'File', cell: ({ file }) => file },
    { title: 'SHA-256', cell: ({ sha256 }) => element('td', { class: 'hash whole' }, sha256) },
    ...(compressed
      ? [
          { title: 'Vertical test', cell: ({ device }) => device.vertical?.file ?? '' },
          { title: 'K_v', cell: ({ device }) => device.vertical?.how ?? '' },
          { title: 'SHA-256', cell: ({ device }) => element('td', { class: 'hash whole' }, device.vertical?.sha256 ?? '') },
        ]
      : []),
  ];
  return tableOf(columns, devices.flatMap(recordsOf), 'Records of the certificate');
}
