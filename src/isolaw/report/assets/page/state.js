// Draws the report from its data block. The files of this folder are one script, in the order CMakeLists.txt gives them;
// to add a figure, add an entry to the section that opens its file.
// Text of the input reaches the document through textContent only, and plots through plain().
'use strict';

const report = JSON.parse(document.getElementById('isolaw-data').textContent);
const devices = report.devices.map((device, index) => ({ ...device, index }));

// What the data block holds as columns, as one object per parameter.
function rowsOf(columns) {
  const names = Object.keys(columns);
  return columns[names[0]].map((_, i) => Object.fromEntries(names.map((name) => [name, columns[name][i]])));
}
const laws = report.laws.map((law, index) => {
  const fits = law.devices.map((fit) => ({
    ...fit,
    parameters: rowsOf(fit.parameters),
    // Null for a parameter that was not examined.
    determination: fit.determination && rowsOf(fit.determination).map((row) => (row.identifiability ? row : null)),
  }));
  return { ...law, index, devices: fits, fitOn: new Map(fits.map((fit) => [fit.device, fit])) };
});
const usable = devices.filter((device) => device.status === 'ok');
const drawable = usable.filter((device) => device.record.drawn > 0); // beside the laws' loops
const tested = devices.filter((device) => device.raw?.samples > 0); // whose raw record can be shown
const inspection = laws.length === 0; // records alone, no identification
const ranking = report.findings.verdicts.map((verdict) => laws[verdict.law]);
const lawsByObjective = laws
  .filter((law) => law.objective.mean !== null)
  .sort((a, b) => a.objective.mean - b.objective.mean);
const examinedLaws = lawsByObjective.filter((law) => law.devices.some((fit) => fit.determination !== null));
const lotLaws = lawsByObjective.filter((law) => law.lot !== null);
const predictedLaws = lawsByObjective.filter((law) => law.predicted_objective !== null);

// Accuracy against robustness, three ways; those that some law has both coordinates of.
const VIEWS = [
  {
    id: 'published',
    title: 'as published',
    robust: (law) => law.beta,
    accurate: (law) => law.objective.mean,
    onFront: (law) => law.on_front,
    whyNot: (law) => law.beta_note,
    axes: ['robustness index β [-], smaller is more robust', 'mean objective OF [-], smaller is more accurate'],
    columns: ['beta [-]', 'mean OF [-]'],
    says: 'lower is more accurate, further left its parameters agree better from device to device.',
  },
  {
    id: 'converged',
    title: 'without the optimiser\u2019s noise',
    robust: (law) => law.beta_converged,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_converged,
    whyNot: (law) => law.beta_converged_note,
    axes: ['β of the least objectives [-]', 'least objective OF [-], mean over devices'],
    columns: ['beta of the least objectives [-]', 'least OF [-]'],
    says: 'as published, but of the least objective of every device instead of the means over runs, and without parameters that most tests do not determine.',
  },
  {
    id: 'left-out',
    title: 'device left out',
    robust: (law) => law.loo_objective,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_loo,
    whyNot: () => '',
    axes: ['OF on a device by the law of all others [-]', 'least objective OF [-], mean over devices'],
    columns: ['OF on devices left out [-]', 'least OF [-]'],
    says: 'lower is more accurate on a tested device, further left better for a device that was not tested: one law, fitted to all others.',
  },
].filter((view) => laws.some((law) => isPlaced(view, law)));
function isPlaced(view, law) {
  return isNumber(view.robust(law)) && isNumber(view.accurate(law));
}
const hasFront = VIEWS.length > 0;

// What the reader has chosen; a figure names the keys that change it.
const chosen = {
  device: drawable[0]?.index ?? null,
  tested: tested.find((device) => device.blocks.length > 0)?.index ?? tested[0]?.index ?? null,
  block: 'all',
  laws: new Set(ranking.slice(0, 2).map((law) => law.index)),
  grouping: 'law',
  view: VIEWS[0]?.id,
  examined: examinedLaws[0]?.index ?? null, // a law
  parameter: 0, // its place among the law's
  lotLaw: lotLaws[0]?.index ?? null,
  law: ranking[0]?.index ?? null, // of the parameters
  order: 'objective', // of the laws on a device
};
chosen.parameter = firstExamined(laws[chosen.examined]);
