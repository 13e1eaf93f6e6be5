// The device and laws that a report shows when it opens, and the controls with which its reader chooses others.

import { choose, chooser, chosen } from './choice.js';
import {
  devices, drawable, examinedLaws, firstExamined, laws, lotLaws, predictedByFit, ranking, report, tested,
} from './report.js';
import { FIRST, recommended } from './purposes.js';
import { FIRST_VIEW } from './views.js';

const shownFirst = (among) => among.find((device) => device.index === report.typical_device) ?? among[0];

Object.assign(chosen, {
  device: shownFirst(drawable)?.index ?? null,
  tested:
    (tested.find(({ verdict }) => verdict === 'fail') ?? shownFirst(tested.filter((device) => device.blocks.length > 0)) ?? tested[0])?.index ??
    null,
  block: 'all',
  laws: new Set(recommended.map((law) => law.index)),
  grouping: 'law',
  purpose: FIRST,
  view: FIRST_VIEW,
  examined: examinedLaws[0]?.index ?? null, // the law in the section on determination
  parameter: firstExamined(examinedLaws[0]), // index of the parameter shown with that law
  lotLaw: lotLaws[0]?.index ?? null,
  predicted: predictedByFit[1]?.index ?? null, // the law that predicts second best, since the best is shown anyway
  law: ranking[0]?.index ?? null, // the law in the section on parameters
  order: { key: 'best OF\n-', down: false }, // how the table of laws on one device is sorted
});

// All sections show the same device. A section that cannot show it keeps its previous device.
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
export const lawChooser = (key, among, { id = key, title = 'Law', changes = () => ({}) } = {}) =>
  chooser(id, title, options(among), key, (index) => choose({ [key]: Number(index), ...changes(laws[index]) }));
