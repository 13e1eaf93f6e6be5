// The reader's choices on a page, and controls for them. Each figure names the choices that change it and is drawn
// again when one of them changes.

import { button, element } from './dom.js';
import { colourOf, isAgain } from './plotting.js';

export const chosen = {};
const followers = [];
export const onChoice = (follow) => followers.push(follow);

export function choose(changes) {
  Object.assign(chosen, changes);
  for (const follow of followers) follow(changes);
}

// Makes a drop-down list for the choice `key`. `options` is a list of [value, text]. When the reader chooses a value,
// `follow` is called with it.
export function chooser(id, title, options, key, follow = (value) => choose({ [key]: value })) {
  const option = ([value, text]) => element('option', { value, selected: value === chosen[key] }, text);
  const select = element('select', { id, change: () => follow(select.value) }, options.map(option));
  onChoice(() => (select.value = chosen[key]));
  return element('label', {}, title, select);
}

// Makes a button for each of `options`, which are pairs [value, title]. The button whose value is that of the choice
// `key` looks pressed.
export function choiceButtons(key, options, attributes) {
  const buttons = options.map(([value, title]) => button(title, () => choose({ [key]: value }), { value }));
  const follow = () => {
    for (const one of buttons) one.setAttribute('aria-pressed', String(one.value === chosen[key]));
  };
  onChoice(follow);
  follow();
  return element('div', { class: 'choice', role: 'group', ...attributes }, buttons);
}

// Makes a checkbox for each law in `among`. chosen.laws is the set of the checked laws' indices.
export function lawBoxes(among) {
  const box = ({ index }) => {
    const change = ({ currentTarget }) => {
      currentTarget.checked ? chosen.laws.add(index) : chosen.laws.delete(index);
      choose({ laws: chosen.laws });
    };
    return element('input', { type: 'checkbox', value: index, checked: chosen.laws.has(index), change });
  };
  const key = (law) => element('span', { class: isAgain(law) ? 'key again' : 'key', style: `border-color: var(--${colourOf(law)})` });
  const boxes = among.map((law) => element('label', {}, box(law), key(law), law.name));
  onChoice(() => {
    for (const input of boxes.map((label) => label.querySelector('input'))) input.checked = chosen.laws.has(Number(input.value));
  });
  return element('fieldset', {}, element('legend', {}, 'Laws'), boxes);
}
