import { publishedLawsFigure } from './laws.js';
import { statementsFigure, verdictFigure } from './statements.js';

export const publishedSection = {
  id: 'published',
  title: 'The published study',
  short: 'Published',
  laws: true,
  figures: [verdictFigure, statementsFigure, publishedLawsFigure],
};
