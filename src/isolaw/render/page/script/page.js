// cmake/join_modules.cmake joins these modules into one script. Each folder is a section and each file in it a figure.
// Text from the input enters the document only through textContent, and plots only through plain().

import { accuracySection } from './accuracy/section.js';
import { certificateSection } from './certificate/section.js';
import { onChoice } from './choice.js';
import { decisionSection } from './decision/section.js';
import { determinationSection } from './determination/section.js';
import { devicesSection } from './devices/section.js';
import { element } from './dom.js';
import { loopsSection } from './loops/section.js';
import { oneLawSection } from './one_law/section.js';
import { parametersSection } from './parameters/section.js';
import { predictionSection } from './prediction/section.js';
import { propertiesSection } from './properties/section.js';
import { provenanceSection } from './provenance/section.js';
import { publishedSection } from './published/section.js';
import { devices, inspection, laws, report, usable } from './report.js';
import { followWindow, showSections } from './shell.js';
import { count } from './text.js';
import { verdictSection } from './verdict/section.js';
import { WORDS } from './verdicts.js';
const SECTIONS = [
  verdictSection, decisionSection, accuracySection, loopsSection, parametersSection, determinationSection, oneLawSection,
  predictionSection, publishedSection, propertiesSection, devicesSection, certificateSection, provenanceSection,
];

function buildPage() {
  const refused = devices.length - usable.length;
  document.getElementById('title').textContent = report.title || 'Isolation devices';
  if (inspection) document.getElementById('kind').textContent = 'Test records';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    ...(inspection ? [] : [count(laws.length, 'law'), 'seed ' + report.seed]),
    'isolaw ' + report.isolaw,
  ].join(' \u00b7 ');
  const { word } = report.result;
  if (word && !inspection)
    document
      .getElementById('facts')
      .append(' \u00b7 ', element('a', { class: 'word ' + WORDS[word].tone, href: '#devices', title: report.result.sentence }, word));
  document.getElementById('colophon').append(
    'Made by isolaw ' + report.isolaw +
      (inspection ? ' from the test records' : ' from the campaign\u2019s store') + '. This file needs no network',
    element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'),
    '.',
  );

  showSections(SECTIONS.filter((section) => !(section.laws && inspection)), {
    onChoice,
    opened: (section, node) => {
      if (section.id === 'decision' && report.missing_runs + report.missing_analyses > 0)
        node.append(element('p', { class: 'warnings' }, element('b', {}, incomplete())));
    },
  });
}

// While runs are missing, the recommendation may still change.
const incomplete = () =>
  'Not complete: ' +
  [[report.missing_runs, 'run', 'runs'], [report.missing_analyses, 'analysis', 'analyses']]
    .filter(([missing]) => missing > 0)
    .map(([missing, one, several]) => missing + ' ' + (missing === 1 ? one : several))
    .join(' and ') +
  ' missing. The results may change. Repeat the last calibrate command to continue the campaign.';

buildPage();
followWindow({
  beforePrint: () => {
    for (const details of document.querySelectorAll('details.law')) details.print();
    for (const details of document.querySelectorAll('.warnings details, .steps.warned, #figure-published-laws details')) details.open = true;
  },
  afterPrint: () => {
    for (const details of document.querySelectorAll('details.law')) details.restore();
  },
});
