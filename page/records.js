// The first view: it lists the dropped files and what the program recognised in them, and offers forms to correct it.

import { button, element, fill, place, sign, visible } from './dom.js';
import { deviceForm } from './device_form.js';
import { DASH, isNumber, trimmed } from '../src/isolaw/render/page/script/text.js';
import { asComplaints } from './engine_use.js';
import { lotForm } from './lot_form.js';
import { lotDevices, lotTables, namedFiles } from './lot.js';
import { CHANNELS, columnAsRead, guessesOf, hasValues, isDoubtful, lacksTime, readingOf } from './reading.js';
import { state } from './state.js';
import { conditionsForm, hasConditions, testsSwitch, testsTable, unfilled } from './tests_form.js';
import { text } from './text.js';
import { withKey, withoutTable } from './toml.js';

// The numbers of the devices whose forms are open, and of those whose values the user showed (true) or hid (false).
// They belong to the lot with the number openIn; drawRecords() clears them when the user opens another lot.
let openForms = new Set(),
  chosenValues = new Map(),
  openIn = 0;
const leftOut = (place) => {
  const moved = (one) => (one > place ? one - 1 : one);
  openForms = new Set([...openForms].filter((one) => one !== place).map(moved));
  chosenValues = new Map([...chosenValues].filter(([one]) => one !== place).map(([one, shown]) => [moved(one), shown]));
};

// Only the values of the first devices are shown from the start, so that the page stays fast with many devices.
const FIRST = 3;
const showsValues = (place) => chosenValues.get(place) ?? place <= FIRST;

const number = (value, digits) => (isNumber(value) ? trimmed(value, digits) : DASH);

// Shows complaints of the program. `own` is the file whose name stands above the list; complaints about it do not
// repeat the name.
export const problemList = (complaints, own = '') =>
  complaints.map(({ where, found, allowed, advice }) =>
    element(
      'div',
      { class: 'problem' },
      element('p', {}, visible([where === own ? '' : where, found].filter(Boolean).join(': '))),
      allowed && element('p', {}, element('b', {}, text.allowed + ' '), visible(allowed)),
      advice && element('p', {}, element('b', {}, text.try + ' '), visible(advice)),
    ),
  );

// Returns the devices of the lot file, each with its entry in the result of `isolaw inspect`.
function devicesFound() {
  const devices = lotDevices();
  const found = state.inspection?.devices ?? [];
  const alike = found.length === devices.length;
  return devices.map((device, i) => {
    const own = alike ? found[i] : found.find(({ name }) => name === device.name);
    const absent = device.file && !state.files.has(device.file) ? text.absent : '';
    const problems = absent ? asComplaints(absent) : own ? refusalOf(own) : devices.length === 1 ? state.problems : [];
    return { device, found: own, problems, readable: own?.status === 'ok' };
  });
}

// Returns the complaints because of which a device was refused or has no properties.
const refusalOf = ({ status, complaints, message, properties_refusal: bare }) =>
  status === 'ok' ? asComplaints(bare ?? '') : (complaints ?? asComplaints(message));

export const readable = () => devicesFound().filter((one) => one.readable).length;

const readAs = (found) =>
  CHANNELS.filter((channel) => found?.columns?.[channel] ?? false).map((channel) => element('span', { class: 'channel-read' }, element('span', { class: 'muted' }, text.channelShort[channel] + ' '), visible(columnAsRead(found, channel))));

const reported = (found) => {
  const block = found?.blocks?.find(({ number: one }) => one === found.reported?.block);
  return block?.cycles.find(({ number: one }) => one === found.reported?.number) ?? null;
};

function remarks({ found, problems, device }) {
  if (problems.length > 0) {
    const items = problemList(problems, device.file);
    return element(
      'div',
      { class: found?.status === 'ok' ? 'care' : 'poor' },
      items.slice(0, 2),
      items.length > 2 && element('details', {}, element('summary', {}, text.more(items.length - 2)), items.slice(2)),
    );
  }
  const warnings = found?.warnings ?? [];
  if (warnings.length === 0) return element('span', { class: 'muted' }, found ? text.fine : '');
  const said = (some) => element('ul', { class: 'sentences' }, some.map((one) => element('li', {}, visible(one))));
  return element(
    'div',
    {},
    said(warnings.slice(0, 2)),
    warnings.length > 2 && element('details', {}, element('summary', {}, text.more(warnings.length - 2)), said(warnings.slice(2))),
  );
}

// Makes the table cell that says how a device was read. It says this in words only if the values of the device are
// hidden. A button shows and hides the values.
function readCell({ device, found }, redraw) {
  const shown = hasValues(found) && showsValues(device.place);
  const guesses = guessesOf(found).length;
  return element(
    'div',
    { class: 'channels-read' },
    !shown && readAs(found),
    !shown && hasValues(found) && lacksTime(found) && element('b', { class: 'guess' }, text.noTimeShort),
    !shown && guesses > 0 && element('b', { class: 'guess' }, text.guesses(guesses)),
    hasValues(found) &&
      button(
        shown ? text.hideValues : text.showValues,
        () => {
          chosenValues.set(device.place, !shown);
          redraw();
        },
        { class: 'link', id: 'values-' + device.place, 'aria-expanded': String(shown), 'aria-label': (shown ? text.hideValues : text.showValues) + ': ' + visible(device.name) },
      ),
  );
}

function rowsOf(one, edit, redraw) {
  const { device, found, problems, readable: isRead } = one;
  const cycle = reported(found);
  const isOpen = openForms.has(device.place);
  const tone = !found && problems.length === 0 ? 'muted' : !isRead ? 'poor' : problems.length > 0 || found.warnings.length > 0 || isDoubtful(found) ? 'care' : 'good';
  const shape = { good: 'tick', care: 'care', poor: 'cross' }[tone];
  const cell = (label, value, className) => element('td', { class: className, 'data-label': label }, value);
  const toggle = button(
    isOpen ? text.done : text.reread,
    () => {
      if (isOpen) openForms.delete(device.place);
      else openForms.add(device.place);
      redraw();
    },
    { class: 'action', id: 'reread-' + device.place, 'aria-expanded': String(isOpen), 'aria-label': (isOpen ? text.done : text.reread) + ': ' + visible(device.name) },
  );
  const rows = [
    element(
      'tr',
      { class: 'device', id: 'device-' + device.place, 'data-tone': tone },
      element('th', { scope: 'row', class: 'device-name' }, element('div', { class: 'named' }, shape && sign(shape, tone), element('span', {}, visible(device.name), device.file && element('small', {}, visible(device.file)), readCell(one, redraw)))),
      cell(text.samples, number(isRead ? found.samples : null, 9), 'number'),
      cell(text.amplitude, number(cycle?.amplitude_mm, 4), 'number'),
      cell(text.stiffness, number(cycle?.K_eff_kN_per_mm, 4), 'number'),
      cell(text.dampingShort, number(cycle?.damping_percent, 3), 'number'),
      cell(text.remarks, remarks(one), 'remarks-cell'),
      element('td', { class: 'act' }, toggle),
    ),
  ];
  if (hasValues(found) && showsValues(device.place)) {
    const change = (field) => {
      openForms.add(device.place);
      redraw();
      const control = place('device-' + device.place + '-' + field);
      control?.scrollIntoView({ block: 'center' });
      control?.focus({ preventScroll: true });
    };
    rows.push(element('tr', { class: 'reading-row', id: 'reading-' + device.place }, element('td', { colspan: '7' }, readingOf(device, found, change))));
  }
  if (isOpen) {
    const write = (key, value) => edit(withKey(state.lot, device.number, key, value));
    const writePart = (key, channel, value) => edit(device.valuesOf(key).write(state.lot, channel, value));
    rows.push(
      element(
        'tr',
        { class: 'form-row', id: 'form-' + device.place },
        element(
          'td',
          { colspan: '7' },
          deviceForm(device, found, problems, write, writePart),
          element(
            'p',
            { class: 'form-end' },
            button(text.done, () => {
              openForms.delete(device.place);
              redraw('reread-' + device.place);
            }, { class: 'action' }),
            button(text.leaveOut, () => {
              leftOut(device.place);
              edit(withoutTable(state.lot, device.number));
              focusTitle();
            }, { class: 'action quiet' }),
          ),
        ),
      ),
    );
  }
  return rows;
}

export const noteList = () => state.notes.length > 0 && element('div', { role: 'status' }, element('ul', { class: 'notes' }, state.notes.map((note) => element('li', {}, visible(note)))));

const focusTitle = () => place('records-title').focus();

function band(all) {
  const read = all.filter((one) => one.readable).length;
  const not = all.length - read;
  const bare = all.filter((one) => one.readable && one.problems.length > 0).length;
  const doubtful = all.filter(({ found }) => isDoubtful(found)).length;
  // The fault of a lot's only device is shown in the device's row and not above the table.
  const broken = state.problems.length > 0 && !state.inspection && all.length !== 1;
  // There is no lot file if the user dropped only the results of a campaign.
  if (state.lot === null && state.campaign && not === 0) return { read, node: ['muted', text.readBand.results, text.readResults, false] };
  const { tests, reference } = unfilled();
  const refused = state.inspection?.conditions?.refused.length ?? 0;
  if (tests > 0 || reference) return { read, node: ['care', text.readBand.unfilled, text.readUnfilled(tests, reference), false] };
  const [tone, word, said] = broken
    ? ['poor', text.readBand.broken, '']
    : read === 0
      ? ['poor', text.readBand.none, text.readNone]
      : not > 0
        ? ['care', text.readBand.some(read, not) + text.readBand.bare(bare), text.readSome]
        : bare + refused > 0
          ? ['care', text.readBand.all(read) + text.readBand.bare(bare) + text.readBand.refused(refused), text.readBare]
          : doubtful > 0
            ? ['care', text.readBand.all(read), text.readDoubtful(doubtful)]
            : ['good', text.readBand.all(read), text.readAll];
  return { read, node: [tone, word, said, broken] };
}

export function drawRecords(use) {
  const { edit, show, pick, pickFolder, startOver, addAgain } = use;
  const node = place('view-records');
  const redraw = (focus) => {
    drawRecords(use);
    if (focus) place(focus)?.focus({ preventScroll: true });
  };
  if (openIn !== state.lots) {
    openIn = state.lots;
    openForms.clear();
    chosenValues.clear();
  }
  const ofTests = { ...use, redraw };
  const all = devicesFound();
  const { read, node: [tone, word, said, broken] } = band(all);
  const unreadable = all.filter((one) => !one.readable);
  const pending = all.length > 0 && !state.inspection && state.problems.length === 0;
  const named = namedFiles();
  const missing = named ? [...named].filter((path) => !state.files.has(path)) : [];
  const unused = named ? [...state.files.keys()].filter((path) => !named.has(path) && !/\.toml$/i.test(path)) : [];

  fill(
    node,
    element('h2', { class: 'hidden', tabindex: '-1', id: 'records-title' }, text.records),
    !pending &&
      element(
        'div',
        { class: 'band ' + tone, id: 'read-band' },
        element('p', { class: 'word' }, word),
        said && element('p', { class: 'said' }, said),
        broken && problemList(state.problems),
        read > 0 &&
          element(
            'p',
            { class: 'next' },
            button(text.toProperties, () => show('properties'), { class: 'action', id: 'to-properties' }),
            button(text.toLaws, () => show('laws'), { class: 'action main', id: 'to-laws' }),
            unreadable.length > 0 &&
              button(text.leaveOutAll, () => {
                for (const { device } of [...unreadable].reverse()) leftOut(device.place);
                edit(unreadable.reduceRight((lot, { device }) => withoutTable(lot, device.number), state.lot));
                focusTitle();
              }, { class: 'action quiet', id: 'leave-out' }),
          ),
      ),
    element(
      'div',
      { class: 'drop small', id: 'drop-more' },
      element('span', {}, text.dropMore),
      button(text.chooseFiles, pick, { class: 'action' }),
      button(text.chooseFolder, pickFolder, { class: 'action' }),
      button(text.startOver, startOver, { class: 'action quiet', id: 'start-over' }),
    ),
    noteList(),
    missing.length > 0 && element('p', { class: 'hint care' }, visible(text.missing(missing))),
    lotTables().tables && all.length > 0 && testsSwitch(ofTests),
    hasConditions() && [testsTable(ofTests), element('section', { class: 'form', 'aria-label': text.tests }, conditionsForm(ofTests))],
    all.length > 0 &&
      element(
        'div',
        { class: 'scroll wide' },
        element(
          'table',
          { id: 'devices' },
          element('caption', { class: 'hidden' }, text.devices),
          element(
            'thead',
            {},
            element(
              'tr',
              {},
              [
                [text.device, ''],
                [text.samples, '', 'number'],
                [text.amplitude, 'mm', 'number'],
                [text.stiffness, 'kN/mm', 'number'],
                [text.dampingShort, '%', 'number'],
                [text.remarks, ''],
              ].map(([title, unit, className]) => element('th', { scope: 'col', class: className }, title, unit && element('small', {}, unit))),
              element('td', { class: 'act' }),
            ),
          ),
          element('tbody', {}, all.map((one) => rowsOf(one, edit, redraw))),
        ),
      ),
    unused.length > 0 && element('p', { class: 'hint' }, visible(text.notNamed(unused)) + ' ', button(text.addThem, () => addAgain(unused), { class: 'action', id: 'add-them' })),
    state.lot !== null && element('section', { class: 'form lot-form', 'aria-label': text.lot }, lotForm(edit)),
  );
  if (!lotTables().tables) place('lot-file')?.setAttribute('open', '');
}
