import { choiceButtons } from '../choice.js';
import { empty } from '../dom.js';
import { report } from '../report.js';
import { answerFigure } from './answer.js';
import { boundLawsFigure } from './bound_laws.js';
import { PROPERTIES, conditions } from './data.js';
import { factorTableFigure, factorsFigure } from './factors.js';
import { historyFigure } from './history.js';
import { loopsFigure } from './loops.js';
import { matrixFigure } from './matrix.js';
import { panelsFigure } from './panels.js';

// Says why there are no results although the lot file asks for them.
const whyNotFigure = {
  id: 'no-conditions',
  title: '',
  wanted: () => Boolean(report.no_conditions),
  build: () => empty('The tests cannot be compared: ' + report.no_conditions),
};

export const conditionsSection = {
  id: 'conditions',
  title: 'Conditions',
  figures: conditions
    ? [
        answerFigure, factorsFigure, factorTableFigure, loopsFigure, boundLawsFigure, withProperties(panelsFigure),
        historyFigure, matrixFigure,
      ]
    : [whyNotFigure],
};

// Adds buttons above a figure with which the reader chooses the properties that it shows.
function withProperties(figure) {
  const options = PROPERTIES.map((group, place) => [String(place), group.join(' and ')]);
  return options.length > 1 ? { ...figure, controls: () => [choiceButtons('conditionsGroup', options, { 'aria-label': 'Properties' })] } : figure;
}
