import { choose, chosen } from '../choice.js';
import { deviceChooser } from '../choosers.js';
import { element } from '../dom.js';
import { lawKey } from '../laws.js';
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
  if (drawable.length === 0) return [element('p', { class: 'empty' }, 'No record could be used.')];
  const boxes = ranking.map((law) => {
    const box = element('input', { type: 'checkbox', value: law.index, checked: chosen.laws.has(law.index) });
    box.addEventListener('change', () => {
      box.checked ? chosen.laws.add(law.index) : chosen.laws.delete(law.index);
      choose({ laws: chosen.laws });
    });
    return element('label', {}, box, lawKey(law), law.name);
  });
  return [
    deviceChooser('device', drawable, 'device'),
    element('fieldset', {}, element('legend', {}, 'Laws'), ...boxes),
  ];
}
