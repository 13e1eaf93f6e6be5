import { commandLine, element } from '../dom.js';
import { recommendation, standings } from '../recommendation.js';
import { devices, laws, report } from '../report.js';
import { THIN, count, errorText, sentence, significant } from '../text.js';
import { MM } from '../units.js';

export const answerFigure = { id: 'answer', title: '', width: 'narrow', build: answer };

const TONES = { clear: 'good', tie: 'care', weak: 'care' };
const MOST_WARNINGS = 3;
const told = (findings, between = ' ') => sentence(findings.map((one) => one.sentence).join(between));

function answer() {
  const { law, headline, explanation, sure, reasons, weak, reach, surer } = recommendation;
  // If a law is recommended, the answer gives only one of its reasons: a better law that was ruled out. The other
  // reason, the error of the next best law, stands in the table of laws.
  const beyond = reach.filter(({ kind }) => kind !== 'law-shown-up-to'); // numbersOfAnswer() shows this finding
  const why = law ? reasons.filter(({ kind }) => kind === 'why-better-refused') : reasons;
  const numbers = numbersOfAnswer().map(([value, what]) => element('div', {}, element('b', {}, value), element('span', {}, what)));
  return element(
    'div',
    { class: 'answer' },
    element('p', { class: 'headline' }, headline, ...(law ? [' ', element('span', { class: 'sure ' + TONES[sure] }, sure)] : [])),
    element('p', { class: 'explanation' }, [sentence(explanation), told(why)].filter(Boolean).join(' ')),
    element('div', { class: 'numbers' }, ...numbers),
    law ? element('p', { class: 'why' }, 'Errors are shares of the force\u2019s standard deviation.') : null,
    law && weak.length > 0 ? element('p', { class: 'box doubts' }, element('b', {}, 'Low confidence'), ' ' + told(weak, '; ') + '.') : null,
    law ? next() : null,
    surer.length > 0 ? element('p', { class: 'box' }, element('b', {}, law ? 'To be surer' : 'Next'), ' ' + told(surer, '; ') + '.') : null,
    beyond.length > 0 ? element('p', { class: 'why' }, told(beyond)) : null,
    warnings(),
  );
}

function numbersOfAnswer() {
  const [first] = standings;
  const used = devices.filter(({ status }) => status === 'ok').length;
  const ofDevices = [used + ' of ' + devices.length, devices.length === 1 ? 'device used' : 'devices used'];
  if (!recommendation.law)
    return [[String(laws.length), laws.length === 1 ? 'law tried' : 'laws tried'], [errorText(first?.error), 'least error'], ofDevices];
  return [
    ...(recommendation.valid_mm === null ? [] : [[significant(recommendation.valid_mm) + THIN + MM, 'shown up to']]),
    [String(first.parameters), first.parameters === 1 ? 'parameter' : 'parameters'],
    ofDevices,
  ];
}

function next() {
  const { export_command: command, programs } = recommendation;
  return element(
    'div',
    { class: 'box next' },
    element('p', {}, element('b', {}, 'Next'), ' in the campaign\u2019s folder:'),
    commandLine(command),
    programs ? element('p', { class: 'why' }, programs + '.') : null,
  );
}

// Shows first the warnings that concern the answer. All others are hidden behind one line, which the reader can open.
function warnings() {
  const all = report.findings.warnings;
  const first = report.findings.answer_warnings.slice(0, MOST_WARNINGS).map((place) => all[place]);
  const rest = all.filter((warning) => !first.includes(warning));
  const item = ({ sentence: text, action }) =>
    element('li', { tabindex: '0' }, element('div', {}, sentence(text), ...(action ? [' ', element('span', { class: 'do' }, action + '.')] : [])));
  if (all.length === 0)
    return element('p', { class: 'calm' }, 'Nothing stands out: no device was refused, no run failed, no parameter lies at its bound.');
  const more = count(rest.length, first.length > 0 ? 'more warning' : 'warning');
  return element(
    'div',
    { class: 'warnings' },
    element('ul', {}, ...first.map(item)),
    rest.length > 0 ? element('details', {}, element('summary', {}, more), element('ul', {}, ...rest.map(item))) : null,
  );
}
