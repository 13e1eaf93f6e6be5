import { element } from '../dom.js';
import { devices, report } from '../report.js';
import { enumerate, sentence } from '../text.js';

export const certificateRemarksFigure = {
  id: 'certificate-remarks',
  title: 'Remarks',
  long: true,
  wanted: () => certificateRemarks().length > 0,
  build: () => element('ul', { class: 'sentences' }, ...certificateRemarks().map((text) => element('li', {}, sentence(text)))),
};

// The signer must know the records' doubts and corrections, and what the program was told instead of finding it.
function certificateRemarks() {
  // With fewer than `fewest` devices their names are given in place of "all devices".
  const withDevices = (textsOf, fewest) => {
    const all = (names) => names.length === devices.length && names.length >= fewest;
    const found = new Map();
    for (const device of devices) for (const text of textsOf(device)) found.set(text, [...(found.get(text) ?? []), device.name]);
    return [...found].map(([text, names]) => (all(names) ? 'all devices' : enumerate(names)) + ': ' + text);
  };
  // Readings that an option or the lot file asked for. Corrections are listed separately.
  const told = ({ recognised, corrections }) =>
    recognised.map(({ option, sentence }) => (option ? sentence : '')).filter((text) => text && !corrections.includes(text));
  return [
    ...report.findings.warnings.filter((warning) => warning.certificate).map((warning) => warning.sentence),
    ...withDevices(({ corrections }) => corrections, 2).map((text) => 'corrected, ' + text),
    ...withDevices(told, 1),
  ];
}
