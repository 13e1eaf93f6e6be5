// The device and law that a report shows when it opens, and the controls with which its reader chooses others. All
// sections show the same device and the same law. A section that cannot show the chosen device or law keeps the one
// that it showed before. The address of the page keeps the choice, so that a link shows it again.

import { choose, chooser, chosen, onChoice } from './choice.js';
import {
  devices, drawable, examinedLaws, firstExamined, laws, lotLaws, predictedByFit, ranking, report, tested,
} from './report.js';
import { firstLaw } from './recommendation.js';
import { UNITS, isOtherThanReported } from './units.js';
import { FIRST_VIEW } from './views.js';

const shownFirst = (among) => among.find((device) => device.index === report.typical_device) ?? among[0];

Object.assign(chosen, {
  device: shownFirst(drawable)?.index ?? null,
  tested:
    (tested.find(({ verdict }) => verdict === 'fail') ?? shownFirst(tested.filter((device) => device.blocks.length > 0)) ?? tested[0])?.index ??
    null,
  block: 'all',
  laws: new Set(), // the laws whose loops are drawn over the measured one
  grouping: 'law',
  view: FIRST_VIEW,
  law: ranking[0]?.index ?? null, // the law in the first section and in the section on parameters
  examined: examinedLaws[0]?.index ?? null, // the law in the section on determination
  parameter: firstExamined(examinedLaws[0]), // index of the parameter shown in the section on determination
  lotLaw: lotLaws[0]?.index ?? null,
  predicted: predictedByFit[1]?.index ?? null, // the law drawn beside the one that predicts best
  order: { key: 'best OF\n-', down: false }, // how the table of laws on one device is sorted
});
if (firstLaw) Object.assign(chosen, changesFor(firstLaw));

function changesFor(law) {
  const changes = { law: law.index, laws: new Set([law.index]) };
  if (examinedLaws.includes(law)) Object.assign(changes, { examined: law.index, parameter: firstExamined(law) });
  if (lotLaws.includes(law)) changes.lotLaw = law.index;
  if (predictedByFit.indexOf(law) > 0) changes.predicted = law.index;
  return changes;
}

export const chooseLaw = (index) => choose(changesFor(laws[index]));

export function chooseDevice(index, changes = {}) {
  if (drawable.some((device) => device.index === index)) changes.device = index;
  if (tested.some((device) => device.index === index)) {
    changes.tested = index;
    if (!devices[index].blocks.some((block) => block.number === chosen.block)) changes.block = 'all';
  }
  choose(changes);
}

const options = (among) => among.map(({ index, name }) => [index, name]);
export const deviceChooser = (id, among, key) => chooser(id, 'Device', options(among), key, (index) => chooseDevice(Number(index)));
export const lawChooser = (key, among, { id = key, title = 'Law' } = {}) =>
  chooser(id, title, options(among), key, (index) => chooseLaw(Number(index)));

// The address ends with "#SECTION?law=ID&device=NAME".
export function readAddress() {
  const asked = new URLSearchParams(location.hash.split('?')[1] ?? '');
  const law = laws.find(({ id }) => id === asked.get('law'));
  const device = devices.find(({ name }) => name === asked.get('device'));
  if (law) chooseLaw(law.index);
  if (device) chooseDevice(device.index);
}

let isChosen = isOtherThanReported; // true once a law, a device or units were chosen
export function writeAddress() {
  if (!isChosen) return;
  const asked = new URLSearchParams();
  if (laws[chosen.law]) asked.set('law', laws[chosen.law].id);
  const device = devices[chosen.device ?? chosen.tested];
  if (device) asked.set('device', device.name);
  if (isOtherThanReported) asked.set('units', UNITS);
  history.replaceState(null, '', (location.hash.split('?')[0] || '#decision') + '?' + asked);
}

onChoice((changes) => {
  if (!['law', 'device', 'tested'].some((key) => key in changes)) return;
  isChosen = true;
  writeAddress();
});
