// The page of an isolated building. Each file in building/ is a section; other modules are shared with report.html.

import { assumedSection } from './building/assumed.js';
import { checksSection } from './building/checks.js';
import { enoughSection } from './building/enough.js';
import { historySection } from './building/history.js';
import { lawsSection } from './building/laws.js';
import { planSection } from './building/plan.js';
import { spreadSection } from './building/spread.js';
import { grouped, isDrawn, laws, study } from './building/study.js';
import { varianceSection } from './building/variance.js';
import { verdictSection } from './building/verdict.js';
import { onChoice } from './choice.js';
import { element } from './dom.js';
import { followAddress, followWindow, showSections } from './shell.js';
import { count } from './text.js';
import { UNITS, isOtherThanReported } from './units.js';

const SECTIONS = [
  verdictSection, enoughSection, spreadSection, varianceSection, lawsSection, planSection, historySection, checksSection, assumedSection,
];

document.getElementById('kind').textContent = 'Isolated building';
document.getElementById('title').textContent = study.title || 'Building on devices of a lot';
document.getElementById('facts').textContent = [
  count(study.plan.bearings.length, 'bearing'), count(study.motions.length, 'motion'), count(laws.length, 'law'),
  isDrawn ? grouped(study.draws) + ' draws' : 'no bearing is drawn',
].join(' \u00b7 ');
document.getElementById('colophon').append(
  'Made by isolaw ' + study.isolaw + ' from building.sqlite, seed ' + study.seed + '. This file needs no network',
  element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'),
  '.',
);
followAddress({
  write: () => isOtherThanReported && history.replaceState(null, '', (location.hash.split('?')[0] || '#') + '?units=' + UNITS),
});
showSections(SECTIONS, { onChoice });
followWindow();
