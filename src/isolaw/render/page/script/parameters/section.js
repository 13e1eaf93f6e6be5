import { chosen } from '../choice.js';
import { lawChooser } from '../choosers.js';
import { ranking } from '../report.js';
import { convergenceFigure } from './convergence.js';
import { parameterPanelsFigure } from './panels.js';
import { parameterTablesFigure } from './tables.js';

export const parametersSection = {
  id: 'parameters',
  title: 'Parameters',
  controls: parameterControls,
  laws: true,
  figures: [parameterPanelsFigure, convergenceFigure, parameterTablesFigure],
};

function parameterControls() {
  return chosen.law === null ? [] : [lawChooser('law', ranking)];
}
