import { choose, chooser, chosen } from '../choice.js';
import { atTheHead, isNumber, shareText, significant, unitText, withUnit } from '../text.js';
import { data } from '../units.js';

export const study = data;
export const laws = study.laws.map((law, index) => ({ ...law, index }));
// The law that the verdict is about: the first law whose analyses gave numbers.
export const first = laws.find(({ id }) => id === study.answer[0]?.law) ?? laws[0];
export const isDrawn = study.draws !== null; // whether parameters of any bearing are drawn from the lot
// bound() returns the factors on the force at the lower or upper bound as text. A bound may come from the design
// conditions. It is then a separate law with an elastic and a hysteretic factor, and the page states the factors for
// the law that the verdict is about.
const ofBoundLaws = study.calibration.filter(({ kind, law }) => kind === 'bound-law' && law === first.id); // the lower bound comes first
function bound(factor, place) {
  if (isNumber(factor)) return String(factor);
  if (factor !== null) return factor.elastic + ' elastic and ' + factor.hysteretic + ' hysteretic';
  const [{ numbers }] = ofBoundLaws.at(place).each;
  return significant(numbers.elastic_factor, 3) + ' elastic and ' + significant(numbers.hysteretic_factor, 3) + ' hysteretic, from the design conditions';
}
export const BOUNDS = bound(study.lower_factor, 0) + '; ' + bound(study.upper_factor, -1);
const fromConditions = ['lower', 'upper'].filter((side) => study[side + '_factor'] === null);
// This note stands beside the responses at the bounds. It says which bounds are laws for the design conditions and not
// factors on the force.
export const FROM_CONDITIONS = fromConditions.length === 0 ? '' : ' From the design conditions: the ' + fromConditions.join(' and the ') + ' bound.';
export const grouped = (number) => number.toLocaleString('en');

export const quantityOf = (key) => study.quantities.find((quantity) => quantity.key === key);
export const unitOf = ({ unit }) => (unit === '-' ? '' : unit);
// Returns the cells of the columns 'quantity' and 'unit' of a CSV file.
export const nameAndUnit = (key) => [quantityOf(key).title, quantityOf(key).unit];
export const axisTitle = (quantity) => quantity.title + (unitOf(quantity) ? ' [' + unitText(quantity.unit) + ']' : '');
export const valueText = (value, quantity) => withUnit(value, unitText(quantity.unit), 3);
export const isCovered = (key) => isDrawn && key in first.coverage.of;

export const spreadText = (std) => shareText(std, std < 0.0995 ? 1 : 0);
export const SPREAD = 'Standard deviation of the natural logarithm of the response: 0.24 is shown as 24\u202f%';

Object.assign(chosen, {
  quantity: 'isolator_mm',
  law: first.index, // the law shown in the plan and under single motions
  motion: 0,
  bearing: Math.max(0, first.bearings.displacement_mm.indexOf(Math.max(...first.bearings.displacement_mm))), // the bearing whose loop is shown
  axis: 'x',
  laws: new Set([first.index]), // the laws shown in the histories
});
export const quantityChooser = (id) =>
  chooser(id, 'Quantity', study.quantities.map(({ key, title }) => [key, atTheHead(title)]), 'quantity');
export const placeChooser = (id, title, names, key) =>
  chooser(id, title, names.map((name, i) => [i, name]), key, (place) => choose({ [key]: Number(place) }));

export const numberText = (value) => significant(isNumber(value) && Math.abs(value) < 1e-9 ? 0 : value, 3);
