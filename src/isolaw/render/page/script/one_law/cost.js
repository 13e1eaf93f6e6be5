import { element } from '../dom.js';
import { lawName } from '../laws.js';
import { lotLaws } from '../report.js';
import { table } from '../tables.js';
import { DASH, THIN, fixed, isNumber, short } from '../text.js';

export const lotLawsFigure = {
  id: 'lot-laws',
  title: 'What one law for all devices costs',
  wanted: () => lotLaws.length > 0,
  caption: lotLawsCaption,
  csv: lotLawsData,
  build: lotLawsTable,
};

function lotLawsCaption() {
  const best = lotLaws
    .filter((law) => isNumber(law.loo_objective))
    .sort((a, b) => a.loo_objective - b.loo_objective)[0];
  return (
    'OF of each device\u2019s own law, of the one law with the least mean over the lot, and of the law of all other devices on the one left out. Least worst: the law that is least bad for its worst device; where the descents are global, no law gets below the bound.' +
    (best
      ? ' For a device that was not tested, ' +
        best.id + ' misses least: ' + fixed(best.loo_objective, 4) +
        ' on average, against ' + fixed(best.objective_converged, 4) + ' of each device\u2019s own law.'
      : '')
  );
}

function lotLawsTable() {
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'Own law', unit: 'mean', number: true },
    { title: 'Lot\u2019s law', unit: 'mean', number: true },
    { title: 'Lot\u2019s law', unit: 'worst', number: true },
    { title: 'Least worst', unit: 'bound', number: true },
    { title: 'Left out', unit: 'mean', number: true },
    { title: 'Left out', unit: 'worst', number: true },
    { title: 'β', unit: 'of own laws', number: true },
    { title: 'Runs at the least OF', number: true },
  ];
  const below = (value, text) =>
    element('td', { class: 'number' }, value, text ? element('small', { title: text }, short(text, 16)) : null);
  const rows = lotLaws.map((law) => ({
    cells: [
      lawName(law),
      fixed(law.objective_converged, 4),
      fixed(law.lot.mean_objective, 4),
      below(fixed(law.lot.worst_objective, 4), law.lot.worst_device),
      below(fixed(law.lot.least_worst_objective, 4), fixed(law.lot.least_worst_bound, 4)),
      fixed(law.loo_objective, 4),
      below(fixed(law.loo_worst, 4), law.loo_worst_device),
      fixed(law.beta_converged, 3),
      element(
        'td',
        { class: 'number' },
        isNumber(law.success_share) ? fixed(100 * law.success_share, 0) + THIN + '%' : DASH,
        law.success_reference ? element('small', {}, law.success_reference) : null,
      ),
    ],
  }));
  return table(columns, rows, 'One law for all devices');
}

function lotLawsData() {
  return {
    columns: [
      'law', 'own least OF [-]', "mean OF of the lot's law [-]", "worst OF of the lot's law [-]", 'worst device',
      'least worst OF [-]', 'bound of it [-]', 'mean OF left out [-]', 'worst OF left out [-]', 'worst device left out',
      'beta of the least objectives [-]', 'runs at the least OF [%]', 'least OF of',
    ],
    rows: lotLaws.map((law) => [
      law.id, law.objective_converged, law.lot.mean_objective, law.lot.worst_objective, law.lot.worst_device,
      law.lot.least_worst_objective, law.lot.least_worst_bound, law.loo_objective, law.loo_worst, law.loo_worst_device,
      law.beta_converged, isNumber(law.success_share) ? 100 * law.success_share : null, law.success_reference,
    ]),
  };
}
