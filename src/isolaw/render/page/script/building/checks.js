import { tableOf } from '../tables.js';
import { deviation, fixed, isNumber, mean, shareText, significant } from '../text.js';
import { laws, study } from './study.js';
import { MM, decimalsIn } from '../units.js';

const rows = laws.flatMap((law) => law.checked.map((checked, motion) => ({ law, checked, motion: study.motions[motion].name })));
// The columns of numbers in the CSV: [title of the column, key in the data].
const NUMBERS = [
  ['bearing [' + MM + ']', 'isolator_mm'], ['energy error', 'energy_error'], ['step [s]', 'step_s'], ['step error [' + MM + ']', 'missed_mm'],
  ['draws deviate [%]', 'lanes_off_percent'], ['hand method [' + MM + ']', 'equivalent_mm'], ['error of the hand method [%]', 'equivalent_error_percent'],
  ['period [s]', 'equivalent_period_s'], ['damping', 'equivalent_damping'],
];

export const checksSection = {
  id: 'checks',
  title: 'Checks and the hand method',
  short: 'Checks',
  figures: [
    {
      id: 'checks',
      title: 'Nominal building under each motion',
      long: true,
      caption: () =>
        'Results of the implicit integrator, and how far the integrator of the draws deviates. Equivalent linear analysis with each motion\u2019s own spectrum deviates by ' +
        deviation(mean(rows.map(({ checked }) => checked.equivalent_error_percent).filter(isNumber)), 0) + ' on average.',
      csv: () => ({
        columns: ['law', 'motion', 'outcome', ...NUMBERS.map(([title]) => title)],
        rows: rows.map(({ law, motion, checked }) => [law.id, motion, checked.outcome, ...NUMBERS.map(([, key]) => checked[key])]),
      }),
      build: () =>
        tableOf(
          [
            ...(laws.length > 1 ? [{ title: 'Law', cell: ({ law }) => law.name }] : []),
            { title: 'Motion', cell: ({ motion }) => motion },
            { title: 'Bearing', unit: MM, number: true, cell: ({ checked }) => fixed(checked.isolator_mm, decimalsIn('mm', 1)) },
            { title: 'Step error', unit: MM, number: true, cell: ({ checked }) => significant(checked.missed_mm, 1) },
            { title: 'Energy error', number: true, cell: ({ checked }) => significant(checked.energy_error, 1) },
            { title: 'Draws deviate', number: true, cell: ({ checked }) => deviation(checked.lanes_off_percent, 2) },
            { title: 'Hand method', unit: MM, number: true, cell: ({ checked }) => fixed(checked.equivalent_mm, decimalsIn('mm', 1)) },
            { title: 'Its error', number: true, cell: ({ checked }) => deviation(checked.equivalent_error_percent, 0) },
            { title: 'Period', unit: 's', number: true, cell: ({ checked }) => fixed(checked.equivalent_period_s, 2) },
            { title: 'Damping', number: true, cell: ({ checked }) => shareText(checked.equivalent_damping, 0) },
            { title: 'Outcome', cell: ({ checked }) => checked.outcome },
          ],
          rows,
          'Checks of the nominal building',
        ),
    },
  ],
};
