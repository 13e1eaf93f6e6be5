import { laws } from './report.js';
import { isNumber } from './text.js';

export const VIEWS = [
  {
    id: 'runs',
    title: 'mean of the runs',
    column: 'mean of the runs', // heading in a CSV file
    robust: (law) => law.beta,
    accurate: (law) => law.objective.mean,
    onFront: (law) => law.on_front,
    whyNot: (law) => law.beta_note,
    axes: ['robustness index β [-], smaller is more robust', 'mean objective OF [-], smaller is more accurate'],
    names: ['beta', 'mean OF'],
    says: 'lower is more accurate; further left, its parameters agree better between devices.',
  },
  {
    id: 'converged',
    title: 'without the optimiser\u2019s noise',
    column: "without the optimiser's noise",
    robust: (law) => law.beta_converged,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_converged,
    whyNot: (law) => law.beta_converged_note,
    axes: ['β of the least objectives [-]', 'least objective OF [-], mean over devices'],
    names: ['beta of the least objectives', 'least OF'],
    says: 'the best fit of every device counts instead of the mean over runs, and \u03b2 leaves out parameters that most tests do not determine.',
  },
  {
    id: 'left-out',
    title: 'device left out',
    column: 'device left out',
    robust: (law) => law.loo_objective,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_loo,
    whyNot: () => '',
    axes: ['OF on a device by the law of all others [-]', 'least objective OF [-], mean over devices'],
    names: ['OF on devices left out', 'least OF'],
    says: 'lower is more accurate on a tested device; further left, on a device that was not tested (one law, fitted to all others).',
  },
].filter((view) => laws.some((law) => isPlaced(view, law)));
export const FIRST_VIEW = (VIEWS.find(({ id }) => id === 'converged') ?? VIEWS[0])?.id;

export function isPlaced(view, law) {
  return isNumber(view.robust(law)) && isNumber(view.accurate(law));
}

