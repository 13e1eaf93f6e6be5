// What the reader has chosen, and what follows it.

import { devices, drawable, examinedLaws, firstExamined, lotLaws, ranking, tested } from './report.js';
import { FIRST } from './purposes.js';
import { FIRST_VIEW } from './views.js';

// A figure names the keys that change it.
export const chosen = {
  device: drawable[0]?.index ?? null,
  tested: tested.find((device) => device.blocks.length > 0)?.index ?? tested[0]?.index ?? null,
  block: 'all',
  laws: new Set(ranking.slice(0, 2).map((law) => law.index)),
  grouping: 'law',
  purpose: FIRST, // of the first screen
  view: FIRST_VIEW,
  examined: examinedLaws[0]?.index ?? null, // a law
  parameter: firstExamined(examinedLaws[0]), // its place among the law's
  lotLaw: lotLaws[0]?.index ?? null,
  law: ranking[0]?.index ?? null, // of the parameters
  order: 'objective', // of the laws on a device
};

// What follows a choice: controls that show the same one, figures that depend on it.
const followers = [];
export const onChoice = (follow) => followers.push(follow);

export function choose(changes) {
  Object.assign(chosen, changes);
  for (const follow of followers) follow(changes);
}

// One device for the whole page; what cannot be shown of it stays with the device before.
export function chooseDevice(index, changes = {}) {
  if (drawable.some((device) => device.index === index)) changes.device = index;
  if (tested.some((device) => device.index === index)) {
    changes.tested = index;
    if (!devices[index].blocks.some((block) => block.number === chosen.block)) changes.block = 'all';
  }
  choose(changes);
}
