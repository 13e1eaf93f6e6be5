import { lotCorrelationFigure } from './correlation.js';
import { lotLawsFigure } from './cost.js';
import { lotDevicesFigure } from './devices.js';
import { lotOutliersFigure } from './outliers.js';
import { lotParametersFigure } from './parameters.js';

export const oneLawSection = {
  id: 'one-law',
  title: 'One law for the lot',
  short: 'One law',
  laws: true,
  figures: [lotLawsFigure, lotDevicesFigure, lotParametersFigure, lotCorrelationFigure, lotOutliersFigure],
};
