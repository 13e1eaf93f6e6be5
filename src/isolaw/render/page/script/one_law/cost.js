import { element } from '../dom.js';
import { lawName } from '../laws.js';
import { lotLaws, resultColumns } from '../report.js';
import { tableOf } from '../tables.js';
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
    'Own law: OF of a law fitted to each device. Lot\u2019s law: of the one law with the smallest mean OF. Left out: of a law fitted to all other devices. Least worst: of the law that fits its worst device best; if the descents are global, no law gets below the bound.' +
    (best
      ? ' For a device that was not tested, ' +
        best.name + ' has the smallest OF: ' + fixed(best.loo_objective, 4) +
        ' on average, against ' + fixed(best.objective_converged, 4) + ' with each device\u2019s own law.'
      : '')
  );
}

function lotLawsTable() {
  const below = (value, text) =>
    element('td', { class: 'number' }, value, text ? element('small', { title: text }, short(text, 16)) : null);
  const found = (law) =>
    element(
      'td',
      { class: 'number' },
      isNumber(law.success_share) ? fixed(100 * law.success_share, 0) + THIN + '%' : DASH,
      law.success_reference ? element('small', {}, law.success_reference) : null,
    );
  const columns = [
    { title: 'Law', pinned: true, tight: true, cell: lawName },
    { title: 'Own law', unit: 'mean', number: true, cell: (law) => fixed(law.objective_converged, 4) },
    { title: 'Lot\u2019s law', unit: 'mean', number: true, cell: ({ lot }) => fixed(lot.mean_objective, 4) },
    { title: 'Lot\u2019s law', unit: 'worst', number: true, cell: ({ lot }) => below(fixed(lot.worst_objective, 4), lot.worst_device) },
    { title: 'Least worst', unit: 'bound', number: true, cell: ({ lot }) => below(fixed(lot.least_worst_objective, 4), fixed(lot.least_worst_bound, 4)) },
    { title: 'Left out', unit: 'mean', number: true, cell: (law) => fixed(law.loo_objective, 4) },
    { title: 'Left out', unit: 'worst', number: true, cell: (law) => below(fixed(law.loo_worst, 4), law.loo_worst_device) },
    { title: 'β', unit: 'of own laws', number: true, cell: (law) => fixed(law.beta_converged, 3) },
    { title: 'Runs at the least OF', number: true, cell: found },
  ];
  return tableOf(columns, lotLaws, 'One law for all devices');
}

function lotLawsData() {
  const own = resultColumns('laws', ['id', 'objective_converged']);
  const lot = resultColumns('lot_laws');
  const others = resultColumns('laws', [
    'loo_objective', 'loo_worst', 'loo_worst_device', 'beta_converged', 'success_share', 'success_reference',
  ]);
  return {
    columns: [...own.columns, ...lot.columns, ...others.columns],
    rows: lotLaws.map((law) => [...own.cells(law), ...lot.cells(law.lot), ...others.cells(law)]),
  };
}
