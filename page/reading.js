// Shows how the program read the file of a device: the first samples of each column that is used, what is a guess, and
// a sketch of the loop. Beside each guess stands a button that leads to the field which changes it.

import { button, element, visible } from './dom.js';
import { svg } from '../src/isolaw/render/page/script/element.js';
import { DASH, decoded, fixed, isNumber, trimmed } from '../src/isolaw/render/page/script/text.js';
import { asText, fileOf } from './engine_use.js';
import { state } from './state.js';
import { text } from './text.js';

export const CHANNELS = ['time', 'disp', 'force', 'load'];
const KEYS = { time: 'time_s', disp: 'disp_mm', force: 'force_kN', load: 'load_kN' };
const UNITS = { time: 's', disp: 'mm', force: 'kN', load: 'kN' };

const decisionsOf = (found, kind) => (found.decisions ?? []).filter((one) => one.kind === kind);

export const hasValues = (found) => Boolean(found?.values?.disp_mm);

// Returns whether the file of a device has no time, even if the lot file states a time step in its place.
export const lacksTime = (found) => hasValues(found) && !found.columns?.time && !decisionsOf(found, 'time-scale').some(({ option }) => option !== '--dt');

// Returns what the user should look at in a channel, as [{kind, words, field}]. `kind` is 'guess' if the program
// guessed the column, and 'set' if the lot file states something that the record does not state or states otherwise.
// `field` is the end of the id of the field in which the user can change it.
function marksOf(channel, found) {
  const marks = [];
  const { column_by: by, stated_unit: stated } = decisionsOf(found, 'column-taken').find((one) => one.channel === channel) ?? {};
  if (by && by !== 'name') marks.push({ kind: by === 'option' ? 'set' : 'guess', words: text.columnBy[by], field: 'columns-' + channel });
  if (by && stated !== found.units?.[channel]) marks.push({ kind: 'set', words: stated ? text.unitOtherwise(stated) : text.unitSet, field: 'units-' + channel });
  if (channel === 'time' && lacksTime(found)) marks.push({ kind: 'set', words: text.stepSet, field: 'dt' });
  if (channel === 'force' && decisionsOf(found, 'force-flipped').length > 0) marks.push({ kind: 'set', words: text.signReversed, field: 'flip-force' });
  return marks;
}

export const guessesOf = (found) => (hasValues(found) ? CHANNELS.flatMap((channel) => marksOf(channel, found).filter(({ kind }) => kind === 'guess')) : []);

// Returns whether the user should look at how a device was read: it has a guess, or a time step is missing.
export const isDoubtful = (found) => guessesOf(found).length > 0 || (lacksTime(found) && !found.values.time_s);

// Returns the name of the column that was taken for a channel, with its unit unless the name ends with the unit.
export function columnAsRead(found, channel) {
  const name = String(found.columns[channel]);
  const unit = found.units?.[channel];
  const told = unit && new RegExp('[[(_ ]' + unit.replace(/[^\w]/g, '') + '[\\])]?$').test(name);
  return text.fromColumn(name, told ? '' : unit);
}

// Writes the values of a column with as many decimals as they need, at most five digits.
function column(values) {
  const largest = Math.max(...values.map(Math.abs));
  const most = largest > 0 ? Math.min(6, Math.max(0, 5 - Math.ceil(Math.log10(largest)))) : 0;
  const decimals = Math.max(...values.map((value) => (Number(value.toFixed(most)).toString().split('.')[1] ?? '').length));
  return values.map((value) => fixed(value, decimals));
}

// The curves are in the data of inspection.html. They are read from it again only if the inspection has changed.
let curvesOf = null,
  curves = [];
function curveOf(found) {
  const page = fileOf(state.inspectionFiles, 'inspection.html');
  if (page !== curvesOf) {
    curvesOf = page;
    const [, json] = /<script type="application\/json" id="isolaw-data">([\s\S]*?)<\/script>/.exec(page ? asText(page) : '') ?? [];
    curves = json ? JSON.parse(json).devices.map(({ raw }) => raw) : [];
  }
  return curves[state.inspection.devices.indexOf(found)];
}

const WIDTH = 132,
  HEIGHT = 96,
  EDGE = 4;

// Draws force over displacement, with thin lines through zero.
function sketch(raw, name) {
  if (!raw?.disp_mm || !raw.force_kN) return null;
  const scale = (values, size, up) => {
    const [least, largest] = [Math.min(0, ...values), Math.max(0, ...values)];
    const at = (value) => EDGE + (size - 2 * EDGE) * (largest > least ? (up ? largest - value : value - least) / (largest - least) : 0.5);
    return { zero: at(0).toFixed(1), values: values.map((value) => at(value).toFixed(1)) };
  };
  const x = scale(decoded(raw.disp_mm), WIDTH, false),
    y = scale(decoded(raw.force_kN), HEIGHT, true);
  return svg(
    'svg',
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': text.loopOf(name) },
    svg('path', { class: 'zero', d: `M0 ${y.zero}H${WIDTH}M${x.zero} 0V${HEIGHT}` }),
    svg('path', { class: 'loop', d: 'M' + x.values.map((one, i) => one + ' ' + y.values[i]).join('L') }),
  );
}

// Makes the warning that stands beside the columns of a file without time. It says what depends on time, and its button
// leads to the field for the time step.
function timeWarning(found, name, change) {
  if (!lacksTime(found)) return null;
  const step = found.values.time_s && found.values.time_s.first[1] - found.values.time_s.first[0];
  const laws = state.laws.filter(({ timed }) => timed).map(({ name }) => name);
  return element(
    'div',
    { class: 'no-time' + (step ? '' : ' band care') },
    element('p', {}, element('b', {}, text.noTime + ' '), step ? text.stepEntered(trimmed(step, 4)) : text.noStep),
    element('p', {}, text.timeMatters(laws)),
    !step && button(text.enterStep, () => change('dt'), { class: 'action main', 'aria-label': text.enterStep + ': ' + name }),
  );
}

// `device` and `found` are the device in the lot file and in inspection.json. `change` takes the end of the id of a
// field and leads to this field.
export function readingOf(device, found, change) {
  const name = visible(device.name);
  const channels = CHANNELS.filter((channel) => found.values[KEYS[channel]]);
  const columns = channels.map((channel) => column(found.values[KEYS[channel]].first));
  const range = ({ least, largest }) => (isNumber(least) && isNumber(largest) ? trimmed(least, 4) + ' ' + text.to + ' ' + trimmed(largest, 4) : DASH);
  const head = (channel) =>
    element(
      'th',
      { scope: 'col' },
      element('b', {}, text.channel[channel]),
      ' ' + UNITS[channel],
      element('small', {}, found.columns?.[channel] ? visible(columnAsRead(found, channel)) : lacksTime(found) ? text.notInFile : text.fromHeader),
      marksOf(channel, found).map(({ kind, words, field }) =>
        element('small', { class: 'doubted' }, element('b', { class: kind }, text.marks[kind]), ' ' + words + ' ', button(text.changeIt, () => change(field), { class: 'link', 'aria-label': text.changeIt + ': ' + text.channel[channel] + ', ' + words + ' (' + name + ')' })),
      ),
    );
  const loop = sketch(curveOf(found), name);
  return element(
    'div',
    { class: 'reading' },
    element(
      'div',
      { class: 'values' },
      element(
        'table',
        {},
        element('caption', { class: 'hidden' }, text.valuesOf(name)),
        element('thead', {}, element('tr', {}, element('th', { scope: 'col' }, text.sample), channels.map(head))),
        element(
          'tbody',
          {},
          columns[0].map((_, row) => element('tr', {}, element('th', { scope: 'row' }, String(row + 1)), columns.map((values) => element('td', { class: 'number' }, values[row])))),
          element('tr', { class: 'range' }, element('th', { scope: 'row' }, text.range), channels.map((channel) => element('td', { class: 'number' }, range(found.values[KEYS[channel]])))),
        ),
      ),
    ),
    loop && element('figure', { class: 'sketch' }, loop, element('figcaption', {}, text.loop)),
    timeWarning(found, name, change),
  );
}
