import { element, strong } from './dom.js';
import { doesNotPredict, laws, report } from './report.js';
import { enumerate } from './text.js';

// Makes the badge beside the name of a law whose predictions are bad.
function predictionBadge(law, name = '') {
  return element(
    'span',
    { class: 'badge', title: 'misses the blocks it was not fitted to: see Prediction across the record' },
    name + 'prediction ' + law.prediction_grade,
  );
}

export const lawOf = (id) => laws.find((law) => law.id === id);
export const nameOf = (id) => lawOf(id)?.name ?? id;

export const lawName = (law) =>
  element(
    'span',
    {},
    strong(law.name),
    ...(doesNotPredict(law) ? [' ', predictionBadge(law)] : []),
  );

export const withBadges = (text, about) => [text, ...about.filter(doesNotPredict).flatMap((law) => [' ', predictionBadge(law, law.name + ': ')])];

export function predictionNote(among) {
  const graded = (grade) => among.filter((law) => law.prediction_grade === grade).map((law) => law.name);
  const parts = ['unusable', 'poor'].filter((grade) => graded(grade).length > 0);
  return parts.length > 0
    ? ' Prediction across the record: ' + parts.map((grade) => grade + ' of ' + enumerate(graded(grade))).join('; ') + '.'
    : '';
}

const inadequate = new Set(
  report.findings.verdicts.filter((verdict) => verdict.role === 'not adequate').map((verdict) => verdict.law),
);
export const isInadequate = (law) => inadequate.has(law.index);
