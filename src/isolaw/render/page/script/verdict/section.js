import { lotStripsFigure } from '../devices/strips.js';
import { assessmentsFigure } from '../properties/assessments.js';
import { devices, inspection } from '../report.js';
import { verdictFigure } from './band.js';

export const verdictSection = {
  id: 'verdict',
  title: 'Verdict',
  figures: !inspection ? [] : devices.length > 1 ? [verdictFigure, lotStripsFigure] : [verdictFigure, assessmentsFigure],
};
