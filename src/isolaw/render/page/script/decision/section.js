import { answerFigure } from './answer.js';
import { frontFigure } from './front.js';
import { rankingFigure } from './ranking.js';
import { convergedFigure, verdictsFigure } from './verdicts.js';

export const decisionSection = {
  id: 'decision',
  title: 'The decision',
  laws: true,
  figures: [answerFigure, frontFigure, verdictsFigure, rankingFigure, convergedFigure],
};
