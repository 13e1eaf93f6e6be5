import { element, onScreen } from '../dom.js';
import { lawName } from '../laws.js';
import { laws, lawsByObjective, report } from '../report.js';
import { table } from '../tables.js';
import { DASH, fixed, isNumber, objectiveText, percentText } from '../text.js';

export const rankingFigure = {
  id: 'ranking',
  title: 'Ranking by mean objective',
  caption: () =>
    'OF: mean absolute error of the force divided by the standard deviation of the measured force, over devices and runs. ' +
    'β: how far the parameters stray from their mean over the lot. Errors of stiffness and energy: mean magnitude over devices, best fit against the record.' +
    onScreen(
      laws.some((law) => isNumber(law.success_share))
        ? ' Found: runs that ended within ' +
            percentText(report.thresholds.found_within) +
            ' of the least objective of the campaign; where they are few, the mean says more of the search than of the law.'
        : '',
    ),
  csv: () => ({
    columns: [
      'law', 'mean OF [-]', 'std OF [-]', 'best OF [-]', 'beta [-]', 'on front', 'K_eff error [%]', 'energy error [%]',
      'runs at the least OF [%]',
    ],
    rows: lawsByObjective.map((law) => [
      law.id, law.objective.mean, law.objective.std, law.objective.best, law.beta, law.on_front ? 'yes' : 'no',
      law.K_eff_error_percent, law.energy_error_percent, isNumber(law.success_share) ? 100 * law.success_share : null,
    ]),
  }),
  build: rankingTable,
};

function rankingTable() {
  const searched = laws.some((law) => isNumber(law.success_share));
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'mean OF ± std', unit: '-', number: true },
    { title: 'best OF', unit: '-', number: true },
    { title: 'β', unit: '-', number: true },
    { title: 'Verdict', tight: true },
    { title: 'stiffness error', unit: '%', number: true },
    { title: 'energy error', unit: '%', number: true },
    ...(searched ? [{ title: 'found', unit: '% of runs', number: true, screen: true }] : []),
    { title: 'parameters', unit: 'calibrated', number: true },
    { title: 'Description', screen: true },
  ];
  const roles = new Map(report.findings.verdicts.map((verdict) => [verdict.law, verdict.role]));
  const rows = [...lawsByObjective, ...laws.filter((law) => law.objective.mean === null)].map((law) => {
    const role = roles.get(law.index);
    const tone = role === 'dominated' ? 'poor' : role === 'not ranked' ? 'note' : 'good';
    return {
      cells: [
        lawName(law),
        objectiveText(law.objective),
        fixed(law.objective.best, 4),
        fixed(law.beta, 3),
        element('span', { class: tone }, role),
        fixed(law.K_eff_error_percent, 1),
        fixed(law.energy_error_percent, 1),
        ...(searched ? [isNumber(law.success_share) ? fixed(100 * law.success_share, 0) : DASH] : []),
        String(law.parameters.filter((p) => p.free).length || DASH),
        element('td', { class: 'note text screen' }, law.title),
      ],
    };
  });
  return table(columns, rows, 'Ranking of the laws');
}
