import { choose, chooseDevice, chosen, onChoice } from './choice.js';
import { chooser } from './controls.js';
import { laws } from './report.js';

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
