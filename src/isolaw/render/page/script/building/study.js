import { choose, chooser, chosen } from '../choice.js';
import { atTheHead, fixed, significant, unitText, withUnit } from '../text.js';
import { data } from '../units.js';

export const study = data;
export const laws = study.laws.map((law, index) => ({ ...law, index }));
export const first = laws[0]; // the verdict compares the bounds with the draws of this law
export const grouped = (number) => number.toLocaleString('en');

export const quantityOf = (key) => study.quantities.find((quantity) => quantity.key === key);
export const unitOf = ({ unit }) => (unit === '-' ? '' : unit);
// The cells of the columns 'quantity' and 'unit' of a CSV.
export const nameAndUnit = (key) => [quantityOf(key).title, quantityOf(key).unit];
export const axisTitle = (quantity) => quantity.title + (unitOf(quantity) ? ' [' + unitText(quantity.unit) + ']' : '');
export const valueText = (value, quantity) => withUnit(value, unitText(quantity.unit), 3);
export const isCovered = (key) => key in first.coverage.of;

export const spreadText = (std) => fixed(100 * std, std < 0.0995 ? 1 : 0) + '\u202f%';

Object.assign(chosen, {
  quantity: 'isolator_mm',
  law: 0, // the law shown in the plan and under single motions
  motion: 0,
  bearing: Math.max(0, first.bearings.displacement_mm.indexOf(Math.max(...first.bearings.displacement_mm))), // the bearing whose loop is shown
  axis: 'x',
  laws: new Set([0]), // the laws shown in the histories
});
export const quantityChooser = (id) =>
  chooser(id, 'Quantity', study.quantities.map(({ key, title }) => [key, atTheHead(title)]), 'quantity');
export const placeChooser = (id, title, names, key) =>
  chooser(id, title, names.map((name, i) => [i, name]), key, (place) => choose({ [key]: Number(place) }));

export const numberText = (value) => significant(value, 3);
