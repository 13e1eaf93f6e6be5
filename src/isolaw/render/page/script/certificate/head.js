import { assessedBlock, assessedCycle, counted } from '../cycles.js';
import { element } from '../dom.js';
import { designText } from '../lot.js';
import { devices, report } from '../report.js';
import { THIN, count, enumerate, isNumber, sentence, significant, spanText, unitText } from '../text.js';
import { WORDS, verdictBadge, wordOf } from '../verdicts.js';
import { blank, echoed } from './blank.js';
import { letterhead } from './letterhead.js';
import { KN, MM, decimalsIn, unitShown } from '../units.js';

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
  const tests = devices.map(assessedBlock),
    amplitude = spanText(tests.map((block) => block?.amplitude_mm), decimalsIn('mm', 1)),
    frequency = spanText(tests.map((block) => block?.frequency_Hz), 2);
  const conditions = [
    amplitude ? 'amplitude ' + amplitude + THIN + MM : '',
    frequency ? frequency + THIN + 'Hz' : '',
  ].filter(Boolean);
  const tested = devices.flatMap((device) => device.blocks.filter((block) => counted(block).length > 0));
  // Amplitudes that differ by less than 1 % are one step of the test.
  const steps = [];
  for (const value of tested.map((block) => block.amplitude_mm).sort((a, b) => a - b)) if (!(value < 1.01 * steps.at(-1))) steps.push(value);
  const load = spanText(devices.map((device) => assessedCycle(device)?.N_mean_kN), 3, significant);
  const thickness = spanText(devices.map((device) => device.rubber_thickness_mm), decimalsIn('mm', 1)),
    area = spanText(devices.map((device) => device.rubber_area_mm2), decimalsIn('mm^2', 0));
  const rubber = [
    thickness ? 'thickness ' + thickness + THIN + MM : '',
    area ? 'area ' + area + THIN + unitText(unitShown('mm^2')) : '',
  ].filter(Boolean);
  const compressed = devices.filter((device) => device.vertical?.file).length;
  const facts = [
    ...(report.letterhead ? [] : [['Laboratory', echoed('Laboratory')]]),
    ['Client, project', echoed('Client, project')],
    ['Certificate no.', echoed('Certificate number')],
    ['Test', 'cyclic shear of ' + count(devices.filter((device) => !device.copy_of).length, 'device') + (compressed > 0 ? ', compression of ' + compressed : '') + (isNumber(lot?.size) ? ' of a lot of ' + lot.size : '')],
    ...(lots.length > 0 ? [['Lot', enumerate(lots)]] : []),
    [
      'Tested',
      dates.length > 0 ? dates[0] + (dates.length > 1 ? ' to ' + dates[dates.length - 1] : '') : blank('Date of the tests'),
    ],
    ['Temperature', temperature ? temperature + THIN + '\u00b0C' : blank('Temperature')],
    ...(conditions.length > 0 ? [['Conditions', conditions.join(', ')]] : []),
    ...(steps.length > 1 ? [['Blocks tested', steps.map((value) => '\u00b1' + significant(value, 3)).join(', ') + THIN + MM]] : []),
    ...(load ? [['Vertical load', load + THIN + KN + ' (mean of the cycle)']] : []),
    ...(rubber.length > 0 ? [['Rubber', rubber.join(', ')]] : []),
    [
      'Held to',
      rules
        ? rules.title + (rules.edition ? ', ' + rules.edition : '') + (rules.verified_by ? ' (text verified)' : ' (limits not verified: no verdict)')
        : 'no rule set: values, no verdict',
    ],
    ...(designText() ? [['Design values', designText()]] : []),
  ];
  const long = new Set(['Blocks tested', 'Held to', 'Design values']);
  return element(
    'div',
    {},
    letterhead(),
    element('p', { class: 'certificate-title' }, 'Test certificate: ' + (report.title || 'isolation devices')),
    element(
      'dl',
      { class: 'facts-list in-two' },
      ...facts.flatMap(([term, said]) => {
        const whole = { class: long.has(term) ? 'whole' : null };
        return [element('dt', whole, term), element('dd', whole, typeof said === 'string' ? sentence(said) : said)];
      }),
    ),
    certificateResult(),
  );
}

function certificateResult() {
  const { word, sentence: said } = report.result;
  const badge = word ? verdictBadge(WORDS[word].verdict, wordOf(report.result)) : null;
  badge?.classList.add('word', WORDS[word].tone);
  return element('div', { class: 'verdict-box' }, badge, ' ' + sentence(said) + '.');
}
