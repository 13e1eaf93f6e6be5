import { element } from '../dom.js';
import { report, resultData } from '../report.js';
import { tableOf } from '../tables.js';

export const publishedVerdictFigure = {
  id: 'published-verdict',
  title: '',
  wanted: () => report.published !== null,
  build: () => element('p', { class: 'headline' }, report.published.verdict),
};

export const statementsFigure = {
  id: 'published-statements',
  title: 'What the study says, and what is found here',
  wanted: () => report.published !== null,
  caption: () => 'Statements of ' + report.published.source + ', in our words, tested only by the mean objective over the runs and \u03b2.',
  csv: () => resultData('published_statements', report.published.statements.map((statement) => [statement])),
  build: statementTable,
};

const judged = (holds) => (holds === null ? 'open' : holds ? 'holds' : 'does not');
const mark = (holds) => element('span', { class: holds === null ? 'muted' : holds ? 'good' : 'poor' }, judged(holds));

function statementTable() {
  const columns = [
    { title: 'Statement', cell: ({ text }) => element('th', { scope: 'row', class: 'text' }, text) },
    { title: 'Here', tight: true, cell: ({ here }) => mark(here) },
    { title: 'In its Table A.5', tight: true, cell: ({ in_table: holds }) => mark(holds) },
    { title: 'Found here', cell: ({ found }) => element('td', { class: 'note text' }, found) },
    { title: 'Where', tight: true, cell: ({ where }) => where },
  ];
  return tableOf(columns, report.published.statements, 'Statements of the published study');
}
