import { chosen } from '../choice.js';
import { symbolOf } from '../plotting.js';
import { tableOf } from '../tables.js';
import { DASH, fixed, isNumber, plain, shareText } from '../text.js';
import { spanOf } from './histogram.js';
import { axisTitle, isDrawn, laws, nameAndUnit, quantityChooser, quantityOf, spreadText, study } from './study.js';

export const lawsSection = {
  id: 'laws',
  title: 'Law against law',
  controls: () => (isDrawn && laws.length > 1 ? [quantityChooser('quantity-of-laws')] : []),
  figures: [
    {
      id: 'laws',
      title: 'The same building by each law',
      width: 'half',
      depends: ['quantity'],
      wanted: () => isDrawn && laws.length > 1,
      caption: () =>
        'Thick line: 16 to 84\u202f% of the draws; mark: median; end of the line: 95\u202f%. Grey: between the two bound analyses.' +
        (chosen.quantity === 'isolator_mm' && study.law_std_ln !== null ? ' Medians differ by ' + spreadText(study.law_std_ln) + ' between laws.' : ''),
      csv: () => ({
        columns: ['law', 'quantity', 'unit', 'lower', 'nominal', 'upper', 'p16', 'p50', 'p84', 'p95'],
        rows: laws.map((law) => [law.id, ...nameAndUnit(chosen.quantity), ...['lower', 'nominal', 'upper', 'p16', 'p50', 'p84', 'p95'].map((key) => law.quantities[chosen.quantity][key])]),
      }),
      height: () => 80 + 54 * laws.length,
      draw,
    },
    {
      id: 'coverage',
      title: 'What the bounds cover',
      width: 'half',
      wanted: () => isDrawn,
      caption: () =>
        'Share of the buildings between the bound analyses, its 95\u202f% interval, and the narrowest factors on forces that would cover ' +
        Math.round(100 * study.enough) + '\u202f% (in steps of 2\u202f%).',
      csv: () => ({
        columns: ['law', 'quantity', 'inside', 'interval lower', 'interval upper', 'below', 'above', 'factor lower', 'factor upper'],
        rows: covered().map(({ law, key, of }) => [law.id, quantityOf(key).title, of.inside, of.lower, of.upper, of.below, of.above, of.factor_low, of.factor_high]),
      }),
      build: coverage,
    },
  ],
};

const covered = () => laws.flatMap((law) => Object.entries(law.coverage.of).map(([key, of]) => ({ law, key, of })));

function coverage() {
  return tableOf(
    [
      { title: 'Law', cell: ({ law }) => law.name },
      { title: 'Quantity', cell: ({ key }) => quantityOf(key).title },
      { title: 'Inside', number: true, cell: ({ of }) => shareText(of.inside) },
      { title: 'Interval', number: true, cell: ({ of }) => fixed(100 * of.lower, 0) + ' to ' + fixed(100 * of.upper, 0) + '\u202f%' },
      { title: 'Below', number: true, cell: ({ of }) => shareText(of.below) },
      { title: 'Above', number: true, cell: ({ of }) => shareText(of.above) },
      { title: 'Factors', number: true, cell: ({ of }) => (isNumber(of.factor_low) ? fixed(of.factor_low, 2) + ', ' + fixed(of.factor_high, 2) : DASH) },
    ],
    covered(),
    'Coverage of the bound analyses',
  );
}

function draw(look) {
  const key = chosen.quantity;
  const place = (i) => laws.length - 1 - i;
  const line = (law, i, from, to, colour, width) => ({
    mode: 'lines', x: [from, to], y: [place(i), place(i)], line: { color: colour, width }, hoverinfo: 'skip',
  });
  const traces = laws.flatMap((law, i) => {
    const of = law.quantities[key];
    return [
      line(law, i, of.lower, of.upper, look.colour('rule'), 16),
      line(law, i, of.p16, of.p95, look.law(law), 1.6),
      line(law, i, of.p16, of.p84, look.law(law), 6),
      {
        mode: 'markers', x: [of.p50, of.p95], y: [place(i), place(i)],
        marker: { color: look.law(law), symbol: [symbolOf(law), 'line-ns'], size: 11, line: { color: look.law(law), width: [1, 2] } },
        hovertemplate: '%{x:.4g}<extra>' + plain(law.name) + '</extra>',
      },
    ];
  });
  return {
    traces,
    layout: {
      xaxis: { title: axisTitle(quantityOf(key)), range: spanOf(laws, key) },
      yaxis: {
        tickmode: 'array', tickvals: laws.map((_, i) => place(i)), ticktext: laws.map((law) => plain(law.name)), range: [-0.6, laws.length - 0.4],
        showgrid: false, zeroline: false,
      },
    },
  };
}
