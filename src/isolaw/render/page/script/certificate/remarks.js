import { sentences } from '../dom.js';
import { devices, report } from '../report.js';
import { enumerate, sentence } from '../text.js';

export const certificateRemarksFigure = {
  id: 'certificate-remarks',
  title: 'Remarks',
  long: true,
  wanted: () => certificateRemarks().length > 0,
  build: () => sentences(certificateRemarks().map(sentence)),
};

// Lists what a signer must know: doubts about the tests, corrections of records, and what the user told isolaw about
// the records. If there are several devices, doubts about a single record are on the page of its device.
function certificateRemarks() {
  // "all devices" replaces the list of names if the lot has at least `fewest` devices.
  const withDevices = (textsOf, fewest) => {
    const all = (names) => names.length === devices.length && names.length >= fewest;
    const found = new Map();
    for (const device of devices) for (const text of textsOf(device)) found.set(text, [...(found.get(text) ?? []), device.name]);
    return [...found].map(([text, names]) => (all(names) ? 'all devices' : enumerate(names)) + ': ' + text);
  };
  // Returns what options or the lot file said about how to read a record. Corrections are left out, because the
  // certificate lists them separately.
  const told = ({ recognised, corrections }) =>
    recognised.map(({ option, sentence }) => (option ? sentence : '')).filter((text) => text && !corrections.includes(text));
  return [
    ...report.findings.warnings.filter(({ certificate, topic }) => certificate && (topic !== 'record' || devices.length === 1)).map((warning) => warning.sentence),
    ...withDevices(({ corrections }) => corrections, 2).map((text) => 'corrected, ' + text),
    ...withDevices(told, 1),
  ];
}
