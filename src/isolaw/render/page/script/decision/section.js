import { objectiveBarsFigure } from './bars.js';
import { frontFigure } from './front.js';
import { rankingFigure } from './ranking.js';
import { convergedFigure, verdictsFigure } from './verdicts.js';

export const decisionSection = {
  id: 'decision',
  title: 'The decision',
  laws: true,
  figures: [frontFigure, objectiveBarsFigure, convergedFigure, verdictsFigure, rankingFigure],
};
