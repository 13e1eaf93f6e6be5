import { determinedFigure } from './determined.js';
import { profileFigure } from './profile.js';
import { tradeOffsFigure } from './trade_offs.js';

export const determinationSection = {
  id: 'determination',
  title: 'What the tests determine',
  laws: true,
  figures: [determinedFigure, profileFigure, tradeOffsFigure],
};
