import { chosen } from '../choice.js';
import { LEGEND } from '../plotting.js';
import { atTheHead, isNumber, plain } from '../text.js';
import { first, isDrawn, laws, quantityChooser, quantityOf, spreadText, study } from './study.js';

const parts = () => [
  { key: 'motion_std_ln', name: 'motions', colour: 'muted' },
  { key: 'lot_std_ln', name: 'the lot', colour: 'accent' },
  ...(first.quantities[chosen.quantity].uncertain_std_ln === null
    ? []
    : [{ key: 'uncertain_std_ln', name: 'uncertain population', colour: 'care' }]),
];

export const varianceSection = {
  id: 'variance',
  title: 'What the spread is made of',
  short: 'Variance',
  controls: () => [quantityChooser('quantity-of-variance')],
  figures: [{ id: 'variance', title: 'Parts of the spread', wanted: () => isDrawn, depends: ['quantity'], caption, csv, height: () => 130 + 62 * laws.length, draw }],
};

function caption() {
  const of = first.quantities[chosen.quantity];
  const share = Math.round(100 * of.lot_share),
    known = isNumber(of.lot_share);
  const between = study.law_std_ln;
  return (
    atTheHead(quantityOf(chosen.quantity).title) + ', ' + first.name + ': ' +
    (known
      ? 'the lot causes ' + (share < 1 ? 'less than 1' : share) + '\u202f% of the variance under single motions. '
      : 'too few draws have numbers to tell its parts. ') +
    (between === null ? '' : 'Medians of the displacement differ by ' + spreadText(between) + ' between laws. ') +
    'Bars: standard deviation of the natural logarithm.'
  );
}

const percentOf = (std) => (isNumber(std) ? 100 * std : null);

function draw(look) {
  const of = parts();
  return {
    traces: of.map(({ key, name, colour }) => ({
      type: 'bar', orientation: 'h', name, y: laws.map((law) => plain(law.name)), x: laws.map((law) => percentOf(law.quantities[chosen.quantity][key])),
      text: laws.map((law) => spreadText(law.quantities[chosen.quantity][key])), textposition: 'outside', cliponaxis: false,
      marker: { color: look.colour(colour) }, hovertemplate: '%{x:.2f} %<extra>' + name + '</extra>',
    })),
    layout: {
      ...betweenLaws(look),
      barmode: 'group', bargap: 0.3, showlegend: true, legend: { ...LEGEND, traceorder: 'normal' }, margin: { l: 54, r: 48, t: 34, b: 44 },
      xaxis: { title: 'scatter [%]', rangemode: 'tozero' },
      yaxis: { autorange: 'reversed', showgrid: false },
    },
  };
}

// Draws the scatter between laws as a line, because it belongs to no single law. It is known for the displacement only.
function betweenLaws(look) {
  if (study.law_std_ln === null || chosen.quantity !== 'isolator_mm') return {};
  const x = 100 * study.law_std_ln;
  return {
    shapes: [{ type: 'line', xref: 'x', yref: 'paper', x0: x, x1: x, y0: 0, y1: 1, line: { color: look.colour('poor'), width: 1.6, dash: 'dash' } }],
    annotations: [
      {
        xref: 'x', yref: 'paper', x, y: 0, xshift: 4, xanchor: 'left', yanchor: 'bottom', showarrow: false, text: 'laws ' + spreadText(study.law_std_ln),
        font: { size: 11.5, color: look.colour('poor') },
      },
    ],
  };
}

function csv() {
  const of = parts();
  return {
    columns: ['law', 'quantity', ...of.map(({ key }) => key), 'lot_share'],
    rows: laws.flatMap((law) =>
      study.quantities.map(({ key, title }) => [law.id, title, ...of.map((part) => law.quantities[key][part.key]), law.quantities[key].lot_share]),
    ),
  };
}
