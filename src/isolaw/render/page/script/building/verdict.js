import { element, shortList } from '../dom.js';
import { tableOf } from '../tables.js';
import { atTheHead, fixed, sentence } from '../text.js';
import { motionFigures } from './motion.js';
import { first, nameAndUnit, quantityOf, spreadText, study, valueText } from './study.js';

const KEY = 'isolator_mm';
const WORDS = { yes: ['kept', 'good'], no: ['not kept', 'poor'], open: ['too few draws to tell', 'care'] };
const TESTED = 'tested_mm';
const MOTIONS_FOR_A_MEAN = 7; // as in building/limits.hpp: the largest response of fewer motions counts

export const verdictSection = {
  id: 'verdict',
  title: 'Does it hold?',
  short: 'Verdict',
  figures: [
    { id: 'verdict', title: '', build: band },
    ...motionFigures,
    {
      id: 'limits',
      title: 'Limits',
      wanted: () => first.limits.length > 0,
      caption: () =>
        first.name + ', ' + (study.motions.length >= MOTIONS_FOR_A_MEAN ? 'means over the motions.' : 'the largest of the motions.') +
        ' Bounds: the larger of the two bound analyses.',
      csv: () => ({
        columns: ['limit', 'quantity', 'unit', 'allowed', 'nominal', 'bound', 'p95', 'kept', 'keeps'],
        rows: first.limits.map((row) => [row.limit, ...nameAndUnit(row.quantity), row.allowed, row.nominal, row.bound, row.p95, row.kept, row.keeps]),
      }),
      build: limits,
    },
    { id: 'warnings', title: '', wanted: () => study.warnings.length > 0, build: warnings },
  ],
};

function band() {
  const tone = study.holds === null ? 'care' : study.holds ? 'good' : 'poor';
  const told = (kinds) => study.answer.filter(({ kind }) => kinds.includes(kind)).map(({ sentence: text }) => sentence(text)).join(' ');
  return element(
    'div',
    { class: 'band ' + tone },
    element('p', { class: 'headline' }, told(['building-holds', 'building-holds-with'])),
    element('p', {}, told(['building-reach'])),
    element(
      'div',
      { class: 'numbers' },
      ...numbers().map(([value, what]) => element('div', {}, element('b', {}, value), element('span', {}, what))),
    ),
  );
}

function numbers() {
  const of = first.quantities[KEY],
    tested = first.limits.find(({ limit }) => limit === TESTED);
  const reached = (key, what) => [valueText(first.quantities[key].p95, quantityOf(key)), what + ', 95\u202f% of draws'];
  return [
    ...(tested ? [[fixed((100 * Math.max(tested.nominal, tested.bound, tested.p95 ?? 0)) / tested.allowed, 0) + '\u202f%', 'of the tested displacement, at most']] : []),
    ...(study.motions.length >= MOTIONS_FOR_A_MEAN ? [reached('shear_over_weight', 'base shear over weight')] : []),
    [spreadText(of.lot_std_ln), 'scatter from the lot' + (study.law_std_ln === null ? '' : '; laws ' + spreadText(study.law_std_ln))],
  ];
}

function limits() {
  const title = ({ limit, quantity }) => (limit === TESTED ? 'Displacement that was tested' : atTheHead(quantityOf(quantity).title));
  const shown = ({ quantity }, value) => (value === null ? '' : valueText(value, quantityOf(quantity)));
  return tableOf(
    [
      { title: 'Limit', cell: title },
      { title: 'Allowed', number: true, cell: (row) => shown(row, row.allowed) },
      { title: 'Nominal', number: true, cell: (row) => shown(row, row.nominal) },
      { title: 'Bounds', number: true, cell: (row) => shown(row, row.bound) },
      { title: '95\u202f% of draws', number: true, cell: (row) => shown(row, row.p95) },
      { title: 'Kept by', number: true, cell: (row) => (row.kept === null ? '' : fixed(100 * row.kept, 1) + '\u202f%') },
      { title: 'Verdict', cell: ({ keeps }) => element('span', { class: 'sure ' + WORDS[keeps][1] }, WORDS[keeps][0]) },
    ],
    first.limits,
    'Limits of the building',
    { sorts: false },
  );
}

function warnings() {
  return element(
    'div',
    { class: 'warnings' },
    element('h3', {}, study.warnings.length === 1 ? 'A warning' : 'Warnings'),
    ...shortList(study.warnings.map((text) => element('li', {}, sentence(text))), 4, 3),
  );
}
