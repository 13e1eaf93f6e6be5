import { chosen, onChoice } from '../choice.js';
import { chooseLaw } from '../choosers.js';
import { element, onScreen, strong } from '../dom.js';
import { colourOf } from '../plotting.js';
import { standings } from '../recommendation.js';
import { tableOf } from '../tables.js';
import { DASH, errorText, isNumber, sentence } from '../text.js';

export const lawsFigure = {
  id: 'laws',
  title: 'The laws compared',
  caption: () => onScreen(HOW) + CAPTION + (columns().some(({ key }) => key === 'new_device') ? NEW_DEVICE : ''),
  csv: lawsData,
  build: lawsTable,
};

const HOW = 'Choose a law to see its loop above and its results in every section. ';
const CAPTION = 'An error is the mean misfit of the force, as a share of the measured force\u2019s standard deviation.';
const NEW_DEVICE = ' Another device: one set of parameters, fitted to all other devices.';
const PLACES = { taken: 'taken', ties: 'as good', behind: '', 'ruled out': 'ruled out' };

// The columns of errors. A column is shown if at least one law has such an error. Each number has a bar beside it,
// except in columns with `plain`. All bars have the same scale. It ends at the largest error or, if this is smaller, at
// twice the largest error of the laws that are not ruled out. Longer bars are cut.
const ERRORS = [
  { key: 'fits', title: 'Fits', of: ({ fits }) => fits },
  { key: 'new_device', title: 'Another device', of: ({ law }) => law.loo_objective },
  { key: 'worst', title: 'At worst', of: ({ law }) => law.loo_worst, plain: true },
  { key: 'blocks', title: 'Predicts blocks left out', of: ({ law }) => law.predicted_objective },
  { key: 'larger', title: 'Predicts larger swings', of: ({ law, predicts }) => (isNumber(law.predicted_objective) ? null : predicts) },
];
const columns = () => ERRORS.filter(({ of }) => standings.some((standing) => isNumber(of(standing))));

function longest() {
  const errors = (among) => among.flatMap((standing) => columns().filter((column) => !column.plain).map(({ of }) => of(standing))).filter(isNumber);
  const taken = errors(standings.filter(({ place }) => place !== 'ruled out'));
  const all = errors(standings);
  return Math.min(Math.max(...all), 2 * Math.max(...(taken.length > 0 ? taken : all)));
}

function errorCell(column) {
  const most = longest();
  return (standing) => {
    const error = column.of(standing);
    if (!isNumber(error)) return DASH;
    if (column.plain) return errorText(error);
    const share = Math.min(1, error / most);
    const bar = element('span', { class: error > most ? 'bar cut' : 'bar' });
    bar.style.width = (4.5 * share).toFixed(2) + 'rem';
    return element('td', { class: 'error', 'data-sort': String(error) }, bar, errorText(error));
  };
}

function lawCell({ law }) {
  const input = element('input', { type: 'radio', name: 'law-shown', value: law.index, checked: law.index === chosen.law, change: () => chooseLaw(law.index) });
  const key = element('span', { class: 'key', style: `border-color: var(--${colourOf(law)})` });
  return element('label', { class: 'law-choice' }, input, key, strong(law.name));
}

function remark({ place, reason, weak }) {
  if (reason) return sentence(reason);
  return place === 'behind' ? sentence(weak[0]?.sentence ?? '') : PLACES[place];
}

function lawsTable() {
  const table = tableOf(
    [
      { title: 'Law', pinned: true, tight: true, cell: lawCell, by: ({ law }) => law.name },
      ...columns().map((column) => ({ title: column.title, number: true, cell: errorCell(column), by: column.of })),
      { title: 'Parameters', number: true, cell: ({ parameters }) => (parameters > 0 ? String(parameters) : DASH) },
      { title: 'Remark', cell: (standing) => element('td', { class: 'note text' }, remark(standing)) },
    ],
    standings,
    'The laws compared',
    { className: ({ place }) => PLACES[place] && place.replace(' ', '-') },
  );
  const follow = () => {
    for (const input of table.querySelectorAll('input')) {
      input.checked = Number(input.value) === chosen.law;
      input.closest('tr').classList.toggle('chosen', input.checked);
    }
  };
  onChoice(follow);
  follow();
  return table;
}

function lawsData() {
  const shown = columns();
  return {
    columns: ['law', 'place', ...shown.map(({ title }) => title + ' [-]'), 'parameters', 'reason'],
    rows: standings.map((standing) => [
      standing.law.id, standing.place, ...shown.map(({ of }) => of(standing)), standing.parameters, standing.reason,
    ]),
  };
}
