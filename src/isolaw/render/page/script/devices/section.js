import { factorsFigure } from './factors.js';
import { lotFigure } from './lot_table.js';
import { outliersFigure } from './outliers.js';
import { testPropertiesFigure } from './properties.js';
import { ruleSetFigure } from './rule_set.js';
import { lotStabilityFigure } from './stability.js';
import { lotStripsFigure } from './strips.js';
import { verdictTableFigure } from './verdicts.js';

export const devicesSection = {
  id: 'devices',
  title: 'Lot and devices',
  figures: [ruleSetFigure, lotFigure, lotStripsFigure, outliersFigure, verdictTableFigure, lotStabilityFigure, factorsFigure, testPropertiesFigure],
};
