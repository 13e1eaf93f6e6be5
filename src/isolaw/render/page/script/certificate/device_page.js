import { chosen } from '../choice.js';
import { deviceChooser } from '../choosers.js';
import { assessedBlock, assessedCycle } from '../cycles.js';
import { element, sentences, strong, termList } from '../dom.js';
import { drawn, render } from '../figure.js';
import { designText } from '../lot.js';
import { devices, recordsOf, report, tested } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, THIN, deviation, enumerate, fixed, isNumber, limitText, sentence, significant, withUnit } from '../text.js';
import { KN, MM, decimalsIn } from '../units.js';
import { verdictBadge, wordOf } from '../verdicts.js';
import { echo } from './blank.js';
import { letterhead } from './letterhead.js';
import { loopDrawing } from './loop.js';
import { signatures } from './signatures.js';

// A page of the certificate for each device. The screen shows only the page of the chosen device; the printed
// certificate has all pages.
export const certificateDeviceFigure = {
  id: 'certificate-device',
  title: 'A page for each device',
  wanted: () => devices.length > 1 && tested.length > 0,
  depends: ['tested'],
  controls: () => [deviceChooser('certificate-of', tested, 'tested')],
  build: () => element('div', { class: 'device-pages' }, (showsAll ? tested : [devices[chosen.tested]]).map(pageOf)),
};

let showsAll = false;
const made = new Map(); // device -> its page, which keeps what was filled in
const pageOf = (device) => made.get(device) ?? made.set(device, devicePage(device)).get(device);

export function showDevicePages({ all }) {
  showsAll = all;
  const place = drawn.get(certificateDeviceFigure);
  if (!place) return;
  place.stale = true;
  render(certificateDeviceFigure);
}

function devicePage(device) {
  const place = tested.indexOf(device);
  return element(
    'article',
    { class: 'device-page', 'aria-label': 'Test certificate of ' + device.name },
    letterhead(),
    element('p', { class: 'certificate-title' }, 'Test certificate: device ' + device.name),
    termList('facts-list', facts(device).map(([term, text]) => [term, sentence(text)])),
    device.verdict
      ? element('div', { class: 'verdict-box' }, verdictBadge(device.verdict, sentence(device.verdict_text)), report.result.word ? ' The lot: ' + wordOf(report.result) + '.' : '')
      : null,
    device.assessments.length > 0 ? assessments(device) : values(device),
    element('div', { class: 'side-by-side' }, loopDrawing(device), element('div', {}, ...notes(device))),
    element(
      'div',
      { class: 'page-foot' },
      element('p', { class: 'bound' }, ...['Certificate number', 'Laboratory', 'Client, project'].flatMap(echo)),
      signatures(),
      footer(device, place),
    ),
  );
}

function facts(device) {
  const block = assessedBlock(device),
    load = assessedCycle(device)?.N_mean_kN;
  const rules = report.assessment?.rule_set;
  const given = (value, text) => (value === null || value === undefined || value === '' ? '' : text(value));
  return [
    ['Device', [device.name, given(device.serial, (serial) => 'serial number ' + serial), given(device.lot, (lot) => 'lot ' + lot)].filter(Boolean).join(', ')],
    ['Tested', given(device.test_date, String) || 'date not stated'],
    [
      'Rubber',
      given(device.rubber_thickness_mm, (value) => 'thickness ' + fixed(value, decimalsIn('mm', 1)) + THIN + MM) || 'thickness not stated',
    ],
    [
      'Conditions',
      [
        block ? '\u00b1' + significant(block.amplitude_mm) + THIN + MM : '',
        given(block?.frequency_Hz, (value) => significant(value, 2) + THIN + 'Hz') || 'frequency not known',
        isNumber(load) ? 'vertical load ' + significant(load, 4) + THIN + KN : 'vertical load not recorded',
        given(device.temperature_C, (value) => fixed(value, 1) + THIN + '\u00b0C') || 'temperature not stated',
      ].filter(Boolean).join(', '),
    ],
    ...(rules ? [['Held to', rules.title + (rules.edition ? ', ' + rules.edition : '') + (rules.verified_by ? ' (text verified)' : ' (limits not verified)')]] : []),
    ...(designText() ? [['Design values', designText()]] : []),
  ];
}

function assessments(device) {
  return tableOf(
    [
      { title: 'Property', pinned: true, cell: (a) => strong(a.quantity) },
      { title: 'Measured', number: true, cell: (a) => (isNumber(a.value) ? withUnit(a.value, a.unit) : 'not tested') },
      { title: 'Design value', number: true, cell: (a) => withUnit(a.nominal, a.unit) },
      { title: 'Limit', cell: (a) => limitText(a.limit) },
      { title: 'Clause', cell: (a) => element('td', { class: 'note' }, a.clause || DASH) },
      { title: 'Away', number: true, cell: (a) => deviation(a.deviation_percent) },
      { title: 'Verdict', cell: (a) => verdictBadge(a.verdict) },
    ],
    device.assessments.filter((a) => a.limit || isNumber(a.value)),
    'Limits and values of ' + device.name,
  );
}

// Without a rule set there are no limits. The page then lists the values of the cycle that stands for the device.
function values(device) {
  const cycle = assessedCycle(device);
  if (!cycle) return element('p', {}, 'No cyclic properties: ' + device.properties_refusal);
  const keys = ['amplitude_mm', 'K_eff_kN_per_mm', 'damping_percent', 'energy_kN_mm', 'Q_d_kN', 'K_d_kN_per_mm'];
  const rows = keys.map((key) => ({ heading: report.headings.cycles[key][0], value: cycle[key] }));
  return tableOf(
    [
      { title: 'Property', pinned: true, cell: ({ heading }) => strong(heading.title) },
      { title: 'Measured', number: true, cell: ({ heading, value }) => withUnit(value, heading.unit) },
    ],
    rows,
    'Values of ' + device.name,
  );
}

function notes(device) {
  const open = device.assessments.filter((a) => a.limit && a.verdict === 'not assessed');
  const remarks = [
    ...device.findings.filter(({ certificate }) => certificate).map((finding) => finding.sentence),
    ...device.doubts.map(({ quantity, otherwise, unit, condition }) => quantity + ' would be ' + withUnit(otherwise, unit, 3) + ' if ' + condition + '.'),
  ];
  const part = (title, texts) => (texts.length > 0 ? [element('h4', {}, title), sentences(texts.map(sentence))] : []);
  const reasons = [...new Set(open.map(({ reason }) => reason).filter(Boolean))];
  return [
    ...part('Corrections by hand', device.corrections.length > 0 ? device.corrections : ['None.']),
    ...part('To be complete', reasons.map((reason) => enumerate([...new Set(open.filter((a) => a.reason === reason).map((a) => a.quantity))]) + ': ' + reason + '.')),
    ...part('Remarks', remarks),
  ];
}

const footer = (device, place) =>
  element(
    'p',
    { class: 'fine' },
    'Device ' + (place + 1) + ' of ' + tested.length + ' with a record. Values computed by isolaw ' + report.isolaw + ', seed ' + report.seed + '. ',
    ...recordsOf(device).map(({ file, sha256 }) => element('span', {}, 'Record ' + file + ', SHA-256 ', element('span', { class: 'hash whole' }, sha256), '. ')),
  );
