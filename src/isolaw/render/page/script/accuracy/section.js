import { objectiveDevicesFigure } from './objectives.js';
import { objectiveRelativeFigure, objectiveSpreadFigure } from './spread.js';

export const accuracySection = {
  id: 'objective',
  title: 'Accuracy',
  laws: true,
  figures: [objectiveDevicesFigure, objectiveSpreadFigure, objectiveRelativeFigure],
};
