import { choose, chosen, onChoice } from '../choice.js';
import { deviceChooser } from '../choosers.js';
import { blockText } from '../cycles.js';
import { element, empty, shortList } from '../dom.js';
import { devices, inspection, report, tested } from '../report.js';
import { assessmentsFigure } from './assessments.js';
import { cycleHistoryFigure } from './history.js';
import { levelsFigure } from './levels.js';
import { cyclesFigure } from './loops.js';
import { orbitFigure } from './orbit.js';
import { remainderFigure } from './remainder.js';
import { skeletonFigure } from './skeleton.js';
import { stabilityFigure } from './stability.js';
import { cycleTableFigure } from './table.js';

const warningsFigure = {
  id: 'warnings',
  title: '',
  wanted: () => inspection && warned().length > 0,
  build: takeCare,
};

export const propertiesSection = {
  id: 'properties',
  title: 'Properties',
  controls: propertyControls,
  figures: [
    warningsFigure, cyclesFigure, stabilityFigure, orbitFigure, remainderFigure, cycleHistoryFigure, skeletonFigure,
    cycleTableFigure, levelsFigure, ...(inspection && devices.length === 1 ? [] : [assessmentsFigure]),
  ],
};

function propertyControls() {
  const select = element('select', { id: 'block', change: () => choose({ block: select.value === 'all' ? 'all' : Number(select.value) }) });
  const fill = () => {
    const blocks = devices[chosen.tested]?.blocks ?? [];
    const options = [['all', 'all'], ...blocks.map((block) => [block.number, blockText(block)])];
    select.replaceChildren(...options.map(([value, text]) => element('option', { value }, text)));
    select.value = chosen.block;
    select.disabled = blocks.length < 2;
  };
  fill();
  let shown = chosen.tested;
  onChoice(() => {
    if (shown !== chosen.tested) fill();
    shown = chosen.tested;
    select.value = chosen.block;
  });
  if (inspection && tested.length === 1 && tested[0].blocks.length < 2) return [];
  return tested.length === 0
    ? [empty('No record could be read.')]
    : [deviceChooser('tested', tested, 'tested'), element('label', {}, 'Block', select)];
}

// The warnings of this section. Warnings about conditions belong to the section on conditions, if there is one.
const warned = () => report.findings.warnings.filter(({ topic }) => !report.conditions || topic !== 'conditions');

function takeCare() {
  const warnings = warned().map((warning) => element('li', {}, warning.sentence));
  return element('div', { class: 'warnings' }, element('h3', {}, 'Take care'), ...shortList(warnings, 5, 4));
}
