// Shows the tests of a lot whose devices were tested under several conditions: the switch for it, a table with a row
// for each test, and a form for the table [conditions]. All of them edit the lot file.

import { button, element, visible } from './dom.js';
import { readingFields } from './device_form.js';
import { choiceField, fieldset, flagField, textField, textInput } from './fields.js';
import { forgetConditions, lotTables } from './lot.js';
import { canMoveTests, nameOfFile, proposalsOf, statesConditions, testsIn, withTestOf } from './lot_tests.js';
import { state } from './state.js';
import { text } from './text.js';
import { settingsOf, valuesOf, withKey, withSetting, withoutTable } from './toml.js';
import { trimmed } from '../src/isolaw/render/page/script/text.js';

export const hasConditions = () => statesConditions(lotTables().tables ?? []);

// The keys that have a column in the table of tests, besides the keys of ageing. The load has a column only if at least
// one record has no channel for it.
const COLUMNS = ['order', 'temperature-C', 'load-kN', 'rest-h'];

const openTests = new Set(); // the files and names of tests whose further keys are shown

// Returns all tests in the order of the files, so that a row stays in its place while somebody edits it. `columns` are
// the keys for which the row of a test has a field.
function tests() {
  const { tables } = lotTables();
  const places = [...state.files.keys()];
  const at = ({ file }) => (places.includes(file) ? places.indexOf(file) : places.length);
  return testsIn(tables).sort((one, other) => at(one) - at(other)).map((found, i) => {
    const test = { ...found, id: 'test-' + (i + 1), isPlain: found.number === found.owner, valuesOf: (key) => valuesOf(tables, found.number, key) };
    const columns = COLUMNS.filter((key) => (test.isPlain ? key === 'temperature-C' : key !== 'load-kN' || has(test, key) || needsLoad(test, tables)));
    const proposed = test.isPlain ? {} : proposalsOf(test, columns);
    return { ...test, columns, proposed };
  });
}

const has = ({ table }, key) => table.keys.has(key);
const lacks = (test) => !has(test, 'temperature-C') || !(test.isPlain || has(test, 'order') || has(test, 'started'));

// Returns what must still be stated before the program can read the lot: {tests, reference}. `tests` is a number of
// tests, and `reference` says whether the reference has no temperature.
export function unfilled() {
  const { tables } = lotTables();
  if (!tables || !statesConditions(tables)) return { tests: 0, reference: false };
  return { tests: tests().filter(lacks).length, reference: settingsOf(tables, 'conditions', 'reference').values['temperature-C'] === undefined };
}

// Returns what the program found in a test: {blocks, refusal}.
function foundIn({ device, name, file, isPlain }) {
  const { tests: blocks = [], refused = [] } = state.inspection?.conditions ?? {};
  const isIt = (one) => one.device === device && one.test === (isPlain ? nameOfFile(file) : name);
  return { blocks: blocks.filter(isIt), refusal: refused.find(isIt)?.reason };
}

// Says what was measured in a test, and how the program uses it.
function seen(test) {
  const { blocks, refusal } = foundIn(test);
  if (refusal) return element('small', { class: 'poor' }, visible(refusal));
  const measured = ({ frequency_Hz: frequency, load_kN: load, role, effect }) =>
    [frequency && trimmed(frequency, 3) + ' Hz', load && trimmed(load, 4) + ' kN', role === 'effect' ? effect : role].filter(Boolean).join(', ');
  return [...new Set(blocks.map(measured))].map((words) => element('small', {}, words));
}

// Returns whether the load of a test must be stated. The program refuses a stated load if the record has a channel for
// it.
function needsLoad(test, tables) {
  const columns = { ...valuesOf(tables, test.owner, 'columns').values, ...test.valuesOf('columns').values };
  if (Object.keys(columns).length > 0) return !columns.load;
  const { blocks, refusal } = foundIn(test);
  return Boolean(refusal) || blocks.some(({ load_kN: load }) => load === null);
}

// The functions below get an object with the functions edit(lot), which changes the lot file, redraw(), and propose(),
// which makes all records tests of devices.
export function testsSwitch({ edit, redraw, propose, fail }) {
  const isOn = hasConditions();
  const turn = (on) => {
    if (on) propose();
    else if (!canMoveTests(state.lot)) {
      fail(Object.assign(new Error(text.ownTables), { shown: true }));
      redraw();
    } else if (window.confirm(text.reallyNoConditions)) edit(forgetConditions(state.lot));
    else redraw(); // shows the switch as it was
  };
  return element('div', { class: 'tests-switch' }, flagField('conditions-on', [text.conditionsOn], isOn, (on) => turn(on === true)), element('p', { class: 'fine' }, isOn ? text.conditionsFill : text.conditionsWhy));
}

function rowsOf(test, columns, movable, { edit, redraw }) {
  const write = (key) => (value) => edit(withKey(state.lot, test.number, key, value));
  const value = (key) => test.table.keys.get(key)?.value;
  const of = ': ' + visible(test.name) + ', ' + visible(test.device);
  const cell = (head, control) => element('td', { 'data-label': head }, control);
  const input = (id, head, title, shown, change, proposal, options) =>
    cell(head, textInput(test.id + '-' + id, shown, change, { ...options, title, placeholder: proposal === undefined ? null : text.proposed(proposal), 'aria-label': head + of + (proposal === undefined ? '' : ', ' + text.proposedLong(proposal)) }));
  const aged = test.valuesOf('aged');
  const open = openTests.has(test.file + '\n' + test.name);
  const row = element(
    'tr',
    { class: 'test', id: test.id },
    element('th', { scope: 'row' }, visible(test.file), seen(test)),
    cell(text.device, movable && !test.isPlain ? textInput(test.id + '-device', test.device, (name) => (name === null ? redraw() : edit(withTestOf(state.lot, test.number, name))), { list: 'test-devices', 'aria-label': text.device + of }) : visible(test.device)),
    columns.map(({ key, label, unit, help, kind }) =>
      !test.columns.includes(key) ? cell(label, '') : input(key, label + (unit && ', ' + unit), help, value(key), write(key), test.proposed[key], { number: kind === 'number' })),
    state.testRows.aged.map(({ key, label, unit, help }) =>
      test.isPlain ? cell(label, '') : input('aged-' + key, text.aged + ' ' + label.toLowerCase() + (unit && ', ' + unit), help, aged.values[key], (typed) => edit(aged.write(state.lot, key, typed)), test.proposed.aged && '', { number: true })),
    element(
      'td',
      { class: 'act' },
      button(open ? text.done : text.moreKeys, () => {
        if (open) openTests.delete(test.file + '\n' + test.name);
        else openTests.add(test.file + '\n' + test.name);
        redraw();
      }, { class: 'action', id: test.id + '-more', 'aria-expanded': String(open), 'aria-label': (open ? text.done : text.moreKeys) + of }),
    ),
  );
  if (!open) return [row];
  const further = state.testRows.test.filter(({ key }) => !columns.some((column) => column.key === key));
  const field = ({ key, label, unit, help, kind, words }) => {
    const id = test.id + '-' + key,
      said = [label + (unit && ', ' + unit), help];
    if (kind === 'flag') return flagField(id, [label + ': ' + help], value(key), write(key));
    if (words.length > 0) return choiceField(id, said, [['', text.choices['']], ...words.map((word) => [word, word])], value(key), write(key));
    return textField(id, said, value(key), write(key), { number: kind === 'number' });
  };
  const leaveOut = () => {
    const isLast = testsIn(lotTables().tables).filter(({ owner }) => owner === test.owner).length === 1;
    edit(withoutTable(state.lot, isLast ? test.owner : test.number));
  };
  return [
    row,
    element(
      'tr',
      { class: 'form-row' },
      element(
        'td',
        { colspan: String(columns.length + 5) },
        element(
          'div',
          { class: 'form' },
          fieldset(text.groups.test, textField(test.id + '-name', text.form.name, value('name'), write('name')), test.isPlain ? null : further.map(field)),
          test.isPlain ? null : readingFields(test, undefined, [], (key, typed) => write(key)(typed), (key, channel, typed) => edit(test.valuesOf(key).write(state.lot, channel, typed))),
        ),
        element('p', { class: 'form-end' }, button(text.leaveOutTest, leaveOut, { class: 'action quiet', id: test.id + '-leave-out' })),
      ),
    ),
  ];
}

export function testsTable(use) {
  const all = tests();
  const shown = COLUMNS.filter((key) => all.some(({ columns: own }) => own.includes(key)));
  const columns = shown.flatMap((key) => state.testRows.test.filter((row) => row.key === key));
  const takeable = all.flatMap(({ number, proposed }) => columns.flatMap(({ key }) => (proposed[key] === undefined ? [] : [{ number, key, value: proposed[key] }])));
  const agedWithoutValue = all.filter(({ proposed }) => proposed.aged).length;
  const movable = canMoveTests(state.lot);
  const devices = [...new Set(all.map(({ device }) => device))];
  const head = (title, unit) => element('th', { scope: 'col' }, title, unit && element('small', {}, unit));
  return [
    takeable.length > 0 &&
      element('p', { class: 'hint care' }, text.proposedWhy(takeable.length), ' ', button(text.takeProposed, () => use.edit(takeable.reduce((lot, { number, key, value }) => withKey(lot, number, key, value), state.lot)), { class: 'action', id: 'take-proposed' })),
    agedWithoutValue > 0 && element('p', { class: 'hint care' }, text.agedWhy(agedWithoutValue)),
    !movable && element('p', { class: 'hint' }, text.ownTables),
    element('datalist', { id: 'test-devices' }, devices.map((name) => element('option', { value: name }))),
    element(
      'div',
      { class: 'scroll wide' },
      element(
        'table',
        { id: 'tests' },
        element('caption', { class: 'hidden' }, text.tests),
        element(
          'thead',
          {},
          element('tr', {}, head(text.test), head(text.device), columns.map(({ label, unit }) => head(label, unit)), state.testRows.aged.map(({ label, unit }) => head(text.aged + ' ' + label.toLowerCase(), unit)), element('td', { class: 'act' })),
        ),
        element('tbody', {}, all.map((test) => rowsOf(test, columns, movable, use))),
      ),
    ),
  ];
}

// The form for the table [conditions]. Keys that it has no field for stay as they are.
export function conditionsForm({ edit }) {
  const { tables } = lotTables();
  const reference = settingsOf(tables, 'conditions', 'reference'),
    design = settingsOf(tables, 'conditions', 'design');
  const field = (id, group, key, options = {}) => textField('conditions-' + id + '-' + key, text.conditions[key], group.values[key], (value) => edit(group.write(state.lot, key, value)), options);
  // A range is a list of its ends. A single number is a range too.
  const range = (key) => {
    const ends = [design.values[key] ?? []].flat();
    const write = (i) => (typed) => {
      const next = [i === 0 ? typed : (ends[0] ?? null), i === 1 ? typed : (ends[1] ?? null)].filter((end) => end !== null);
      edit(design.write(state.lot, key, next.length === 2 ? next : (next[0] ?? null)));
    };
    const [label] = text.conditions[key];
    const input = (end, i) => textInput('conditions-design-' + key + '-' + end, ends[i], write(i), { number: true, 'aria-label': label + ', ' + text.rangeEnds[end] });
    return element('div', { class: 'field range', role: 'group', 'aria-label': label }, element('span', {}, label), input('from', 0), element('span', {}, text.rangeEnds.to), input('to', 1));
  };
  const aged = design.values.aged ?? {};
  const ageing = ({ key, label, unit }) =>
    textField('conditions-design-aged-' + key, [text.aged + ' ' + label.toLowerCase() + (unit && ', ' + unit), ''], aged[key], (typed) => {
      const next = { ...aged, [key]: typed };
      if (typed === null) delete next[key];
      edit(design.write(state.lot, 'aged', Object.keys(next).length > 0 ? next : null));
    }, { number: true });
  const rules = tables.find(({ path }) => path === 'conditions')?.keys.get('rules')?.value;
  return [
    fieldset(text.referenceConditions, ['temperature-C', 'frequency-Hz', 'load-kN', 'strain-percent'].map((key) => field('reference', reference, key, { number: true })), field('reference', reference, 'cycle', { whole: true })),
    fieldset(text.designConditions, ['temperature-C', 'frequency-Hz', 'load-kN'].map(range), field('design', design, 'rest', { number: true }), field('design', design, 'cycles', { whole: true }), state.testRows.aged.map(ageing)),
    fieldset(text.combination, choiceField('conditions-rules', text.conditions.rules, [['', text.rulesOfLot], ...state.rules.map(({ id, title }) => [id, id + ': ' + title])], rules, (value) => edit(withSetting(state.lot, 'conditions', 'rules', value)))),
  ];
}
