// Controls that several sections have.

import { choose, chooseDevice, chosen, onChoice } from './choice.js';
import { element } from './dom.js';
import { laws } from './report.js';

// A choice of [value, text]; `follow` is called with what is chosen.
export function chooser(id, title, options, current, follow) {
  const option = ([value, text]) => element('option', { value, selected: value === current }, text);
  const select = element('select', { id }, ...options.map(option));
  select.addEventListener('change', () => follow(select.value));
  return element('label', {}, title, select);
}

export function deviceChooser(id, among, key) {
  const options = among.map((device) => [device.index, device.name]);
  const label = chooser(id, 'Device', options, chosen[key], (index) => chooseDevice(Number(index)));
  onChoice(() => (label.lastChild.value = chosen[key]));
  return label;
}

export const lawChooser = (key, among, changes = () => ({})) =>
  chooser(key, 'Law', among.map((law) => [law.index, law.name]), chosen[key], (index) =>
    choose({ [key]: Number(index), ...changes(laws[index]) }),
  );
