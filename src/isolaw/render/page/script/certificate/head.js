import { reportedBlock, reportedCycle } from '../cycles.js';
import { element, termList } from '../dom.js';
import { lotQuantities, sampleText } from '../lot.js';
import { devices, report } from '../report.js';
import { THIN, count, enumerate, isNumber, limitText, sentence, significant, spanText, trimmed } from '../text.js';
import { concerns, verdictBadge, worstVerdict } from '../verdicts.js';
import { blank } from './blank.js';
import { commonlyOpen, deviceVerdict, isLeftOut } from './verdict.js';

export const certificateHeadFigure = {
  id: 'certificate-head',
  title: '',
  build: certificateHead,
};

const allDevices = (key) => [...new Set(devices.map((device) => device[key]).filter(Boolean))];

function certificateHead() {
  const rules = report.assessment?.rule_set ?? null,
    lot = report.assessment?.lot ?? null;
  const lots = allDevices('lot'),
    dates = allDevices('test_date').sort(),
    temperature = spanText(devices.map((device) => device.temperature_C), 1);
  const tests = devices.map(reportedBlock),
    amplitude = spanText(tests.map((block) => block?.amplitude_mm), 1),
    frequency = spanText(tests.map((block) => block?.frequency_Hz), 2);
  const conditions = [
    amplitude ? 'amplitude ' + amplitude + THIN + 'mm' : '',
    frequency ? frequency + THIN + 'Hz' : '',
  ].filter(Boolean);
  const steps = [...new Set(devices.flatMap((device) => device.blocks.map((block) => significant(block.amplitude_mm, 3))))];
  const load = spanText(devices.map((device) => reportedCycle(device)?.N_mean_kN), 0);
  const thickness = spanText(devices.map((device) => device.rubber_thickness_mm), 1),
    area = spanText(devices.map((device) => device.rubber_area_mm2), 0);
  const rubber = [
    thickness ? 'thickness ' + thickness + THIN + 'mm' : '',
    area ? 'area ' + area + THIN + 'mm\u00b2' : '',
  ].filter(Boolean);
  const compressed = devices.filter((device) => device.vertical?.file).length;
  const limits = limitSentences(),
    remarks = certificateRemarks();
  const facts = [
    ['Laboratory', blank('Laboratory')],
    ['Client, project', blank('Client, project')],
    ['Certificate no.', numberBlank()],
    ['Test', 'cyclic shear of ' + count(devices.length, 'device') + (compressed > 0 ? ', compression of ' + compressed : '') + (isNumber(lot?.size) ? ' of a lot of ' + lot.size : '')],
    ...(lots.length > 0 ? [['Lot', enumerate(lots)]] : []),
    [
      'Tested',
      dates.length > 0 ? dates[0] + (dates.length > 1 ? ' to ' + dates[dates.length - 1] : '') : blank('Date of the tests'),
    ],
    ['Temperature', temperature ? temperature + THIN + '\u00b0C' : blank('Temperature')],
    ...(conditions.length > 0 ? [['Conditions', conditions.join(', ')]] : []),
    ...(steps.length > 1 ? [['Blocks tested', '\u00b1' + steps.join(', \u00b1') + THIN + 'mm']] : []),
    ...(load ? [['Vertical load', load + THIN + 'kN (mean of the cycle)']] : []),
    ...(rubber.length > 0 ? [['Rubber', rubber.join(', ')]] : []),
    [
      'Held to',
      rules
        ? rules.title + (rules.edition ? ', ' + rules.edition : '') + (rules.verified_by ? '' : ' (limits not verified: no verdict)')
        : 'no rule set: values, no verdict',
    ],
    ...(report.assessment?.design?.length > 0
      ? [
          [
            'Design values',
            report.assessment.design.map(({ name, value, unit }) => name + ' ' + trimmed(value) + THIN + unit).join(', '),
          ],
        ]
      : []),
    ...(limits.length > 0 ? [['Limits', limits.join('; ')]] : []),
    ['Result', certificateResult()],
    ...(remarks.length > 0 ? [['Remarks', listOf(remarks)]] : []),
  ];
  return element(
    'div',
    {},
    element('p', { class: 'certificate-title' }, 'Test certificate: ' + (report.title || 'isolation devices')),
    termList('facts-list', facts.map(([term, said]) => [term, typeof said === 'string' ? sentence(said) : said])),
  );
}

// The number is written once and stands beside the signatures too.
function numberBlank() {
  const line = blank('Certificate number');
  line.addEventListener('input', () => {
    for (const echo of document.querySelectorAll('.certificate-number')) echo.textContent = line.textContent;
  });
  return line;
}

const listOf = (sentences) =>
  element('ul', { class: 'plain-list' }, ...sentences.map((text) => element('li', {}, sentence(text))));

// Limits with their clauses, each said once.
function limitSentences() {
  const clauseOf = (quantity) =>
    devices.flatMap((device) => device.assessments).find((a) => a.clause && concerns(a, quantity))?.clause;
  return lotQuantities
    .filter((quantity) => quantity.limit_individual || quantity.limit_mean)
    .map(
      (quantity) =>
        quantity.quantity + ' ' +
        [
          quantity.limit_individual ? limitText(quantity.limit_individual) + ' of the design value' : '',
          quantity.limit_mean ? 'mean of the lot ' + limitText(quantity.limit_mean) : '',
        ]
          .filter(Boolean)
          .join(', ') +
        (clauseOf(quantity.quantity) ? ' (' + clauseOf(quantity.quantity) + ')' : ''),
    );
}

// What a reader of the sheet must know of the records: doubts, corrections, what the program was told of them.
function certificateRemarks() {
  const topics = new Set(['copies', 'record', 'refused']);
  // 'all devices' is said of `fewest` devices or more.
  const withDevices = (textsOf, fewest) => {
    const all = (names) => names.length === devices.length && names.length >= fewest;
    const found = new Map();
    for (const device of devices) for (const text of textsOf(device)) found.set(text, [...(found.get(text) ?? []), device.name]);
    return [...found].map(([text, names]) => (all(names) ? 'all devices' : enumerate(names)) + ': ' + text);
  };
  // What the program was told of a record stands with its option in brackets; how columns were recognised does not.
  const told = (device) => device.recognised.filter((line) => /\(--[a-z]/.test(line));
  return [
    ...report.findings.warnings.filter((warning) => topics.has(warning.topic)).map((warning) => warning.sentence),
    ...withDevices(({ corrections }) => corrections, 2).map((text) => 'corrected, ' + text),
    ...withDevices(told, 1),
  ];
}

function certificateResult() {
  if (!report.assessment?.rule_set) return 'values, no verdict';
  const { sample } = report.assessment.lot;
  const verdicts = devices.map((device) => deviceVerdict(device).verdict);
  const times = (verdict) => verdicts.filter((found) => found === verdict).length;
  const lot = lotQuantities
    .filter((quantity) => quantity.verdict)
    .map(({ quantity, verdict, reason }) => ({ what: 'mean ' + quantity + ' of the lot', verdict, reason }));
  if (sample?.verdict) lot.unshift({ what: 'size of the sample: ' + sampleText({ ...sample, verdict: '' }), verdict: sample.verdict, reason: '' });
  const open = commonlyOpen();
  const said = [
    ...lot.map(({ what, verdict, reason }) => what + ': ' + verdict + (reason ? ' (' + reason + ')' : '')),
    times('fail') > 0 ? count(times('fail'), 'device') + ' outside a limit' : '',
    times('pass') > 0 ? count(times('pass'), 'device') + ' within the limits that could be assessed' : '',
    times('information') > 0 ? count(times('information'), 'device') + ' compared, without verdict' : '',
    times('not assessed') + times(null) > 0 ? count(times('not assessed') + times(null), 'device') + ' not assessed' : '',
    open.length > 0 ? 'not assessed on any device: ' + open.join(', ') : '',
  ].filter(Boolean);
  const worst = worstVerdict([...verdicts.filter(Boolean), ...lot.map(({ verdict }) => verdict)]);
  // A lot does not pass while one of its devices could not be looked at.
  const overall = worst === 'pass' && devices.some(isLeftOut) ? 'not assessed' : worst;
  return element('div', {}, overall ? verdictBadge(overall) : null, listOf(said));
}
