import { element } from './dom.js';

// A drop-down list of `options`, [value, text]. `follow` is called with the chosen value.
export function chooser(id, title, options, current, follow) {
  const option = ([value, text]) => element('option', { value, selected: value === current }, text);
  const select = element('select', { id }, ...options.map(option));
  select.addEventListener('change', () => follow(select.value));
  return element('label', {}, title, select);
}
