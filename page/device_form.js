// Makes the form for one device and the fields that say how its record, or the record of a test, is read. Both edit the
// table of the device or test in the lot file.

import { element, visible } from './dom.js';
import { choiceField, choicesOf, fieldset, flagField, textField } from './fields.js';
import { state } from './state.js';
import { text } from './text.js';

const CHANNELS = ['time', 'disp', 'force', 'load'];
const UNITS = { time: ['s', 'ms', 'min', 'd'], disp: ['mm', 'cm', 'm', 'in', 'ft', 'dm', 'um'], force: ['kN', 'N', 'MN', 'tonf', 'kgf', 'daN', 'kip', 'lbf', 'Mp'] };
UNITS.load = UNITS.force;

// Suggests names of columns: the columns that the program read and, if it did not find a column, the columns that the
// file has.
const columnNames = (found, problems) => [...new Set([...Object.values(found?.columns ?? {}).map(String), ...problems.flatMap(({ names = [] }) => names)])];

// Returns the first lines of a text file, or null if the file is not text.
function linesOf(bytes) {
  const head = bytes.subarray(0, 6000);
  const wide = (head[0] === 0xff && head[1] === 0xfe && 'utf-16le') || (head[0] === 0xfe && head[1] === 0xff && 'utf-16be');
  if (!wide && head.includes(0)) return null;
  let words;
  try {
    // The 6000 bytes of `head` may end within a character, which UTF-8 decoding refuses. So this decodes only whole
    // lines.
    words = new TextDecoder(wide || 'utf-8', { fatal: !wide }).decode(wide ? head : head.subarray(0, head.length === bytes.length ? head.length : head.lastIndexOf(10) + 1));
  } catch {
    words = new TextDecoder('windows-1252').decode(head);
  }
  return words.split(/\r\n|\r|\n/).slice(0, 16).map((line) => visible(line.slice(0, 300)));
}

// `found` is the device's entry in inspection.json, or undefined. `problems` are the program's complaints about the
// device. `write(key, value)` changes a key of the device in the lot file. `writePart(key, channel, value)` changes the
// column, unit or scale of one channel; its key is 'columns', 'units' or 'channel-scale'.
export function deviceForm(device, found, problems, write, writePart) {
  const { id, field, number, value } = fieldsOf(device, write);
  const others = [...state.files.keys()].filter((path) => path !== device.file).map((path) => [path, visible(path)]);
  const facts = fieldset(
    text.groups.who,
    field('name'),
    field('serial'),
    field('lot'),
    field('test-date'),
    number('temperature-C'),
    number('rubber-thickness-mm'),
    number('rubber-area-mm2'),
    typeof value('vertical') === 'object'
      ? null
      : choiceField(id('vertical'), text.form.vertical, [['', text.choices['']], ...others], value('vertical'), (file) => write('vertical', file)),
    number('K_v'),
  );
  return element('div', { class: 'form' }, readingFields(device, found, problems, write, writePart, facts));
}

function fieldsOf(device, write) {
  const id = (key) => device.id + '-' + key;
  const value = (key) => device.table.keys.get(key)?.value;
  const field = (key, options) => textField(id(key), text.form[key], value(key), (typed) => write(key, typed), options);
  const number = (key) => field(key, { number: true });
  const choice = (key) => choiceField(id(key), text.form[key], choicesOf(key), value(key), (chosen) => write(key, chosen));
  return { id, value, field, number, choice };
}

// Returns the fields that say how the record of a device or a test is read. `facts` are further fields, which stand
// among them.
export function readingFields(device, found, problems, write, writePart, facts = null) {
  const { id, value, field, number, choice } = fieldsOf(device, write);
  const { values: columns } = device.valuesOf('columns'),
    { values: units } = device.valuesOf('units'),
    { values: scales } = device.valuesOf('channel-scale');
  const column = (channel) => (typed) => writePart('columns', channel, typed);
  const unit = (channel) => (typed) => writePart('units', channel, typed);
  const scale = (channel) => (typed) => writePart('channel-scale', channel, typed);
  const numeral = (write) => (typed) => write(typed !== null && /^\d+$/.test(typed) ? Number(typed) : typed);
  const suggested = element('datalist', { id: id('names') }, columnNames(found, problems).map((name) => element('option', { value: name })));
  const channels = CHANNELS.map((channel) =>
    element(
      'div',
      { class: 'channel', role: 'group', 'aria-label': text.channel[channel] },
      element('b', {}, text.channel[channel]),
      textField(id('columns-' + channel), text.form.columns, columns[channel], numeral(column(channel)), { list: id('names') }),
      choiceField(id('units-' + channel), text.form.units, [['', text.unitFromFile], ...UNITS[channel].map((one) => [one, one])], units[channel], unit(channel)),
      textField(id('channel-scale-' + channel), text.form['channel-scale'], scales[channel], scale(channel), { number: true }),
    ),
  );
  const bytes = state.files.get(device.file);
  const lines = bytes && linesOf(bytes);
  return [
    fieldset(text.groups.columns, channels, suggested, number('dt'), flagField(id('flip-force'), text.form['flip-force'], value('flip-force'), (on) => write('flip-force', on))),
    bytes &&
      element(
        'details',
        { class: 'look', open: problems.length > 0 },
        element('summary', {}, text.look),
        element('pre', { tabindex: '0' }, lines ? lines.join('\n') : text.lookBinary),
      ),
    (found?.recognised ?? []).length > 0 &&
      element('details', { class: 'look' }, element('summary', {}, text.recognised), element('ul', { class: 'sentences' }, found.recognised.map((one) => element('li', {}, visible(one))))),
    facts,
    element(
      'details',
      { class: 'rarely' },
      element('summary', {}, text.groups.parts),
      element(
        'div',
        { class: 'fields' },
        field('sheet'),
        textField(id('test'), text.form.test, value('test'), numeral((typed) => write('test', typed))),
        field('rows'),
        number('from'),
        number('to'),
        choice('footer'),
        choice('missing'),
        choice('thousands'),
        choice('date-order'),
      ),
    ),
    element(
      'details',
      { class: 'rarely' },
      element('summary', {}, text.groups.rig),
      element('div', { class: 'fields' }, choice('repair'), ['skew-ms', 'rig-friction', 'rig-friction-coefficient', 'moving-mass', 'force-factor'].map(number)),
    ),
  ];
}
