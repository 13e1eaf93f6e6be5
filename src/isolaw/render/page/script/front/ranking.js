import { element } from '../dom.js';
import { roleTone } from '../icons.js';
import { lawName } from '../laws.js';
import { laws, lawsByObjective, report, resultColumns } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, fixed, isNumber, objectiveText, percentText } from '../text.js';

export const rankingFigure = {
  id: 'ranking',
  title: 'Ranking',
  caption: () =>
    'Sorted by the mean OF. OF: mean absolute error of the force divided by the standard deviation of the measured force, over devices and runs. ' +
    'β: how far the parameters of the devices lie from their mean over the lot. Errors of stiffness and energy: best fit against the record, mean magnitude over devices.' +
    (laws.some((law) => isNumber(law.success_share))
      ? ' Found: runs that ended within ' +
        percentText(report.thresholds.found_within) +
        ' of the least objective of the campaign. If few did, the mean reflects the search more than the law.'
      : ''),
  csv: rankingData,
  build: rankingTable,
};

const ordered = lawsByObjective.concat(laws.filter((law) => law.objective.mean === null));

function rankingData() {
  const ofLaw = resultColumns('laws', ['id', 'objective', 'beta', 'on_front', 'success_share']);
  const errors = resultColumns('fits', ['K_eff_error_percent', 'energy_error_percent']);
  return {
    // The errors of fits have signs, which could cancel. The error of a law is therefore the mean of their magnitudes
    // over the devices.
    columns: [...ofLaw.columns, ...errors.columns.map((column) => 'mean magnitude of ' + column)],
    rows: lawsByObjective.map((law) => [...ofLaw.cells(law), ...errors.cells(law)]),
  };
}

function rankingTable() {
  const searched = laws.some((law) => isNumber(law.success_share));
  const roles = new Map(report.findings.verdicts.map((verdict) => [verdict.law, verdict.role]));
  const found = (law) => (isNumber(law.success_share) ? fixed(100 * law.success_share, 0) : DASH);
  const verdict = (role) => element('span', { class: roleTone(role) }, role);
  const columns = [
    { title: 'Law', pinned: true, tight: true, cell: lawName },
    { title: 'mean OF ± std', unit: '-', number: true, cell: (law) => objectiveText(law.objective) },
    { title: 'best OF', unit: '-', number: true, cell: (law) => fixed(law.objective.best, 4) },
    { title: 'β', unit: '-', number: true, cell: (law) => fixed(law.beta, 3) },
    { title: 'Accuracy against robustness', cell: (law) => verdict(roles.get(law.index)) },
    { title: 'stiffness error', unit: '%', number: true, cell: (law) => fixed(law.K_eff_error_percent, 1) },
    { title: 'energy error', unit: '%', number: true, cell: (law) => fixed(law.energy_error_percent, 1) },
    ...(searched ? [{ title: 'found', unit: '% of runs', number: true, cell: found }] : []),
    { title: 'parameters', unit: 'calibrated', number: true, cell: (law) => String(law.parameters.filter((p) => p.free).length || DASH) },
    { title: 'Description', cell: (law) => element('td', { class: 'note text' }, law.title) },
  ];
  return tableOf(columns, ordered, 'Ranking of the laws');
}
