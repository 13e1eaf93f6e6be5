import { element } from '../dom.js';
import { resultData } from '../report.js';
import { isNumber, trimmed } from '../text.js';
import {
  EFFECTS, allLevels, atText, conditionOf, conditions, endsOf, levelText, levelsOf, rangeOf, referenceAt, statusWord,
} from './data.js';

export const matrixFigure = {
  id: 'conditions-matrix',
  title: 'What was tested',
  width: 'narrow',
  wanted: () => EFFECTS.length > 0,
  caption: () => 'Number of devices tested at each level. Dashed and empty: a design condition at which no device was tested.',
  csv: () => resultData('conditions_tests', conditions.tests.map((test) => [test])),
  build: matrix,
};

const [first] = (conditions?.bounds ?? []).map(({ quantity }) => quantity);
const QUANTITY = first ?? allLevels[0]?.quantity;

// Returns the cells of an effect: its tested levels, the reference, and those ends of the design range at which no test
// was made, sorted by the condition.
function cellsOf(effect) {
  const tested = levelsOf(effect, QUANTITY).map((level) => ({ at: level.at, text: levelText(level), devices: level.factor.devices }));
  const at = conditionOf(effect) ? referenceAt(effect) : null;
  const reference = isNumber(at) ? [{ at, text: atText(effect, at), devices: null, reference: true }] : [];
  const open = endsOf(effect, QUANTITY)
    .filter(({ factor }) => factor.status !== 'shown' && factor.status !== 'unpaired' && factor.status !== 'scaled')
    .map((end) => ({ at: end.at, text: atText(effect, end.at), devices: 0, why: statusWord(end.factor.status) }));
  const asked = conditions.design.find((row) => row.effect === effect && row.quantity === QUANTITY);
  const hole = { at: null, text: rangeOf(effect)?.map((end) => trimmed(end)).join(' to ') ?? '', devices: 0, why: statusWord(asked?.max.status ?? 'not covered') };
  const untested = tested.length === 0 && open.length === 0 ? [hole] : [];
  return [...tested, ...reference, ...open, ...untested].sort((a, b) => (a.at ?? 0) - (b.at ?? 0));
}

function matrix() {
  const cell = ({ text, devices, reference, why }) =>
    element(
      'li',
      { class: reference ? 'reference' : devices === 0 ? 'hole' : null },
      element('small', {}, text),
      element('b', {}, reference ? 'reference' : devices === 0 ? why : String(devices)),
    );
  const rows = EFFECTS.map((effect) => [element('dt', {}, effect), element('dd', {}, element('ul', {}, cellsOf(effect).map(cell)))]);
  return element('dl', { class: 'levels' }, rows);
}
