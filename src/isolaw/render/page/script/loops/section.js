import { lawBoxes } from '../choice.js';
import { deviceChooser } from '../choosers.js';
import { empty } from '../dom.js';
import { drawable, ranking } from '../report.js';
import { cleaningFigure } from './cleaning.js';
import { energyFigure } from './energy.js';
import { historyFigure } from './history.js';
import { loopFigure } from './loop.js';
import { loopOverviewFigure } from './overview.js';
import { fitsFigure } from './table.js';

export const loopsSection = {
  id: 'loops',
  title: 'Loops',
  controls: loopControls,
  laws: true,
  figures: [loopFigure, historyFigure, fitsFigure, loopOverviewFigure, energyFigure, cleaningFigure],
};

function loopControls() {
  if (drawable.length === 0) return [empty('No record could be used.')];
  return [deviceChooser('device', drawable, 'device'), lawBoxes(ranking)];
}
