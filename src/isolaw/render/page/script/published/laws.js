import { element, sentences, strong } from '../dom.js';
import { nameOf } from '../laws.js';
import { laws, report, resultData } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, fixed, sentence, significant } from '../text.js';

export const publishedLawsFigure = {
  id: 'published-laws',
  title: 'The study\u2019s laws, here and in its Table A.5',
  wanted: () => report.published !== null,
  caption: () =>
    'Published: the study\u2019s own ten devices, 20 runs of a genetic algorithm each, objectives printed to two digits. \u03c3, runs: standard deviation of OF over the runs, mean over the devices; ' +
    'the genetic algorithm, as the study describes it, scatters more than its table says. Front: only these laws are compared.',
  csv: () => resultData('published_laws', report.published.laws.map((law) => [law])),
  build: () => element('div', {}, lawTable(), readings()),
};

function lawTable() {
  const pair = (title, key, text) => [
    { title, unit: 'here', number: true, cell: (law) => text(law[key]) },
    { title, unit: 'published', number: true, cell: (law) => text(law['published_' + key]) },
  ];
  const frontHere = (law) => (law.beta === null || !law.compared ? DASH : law.on_front ? 'yes' : 'no');
  const columns = [
    { title: 'No.', tight: true, cell: (law) => String(law.number) },
    { title: 'Law', tight: true, cell: (law) => strong(nameOf(law.law)) },
    ...pair('mean OF', 'objective', (value) => fixed(value, 4)),
    ...pair('\u03c3, runs', 'std_over_runs', (value) => significant(value, 2)),
    ...pair('\u03c3, devices', 'std_over_devices', (value) => significant(value, 2)),
    ...pair('\u03b2', 'beta', (value) => fixed(value, 3)),
    { title: 'front', unit: 'here / published', tight: true, cell: (law) => frontHere(law) + ' / ' + (law.published_on_front ? 'yes' : 'no') },
  ];
  return tableOf(columns, report.published.laws, 'Laws of the published study');
}

function readings() {
  const notes = report.published.laws.flatMap(({ law: id }) =>
    (laws.find((law) => law.id === id)?.notes ?? []).map((note) =>
      [element('b', {}, id), ': ' + sentence(note)],
    ),
  );
  if (notes.length === 0) return null;
  return element('details', {}, element('summary', {}, 'How its laws are read'), sentences(notes));
}
