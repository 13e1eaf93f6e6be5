// Controls that several sections have.

import { choose, chooseDevice, chosen, onChoice } from './choice.js';
import { element } from './dom.js';
import { laws } from './report.js';

export function deviceChooser(id, among, key) {
  const select = element(
    'select',
    { id },
    ...among.map((device) =>
      element('option', { value: device.index, selected: device.index === chosen[key] }, device.name),
    ),
  );
  select.addEventListener('change', () => chooseDevice(Number(select.value)));
  onChoice(() => (select.value = chosen[key]));
  return element('label', {}, 'Device', select);
}

export function lawChooser(key, among, changes = () => ({})) {
  const select = element(
    'select',
    { id: key },
    ...among.map((law) => element('option', { value: law.index, selected: law.index === chosen[key] }, law.id)),
  );
  select.addEventListener('change', () => {
    const law = laws[Number(select.value)];
    choose({ [key]: law.index, ...changes(law) });
  });
  return element('label', {}, 'Law', select);
}
