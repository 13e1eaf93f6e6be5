import { element, empty } from '../dom.js';
import { lotLaws } from '../report.js';
import { symbol } from '../symbols.js';
import { table } from '../tables.js';
import { DASH, fixed, isNumber } from '../text.js';
import { ofLot } from './of_lot.js';

export const lotCorrelationFigure = {
  id: 'lot-correlation',
  width: 'half',
  title: 'How the parameters vary together',
  depends: ['lotLaw'],
  wanted: () => lotLaws.some((law) => law.population !== null),
  caption: correlationCaption,
  csv: correlationData,
  build: correlationTable,
};

function correlations(law) {
  const { parameters = [], correlation = [] } = law.population ?? {};
  return correlation
    .flatMap((row, i) => row.slice(0, i).map((value, j) => ({ names: [parameters[j], parameters[i]], value })))
    .filter(({ value }) => isNumber(value))
    .sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
}

function correlationCaption() {
  const law = ofLot(),
    strong = correlations(law).filter(({ value }) => Math.abs(value) >= 0.7);
  if (correlations(law).length === 0) return law.name + ' has no correlation to show.';
  return (
    'Correlation of the parameters of ' +
    law.name + ' between devices. Blue: both rise together; rust: one rises as the other falls; \u2013: a parameter that does not vary. ' +
    (strong.length === 0
      ? 'No two are closely correlated.'
      : 'Closest: ' +
        strong
          .slice(0, 3)
          .map(({ names, value }) => names.map(symbol).join(' and ') + ' (' + fixed(value, 2) + ')')
          .join(', ') +
        '. Draw a device\u2019s parameters together, never one by one.')
  );
}

function correlationData() {
  return {
    columns: ['law', 'parameter', 'with', 'correlation'],
    rows: lotLaws.flatMap((law) => correlations(law).map(({ names, value }) => [law.id, ...names, value])),
  };
}

function correlationTable() {
  const law = ofLot();
  const { parameters = [], correlation = [], note = '' } = law.population ?? {};
  if (correlation.length === 0)
    return empty(note || 'No correlation was estimated for ' + law.name + '.');
  const columns = [
    { title: 'Parameter', pinned: true, tight: true },
    ...parameters.slice(0, -1).map((name) => ({ title: element('span', {}, symbol(name)), full: symbol(name), mark: true })),
  ];
  const rows = parameters.slice(1).map((name, i) => ({
    cells: [
      symbol(name),
      ...parameters.slice(0, -1).map((other, j) => {
        if (j > i) return element('td');
        const value = correlation[i + 1][j];
        if (!isNumber(value)) return element('td', { class: 'mark note' }, DASH);
        return element(
          'td',
          {
            class: 'mark heat ' + (value < 0 ? 'against' : 'together'),
            style: '--share: ' + Math.min(1, Math.abs(value)).toFixed(3),
            title: symbol(name) + ' with ' + symbol(other) + ': ' + fixed(value, 3),
          },
          fixed(value, 2),
        );
      }),
    ],
  }));
  // The table is a triangle, so its rows must not be sorted.
  const body = table(columns, rows, 'Correlation of the parameters of ' + law.name, { sorts: false });
  body.classList.add('marks');
  return body;
}
