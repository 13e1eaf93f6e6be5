// Form fields. Each field shows the value of a key of the lot file and writes it back when the user changes it.

import { element } from './dom.js';
import { text } from './text.js';
import { NUMERAL } from './toml.js';

const asNumber = (typed) => {
  const plain = typed.replace(',', '.');
  return NUMERAL.test(plain) ? Number(plain) : typed;
};

const shown = (value) => (value === undefined || value === null ? '' : typeof value === 'object' ? JSON.stringify(value) : String(value));

const labelled = (id, [label, hint], control) =>
  element('div', { class: 'field' }, element('label', { for: id }, label), control, hint && element('small', { id: id + '-hint' }, hint));

// Calls `write` with the new value, or with null if the user emptied the field.
export const textInput = (id, value, write, { number = false, whole = false, ...attributes } = {}) =>
  element('input', {
    id,
    type: 'text',
    value: shown(value),
    inputmode: number ? 'decimal' : whole ? 'numeric' : null,
    ...attributes,
    autocomplete: 'off',
    spellcheck: 'false',
    change: ({ currentTarget }) => {
      const typed = currentTarget.value.trim();
      write(typed === '' ? null : number || whole ? asNumber(typed) : typed);
    },
  });

export const textField = (id, words, value, write, options = {}) =>
  labelled(id, words, textInput(id, value, write, { ...options, 'aria-describedby': words[1] ? id + '-hint' : null }));

// `options` is a list of pairs [value, label].
export function choiceField(id, words, options, value, write) {
  const known = options.some(([one]) => one === shown(value));
  const all = known ? options : [...options, [shown(value), shown(value)]];
  const control = element(
    'select',
    { id, 'aria-describedby': words[1] ? id + '-hint' : null, change: ({ currentTarget }) => write(currentTarget.value === '' ? null : currentTarget.value) },
    all.map(([one, label]) => element('option', { value: one, selected: one === shown(value) }, label)),
  );
  return labelled(id, words, control);
}

export function flagField(id, [label], value, write) {
  const control = element('input', { id, type: 'checkbox', checked: value === true, change: ({ currentTarget }) => write(currentTarget.checked ? true : null) });
  return element('div', { class: 'field flag' }, control, element('label', { for: id }, label));
}

export const fieldset = (title, ...fields) => element('fieldset', {}, element('legend', {}, title), element('div', { class: 'fields' }, fields));

export const choicesOf = (key) => [['', text.choices['']], ...Object.entries(text.choices[key])];
