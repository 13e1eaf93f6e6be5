// What the reader of a report has chosen.

import { choices } from './choices.js';
import {
  devices, drawable, examinedLaws, firstExamined, lotLaws, predictedByFit, ranking, report, tested,
} from './report.js';
import { FIRST, recommended } from './purposes.js';
import { FIRST_VIEW } from './views.js';

// The device that stands for the lot, where it can be shown.
const shownFirst = (among) => among.find((device) => device.index === report.typical_device) ?? among[0];

const made = choices({
  device: shownFirst(drawable)?.index ?? null,
  tested:
    (tested.find(({ verdict }) => verdict === 'fail') ?? shownFirst(tested.filter((device) => device.blocks.length > 0)) ?? tested[0])?.index ??
    null,
  block: 'all',
  laws: new Set(recommended.map((law) => law.index)),
  grouping: 'law',
  purpose: FIRST, // of the first screen
  view: FIRST_VIEW,
  examined: examinedLaws[0]?.index ?? null, // a law
  parameter: firstExamined(examinedLaws[0]), // its place among the law's
  lotLaw: lotLaws[0]?.index ?? null,
  predicted: predictedByFit[1]?.index ?? null, // beside the law that predicts best
  law: ranking[0]?.index ?? null, // of the parameters
  order: { key: 'best OF\n-', down: false }, // of the laws on a device
});

export const chosen = made.chosen;
export const onChoice = made.onChoice;
export const choose = made.choose;

// One device for the whole page; what cannot be shown of it stays with the device before.
export function chooseDevice(index, changes = {}) {
  if (drawable.some((device) => device.index === index)) changes.device = index;
  if (tested.some((device) => device.index === index)) {
    changes.tested = index;
    if (!devices[index].blocks.some((block) => block.number === chosen.block)) changes.block = 'all';
  }
  choose(changes);
}
