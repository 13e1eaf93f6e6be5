import { element, shortList } from '../dom.js';
import { tableOf } from '../tables.js';
import { DASH, THIN, count, enumerate, isNumber, sentence, shareText, trimmed, unitText, withUnit } from '../text.js';
import { KN, MM } from '../units.js';
import { obstacle } from './bound_laws.js';
import { agedText, conditions, cyclesText, factorText, findings, intervalText, restText, statusWord, toneOf } from './data.js';

export const answerFigure = { id: 'conditions-answer', title: '', build: answer };

const SIDES = [['max', 'Upper'], ['min', 'Lower']];
const WORST_FIRST = ['poor', 'care', 'accent', 'good'];

// Kinds of findings that are shown in the coloured band, because they say what the bounds mean for the design.
const JUDGED = ['dependence-not-kept', 'mean-properties-judged'];
// Kinds of findings that are left out, because the table shows their numbers.
const IN_THE_TABLE = ['design-bound'];

function answer() {
  const { bounds, reference, design_conditions: design } = conditions;
  const [first] = bounds;
  const tones = bounds.slice(0, 2).flatMap((bound) => SIDES.map(([side]) => toneOf(bound[side].status)));
  const isBroken = findings.some(({ kind }) => kind === 'dependence-not-kept');
  const tone = isBroken ? 'poor' : (WORST_FIRST.find((one) => tones.includes(one)) ?? 'muted');
  const line = (term, text) => (text ? element('p', {}, element('b', {}, term), ' ' + text) : null);
  const effects = (key) => enumerate([...new Set(bounds.flatMap((bound) => SIDES.flatMap(([side]) => bound[side][key] ?? [])))], 9);
  const without = effects('without_interval');
  const others = ['serious', 'caution', 'note'].flatMap((one) =>
    findings.filter(({ kind, severity }) => severity === one && !JUDGED.includes(kind) && !IN_THE_TABLE.includes(kind)),
  );
  return element(
    'div',
    {},
    element(
      'div',
      { class: 'band ' + (tone === 'accent' ? 'good' : tone) },
      element('p', { class: 'headline' }, first ? headline(first) : 'No design conditions are stated, so there are no bounds.'),
      first ? boundsTable(bounds) : null,
      line('NOT COVERED:', effects('not_covered')),
      line('ASSUMED:', assumed()),
      ...findings.filter(({ kind }) => JUDGED.includes(kind)).map(({ sentence: text }) => element('p', {}, sentence(text))),
    ),
    element(
      'div',
      { class: 'remarks' },
      line('Reference', withCycle(conditionsText(reference), cyclesText(reference))),
      line('Design', designText(design)),
      line('Stated, not measured', 'temperature, ageing, rest.'),
      line('No interval', without && without + ': one device, or tests that do not differ.'),
      line('Bound laws', obstacle && obstacle + '.'),
      ...(others.length > 0 ? shortList(others.map(({ sentence: text }) => element('li', {}, sentence(text))), 3, 2) : []),
    ),
  );
}

// Lists the effects whose factors are assumed, each with the rule set and the clause that gives the factor.
function assumed() {
  const texts = conditions.design.filter((row) => row.assumed).map(({ effect, assumed: { rules, clause, verified } }) => {
    const source = [[rules, clause].filter(Boolean).join(' '), verified ? '' : 'not verified'].filter(Boolean).join(', ');
    return effect + (source ? ' (' + source + ')' : '');
  });
  return [...new Set(texts)].join(', ');
}

const withCycle = (text, cycle) => [text, cycle].filter(Boolean).join(', ');

// Returns a bound as text. If the factor of an effect is missing in it, the bound is incomplete and gets "at least" or
// "at most", because with this factor it could only be farther from 1.
const boundText = (side, { complete, factor }) => (complete ? '' : side === 'max' ? 'at least ' : 'at most ') + factorText(factor);

function headline({ quantity, unit, devices, value_at_reference: value, max, min }) {
  const times = ' goes from ' + boundText('min', min) + ' to ' + boundText('max', max) + ' times its value at reference';
  return quantity + times + (devices > 0 ? ', ' + withUnit(value, unitText(unit)) : '') + '.';
}

function boundsTable(bounds) {
  const cell = (side) => (bound) => {
    const { interval, status, share_shown: share } = bound[side];
    return element(
      'td',
      {},
      element('b', {}, boundText(side, bound[side])),
      ' ',
      element('span', { class: 'sure ' + toneOf(status) }, statusWord(status)),
      interval ? element('small', {}, intervalText(interval) + ' (95\u202f%)') : null,
      share < 1 ? element('small', {}, shareText(share, 0) + ' from tests') : null,
    );
  };
  const columns = [
    { title: 'Property', cell: ({ quantity }) => quantity }, ...[...SIDES].reverse().map(([side, title]) => ({ title, cell: cell(side) })),
  ];
  return tableOf(columns, bounds.slice(0, 2), 'Bounds over the design conditions', { sorts: false });
}

const span = ([low, high], unit) => (low === high ? trimmed(low) : trimmed(low) + ' to ' + trimmed(high)) + THIN + unit;
const alone = (value) => (Array.isArray(value) ? value : [value, value]);

// Returns the conditions as text. The members of `of` are numbers, ranges [low, high], or null.
function conditionsText(of) {
  const units = [['temperature_C', '\u00b0C'], ['frequency_Hz', 'Hz'], ['load_kN', KN], ['strain_percent', '% strain'], ['disp_mm', MM]];
  return units.filter(([key]) => isNumber(of[key]) || Array.isArray(of[key])).map(([key, unit]) => span(alone(of[key]), unit)).join(', ');
}

function designText({ full_rest: full, rest_h: rest, cycles, aged, years, ...of }) {
  const parts = [
    conditionsText(of),
    full ? 'full rest' : isNumber(rest) && 'rest of ' + restText(rest),
    isNumber(cycles) && count(cycles, 'cycle'),
    aged && 'aged ' + agedText(aged),
    isNumber(years) && trimmed(years) + ' years at ' + trimmed(of.service_temperature_C) + THIN + '\u00b0C',
  ];
  return parts.filter(Boolean).join(', ') || DASH;
}
