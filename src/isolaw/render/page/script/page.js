// cmake/join_modules.cmake joins these modules into one script. Each folder is a section and each file in it a figure.
// Text from the input enters the document only through textContent, and plots only through plain().

import { objectiveDevicesFigure } from './accuracy/objectives.js';
import { objectiveRelativeFigure, objectiveSpreadFigure } from './accuracy/spread.js';
import { afterPrintingCertificate, certificateSection } from './certificate/section.js';
import { chosen, onChoice } from './choice.js';
import { lawChooser, readAddress, writeAddress } from './choosers.js';
import { conditionsSection } from './conditions/section.js';
import { answerFigure } from './decision/answer.js';
import { deviceLoopsFigure, devicePointsFigure } from './decision/devices.js';
import { lawsFigure } from './decision/laws.js';
import { answerLoopFigure } from './decision/loop.js';
import { determinedFigure } from './determination/determined.js';
import { profileFigure } from './determination/profile.js';
import { tradeOffsFigure } from './determination/trade_offs.js';
import { factorsFigure } from './devices/factors.js';
import { lotFigure } from './devices/lot_table.js';
import { outliersFigure } from './devices/outliers.js';
import { testPropertiesFigure } from './devices/properties.js';
import { ruleSetFigure } from './devices/rule_set.js';
import { lotStabilityFigure } from './devices/stability.js';
import { lotStripsFigure } from './devices/strips.js';
import { verdictTableFigure } from './devices/verdicts.js';
import { element } from './dom.js';
import { frontFigure } from './front/front.js';
import { rankingFigure } from './front/ranking.js';
import { convergedFigure, verdictsFigure } from './front/verdicts.js';
import { loopsSection } from './loops/section.js';
import { lotCorrelationFigure } from './one_law/correlation.js';
import { lotLawsFigure } from './one_law/cost.js';
import { lotDevicesFigure } from './one_law/devices.js';
import { lotOutliersFigure } from './one_law/outliers.js';
import { lotParametersFigure } from './one_law/parameters.js';
import { convergenceFigure } from './parameters/convergence.js';
import { parameterPanelsFigure } from './parameters/panels.js';
import { parameterTablesFigure } from './parameters/tables.js';
import { predictionSection } from './prediction/section.js';
import { assessmentsFigure } from './properties/assessments.js';
import { propertiesSection } from './properties/section.js';
import { provenanceSection } from './provenance/section.js';
import { publishedLawsFigure } from './published/laws.js';
import { publishedVerdictFigure, statementsFigure } from './published/statements.js';
import { devices, inspection, laws, ranking, report, usable } from './report.js';
import { followAddress, followWindow, showSections } from './shell.js';
import { count } from './text.js';
import { verdictFigure } from './verdict/band.js';
import { WORDS } from './verdicts.js';
import { VIEWS } from './views.js';

// The page of an inspection begins with the verdict and with plots of all devices by quantity (lotStripsFigure). A
// single device needs no figures of a lot.
const alone = devices.length === 1;
const ofLot = [lotFigure, ...(inspection ? [] : [lotStripsFigure]), outliersFigure, verdictTableFigure, lotStabilityFigure];
const SECTIONS = [
  { id: 'verdict', title: 'Verdict', figures: inspection ? [verdictFigure, alone ? assessmentsFigure : lotStripsFigure] : [] },
  { id: 'decision', title: 'The decision', short: 'Answer', laws: true, figures: [answerFigure, answerLoopFigure, deviceLoopsFigure, devicePointsFigure, lawsFigure] },
  {
    id: 'front', title: VIEWS.length > 0 ? 'Accuracy against robustness' : 'Ranking', short: VIEWS.length > 0 ? 'Front' : 'Ranking', laws: true,
    figures: [frontFigure, verdictsFigure, rankingFigure, convergedFigure],
  },
  { id: 'objective', title: 'Accuracy', laws: true, figures: [objectiveDevicesFigure, objectiveSpreadFigure, objectiveRelativeFigure] },
  loopsSection,
  {
    id: 'parameters', title: 'Parameters', laws: true, controls: () => (chosen.law === null ? [] : [lawChooser('law', ranking)]),
    figures: [parameterPanelsFigure, convergenceFigure, parameterTablesFigure],
  },
  { id: 'determination', title: 'What the tests determine', short: 'Determined', laws: true, figures: [determinedFigure, profileFigure, tradeOffsFigure] },
  {
    id: 'one-law', title: 'One law for the lot', short: 'One law', laws: true,
    figures: [lotLawsFigure, lotDevicesFigure, lotParametersFigure, lotCorrelationFigure, lotOutliersFigure],
  },
  predictionSection,
  { id: 'published', title: 'The published study', short: 'Published', laws: true, figures: [publishedVerdictFigure, statementsFigure, publishedLawsFigure] },
  conditionsSection,
  propertiesSection,
  {
    id: 'devices', title: 'Lot and devices',
    figures: [...(inspection ? [] : [verdictFigure]), ruleSetFigure, ...(alone ? [] : ofLot), factorsFigure, ...(alone ? [] : [testPropertiesFigure])],
  },
  certificateSection,
  provenanceSection,
];

function buildPage() {
  const refused = devices.length - usable.length;
  document.getElementById('title').textContent = report.title || 'Isolation devices';
  if (inspection) document.getElementById('kind').textContent = 'Test records';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    ...(inspection ? [] : [count(laws.length, 'law'), 'seed ' + report.seed]),
  ].join(' \u00b7 ');
  const { word } = report.result;
  if (word && !inspection)
    document
      .getElementById('facts')
      .append(' \u00b7 rule set: ', element('a', { class: 'word ' + WORDS[word].tone, href: '#devices', title: report.result.sentence }, word));
  document.getElementById('colophon').append(
    'Made by isolaw ' + report.isolaw +
      (inspection ? ' from the test records' : ' from the campaign\u2019s store') + '. This file needs no network',
    element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'),
    '.',
  );

  followAddress({ read: readAddress, write: writeAddress });
  showSections(SECTIONS.filter((section) => !(section.laws && inspection)), {
    onChoice,
    opened: (section, node) => {
      if (section.id === 'decision' && report.missing_runs + report.missing_analyses > 0)
        node.append(element('p', { class: 'warnings' }, element('b', {}, incomplete())));
    },
  });
}

// Returns the notice for a report with missing runs or analyses, whose recommendation may still change.
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
    afterPrintingCertificate();
  },
});
