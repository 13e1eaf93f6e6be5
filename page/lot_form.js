// The form for the whole lot, and a text field with the lot file. Both edit the lot file.

import { button, element, place } from './dom.js';
import { choiceField, fieldset, textField } from './fields.js';
import { lotDevices, lotTables } from './lot.js';
import { state } from './state.js';
import { text } from './text.js';
import { settingsOf, withKey, withSetting } from './toml.js';

// `edit` takes the new text of the lot file.
export function lotForm(edit) {
  const { tables, line } = lotTables();
  const parts = [];
  if (tables) {
    const top = tables[0].keys;
    const acceptance = tables.find(({ path }) => path === 'acceptance')?.keys ?? new Map();
    const setting = (path, key) => (value) => edit(withSetting(state.lot, path, key, value));
    const devices = lotDevices();
    const shared = (key) => {
      const values = new Set(devices.map(({ table }) => table.keys.get(key)?.value));
      return values.size === 1 ? [...values][0] : undefined;
    };
    const differs = (key) => new Set(devices.map(({ table }) => table.keys.get(key)?.value)).size > 1;
    const forAll = (key, label) =>
      textField('all-' + key, [label, differs(key) ? text.differ : text.forAll], shared(key), (value) => edit(devices.reduceRight((lot, { number }) => withKey(lot, number, key, value), state.lot)), { number: true });
    parts.push(
      fieldset(
        text.lot,
        textField('lot-title', [text.lotTitle, ''], top.get('title')?.value, setting('', 'title')),
        forAll('rubber-thickness-mm', text.rubberAll[0]),
        forAll('rubber-area-mm2', text.rubberAll[1]),
      ),
    );

    const { values: design, write } = settingsOf(tables, 'acceptance', 'design');
    const designField = ([key, label]) => textField('design-' + key, [label, ''], design[key], (value) => edit(write(state.lot, key, value)), { number: true });
    const files = [...state.files.keys()].filter((path) => /\.toml$/i.test(path)).map((path) => [path, path]);
    parts.push(
      fieldset(
        text.rulesOf,
        choiceField('rules', [text.rules, ''], [['', text.noRules], ...state.rules.map(({ id, title, verified }) => [id, id + ': ' + title + (verified ? '' : text.notVerified)]), ...files], acceptance.get('rules')?.value, setting('acceptance', 'rules')),
        textField('lot-size', [text.lotSize, ''], acceptance.get('lot-size')?.value, setting('acceptance', 'lot-size'), { whole: true }),
      ),
      fieldset(text.design, Object.entries(text.designs).map(designField)),
    );
  }
  const rows = Math.min(28, state.lot.split('\n').length + 1);
  parts.push(
    element(
      'details',
      { class: 'rarely', id: 'lot-file' },
      element('summary', {}, text.lotFile),
      element('label', { for: 'lot-text', class: 'hidden' }, text.lotFile),
      element('p', { class: 'fine', id: 'lot-text-why' }, text.lotFileWhy),
      line > 0 && element('p', { class: 'care' }, text.lotFileLine(line)),
      element('textarea', { id: 'lot-text', rows, spellcheck: 'false', 'aria-describedby': 'lot-text-why', change: ({ currentTarget }) => edit(currentTarget.value) }, state.lot),
      button(text.done, () => edit(place('lot-text').value), { class: 'action' }),
    ),
  );
  return parts;
}
