import { devices, inspection } from '../report.js';
import { verdictFigure } from '../verdict/band.js';
import { factorsFigure } from './factors.js';
import { lotFigure } from './lot_table.js';
import { outliersFigure } from './outliers.js';
import { testPropertiesFigure } from './properties.js';
import { ruleSetFigure } from './rule_set.js';
import { lotStabilityFigure } from './stability.js';
import { lotStripsFigure } from './strips.js';
import { verdictTableFigure } from './verdicts.js';

// The page of an inspection begins with the verdict and the strips. One device needs only its own cycles and limits.
const ofLot = [lotFigure, ...(inspection ? [] : [lotStripsFigure]), outliersFigure, verdictTableFigure, lotStabilityFigure];
const alone = inspection && devices.length === 1;

export const devicesSection = {
  id: 'devices',
  title: 'Lot and devices',
  figures: [...(inspection ? [] : [verdictFigure]), ruleSetFigure, ...(alone ? [] : ofLot), factorsFigure, ...(alone ? [] : [testPropertiesFigure])],
};
