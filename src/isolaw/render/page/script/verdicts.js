import { element } from './dom.js';
import { ROUND, icon } from './icons.js';
import { report, resultData } from './report.js';

export const isVerified = () => Boolean(report.assessment?.rule_set?.verified_by);

export const worstVerdict = (verdicts) =>
  ['fail', 'pass', 'information', 'not assessed'].find((verdict) => verdicts.includes(verdict)) ?? null;

// Returns whether an assessment is about the value of the property itself, on one or both sides of the loop, and not
// about how it changes over cycles or loads.
export const concerns = (assessment, property) => assessment.property === property && assessment.subject === 'device';

// The looks of verdicts. Each verdict has a shape of its own, so that a reader can tell them apart without colour.
export const VERDICTS = {
  pass: { tone: 'good', filled: true, path: ROUND, mark: 'M3.4 6.2 L5.3 8 L8.6 4', symbol: 'circle' },
  fail: {
    tone: 'poor', filled: true, path: 'M1 1 H11 V11 H1 Z', mark: 'M3.6 3.6 L8.4 8.4 M8.4 3.6 L3.6 8.4',
    symbol: 'square',
  },
  information: {
    tone: 'muted', filled: false, path: 'M6 .9 L11.1 6 L6 11.1 L.9 6 Z', mark: 'M6 5.4 V8.2 M6 3.4 V4.2',
    symbol: 'diamond-open',
  },
  'not assessed': { tone: 'muted', filled: false, path: 'M1.5 6 H10.5', mark: '', symbol: 'triangle-up-open' },
};
export const WORDS = { PASS: { tone: 'good', verdict: 'pass' }, FAIL: { tone: 'poor', verdict: 'fail' }, INCOMPLETE: { tone: 'care', verdict: 'not assessed' } };

// Returns the word of the overall verdict for readers. A PASS that depends on corrections made by the user says so.
export const wordOf = ({ word, as_corrected: corrected }) => (corrected ? word + ' as corrected' : word);

export function verdictBadge(verdict, text = verdict) {
  const known = VERDICTS[verdict] ?? VERDICTS['not assessed'];
  const colour = 'var(--' + known.tone + ')';
  const shapes = [[known.path, known.filled ? colour : 'none', colour]];
  if (known.mark) shapes.push([known.mark, 'none', known.filled ? 'var(--paper)' : colour]);
  return element('span', { class: 'verdict ' + known.tone }, icon(...shapes), text);
}

export const assessmentData = (among) =>
  resultData('assessments', among.flatMap((device) => device.assessments.map((a) => [device.name, a])), ['device']);
