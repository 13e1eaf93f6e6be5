import { element, shortList } from '../dom.js';
import { said, tableOf } from '../tables.js';
import { DASH, atTheHead, isNumber, sentence, shareText } from '../text.js';
import { motionFigures } from './motion.js';
import { FROM_CONDITIONS, SPREAD, first, isDrawn, laws, nameAndUnit, quantityOf, spreadText, study, valueText } from './study.js';

const KEY = 'isolator_mm';
const WORDS = { yes: ['kept', 'good'], no: ['not kept', 'poor'], open: ['too few draws to tell', 'care'] };
const TESTED = 'tested_mm';
// A limit is compared with the mean response over the motions, or with the largest response if there are fewer motions
// than design codes require for the use of a mean.
const IS_MEAN = study.motions.length >= study.motions_for_a_mean;

export const verdictSection = {
  id: 'verdict',
  title: 'Does it hold?',
  short: 'Verdict',
  figures: [
    { id: 'verdict', title: '', build: band },
    {
      id: 'limits',
      title: 'Limits',
      wanted: () => rows.length > 0,
      caption: () =>
        (laws.length > 1 ? 'Responses: ' : first.name + ', ') + (IS_MEAN ? 'means over the motions.' : 'the largest of the motions.') + FROM_CONDITIONS,
      csv: () => ({
        columns: ['law', 'limit', 'quantity', 'unit', 'allowed', 'nominal', 'bound', 'p95', 'kept', 'keeps', 'broken_by'],
        rows: rows.map(({ law, ...row }) => [
          law.id, row.limit, ...nameAndUnit(row.quantity), row.allowed, row.nominal, row.bound, row.p95, row.kept, row.keeps, row.broken_by,
        ]),
      }),
      build: limits,
    },
    ...motionFigures,
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
    ...['building-law-failed', 'building-reach'].map((kind) => told([kind])).filter(Boolean).map((text) => element('p', {}, text)),
    element(
      'div',
      { class: 'numbers' },
      ...numbers().map(([value, what, full]) => element('div', { title: full ?? null }, element('b', {}, value), element('span', {}, what))),
    ),
  );
}

function numbers() {
  const of = first.quantities[KEY],
    tested = first.limits.find(({ limit }) => limit === TESTED);
  const shear = first.quantities.shear_over_weight;
  const reached = isDrawn ? [shear.p95, ', 95\u202f% of draws'] : [shear.nominal, ', nominal'];
  const moved = tested ? [tested.nominal, tested.bound, ...(isDrawn ? [tested.p95] : [])] : [];
  return [
    ...(tested ? [[moved.every(isNumber) ? shareText(Math.max(...moved) / tested.allowed, 0) : DASH, 'of the tested displacement, at most']] : []),
    ...(IS_MEAN ? [[valueText(reached[0], quantityOf('shear_over_weight')), 'base shear over weight' + reached[1]]] : []),
    ...(isDrawn ? [[spreadText(of.lot_std_ln), 'scatter from the lot' + (study.law_std_ln === null ? '' : '; laws ' + spreadText(study.law_std_ln)), SPREAD]] : []),
  ];
}

const rows = laws.flatMap((law) => law.limits.map((row) => ({ law, ...row })));

// Says whether a limit is kept, and if it is not, what breaks it.
function verdictOf({ keeps, broken_by: by }) {
  const cause = by === null ? '' : by.endsWith('failed') ? ': no numbers (' + by.split(' ')[0] + ')' : ': ' + by;
  return element('span', { class: 'sure ' + WORDS[keeps][1] }, WORDS[keeps][0] + cause);
}

function limits() {
  const title = ({ limit, quantity }) => (limit === TESTED ? 'Displacement that was tested' : atTheHead(quantityOf(quantity).title));
  const shown = ({ quantity }, value) => valueText(value, quantityOf(quantity));
  return tableOf(
    [
      ...(laws.length > 1 ? [{ title: 'Law', cell: ({ law }, i) => said(law !== rows[i - 1]?.law, element('span', {}, law.name)) }] : []),
      { title: 'Limit', cell: title },
      { title: 'Allowed', number: true, cell: (row) => shown(row, row.allowed) },
      { title: 'Nominal', number: true, cell: (row) => shown(row, row.nominal) },
      { title: 'Bounds', full: 'The larger of the two bound analyses', number: true, cell: (row) => shown(row, row.bound) },
      ...(isDrawn
        ? [
            { title: '95\u202f% of draws', number: true, cell: (row) => shown(row, row.p95) },
            { title: 'Kept by', full: 'Share of the draws that keep the limit', number: true, cell: (row) => shareText(row.kept) },
          ]
        : []),
      { title: 'Verdict', full: 'What breaks the limit: the nominal building, a bound analysis or the draws', cell: verdictOf },
    ],
    rows,
    'Limits of the building',
    { sorts: false },
  );
}

function warnings() {
  return element(
    'div',
    { class: 'warnings' },
    element('h3', {}, study.findings.some(({ severity }) => severity === 'note') ? 'Warnings and notes' : study.warnings.length === 1 ? 'A warning' : 'Warnings'),
    ...shortList(study.warnings.map((text) => element('li', {}, sentence(text))), 4, 3),
  );
}
