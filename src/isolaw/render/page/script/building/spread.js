import { chosen } from '../choice.js';
import { LEGEND, namedAxis, panelHeading, symbolOf } from '../plotting.js';
import { tableOf } from '../tables.js';
import { atTheHead, plain, shareText, short, unitText } from '../text.js';
import { bars, bounds, histogramData, spanOf } from './histogram.js';
import { BOUNDS, FROM_CONDITIONS, SPREAD, axisTitle, first, grouped, isCovered, isDrawn, laws, nameAndUnit, numberText, quantityChooser, quantityOf, spreadText, study, unitOf } from './study.js';

const ROW = 150; // height in pixels for each law
const quantity = () => quantityOf(chosen.quantity);

export const spreadSection = {
  id: 'spread',
  title: 'Distributions',
  controls: () => [quantityChooser('quantity')],
  figures: [
    {
      id: 'histograms',
      title: 'Draws and bounds',
      width: 'wide',
      wanted: () => isDrawn,
      depends: ['quantity'],
      caption: () =>
        atTheHead(quantity().meaning) + '; means over the motions of ' + grouped(study.draws) +
        ' buildings. Lines: lower bound (solid), nominal (dotted), upper bound (dashed).' + FROM_CONDITIONS + ' ' + insideText(),
      csv: () => histogramData(laws, chosen.quantity),
      height: () => 60 + ROW * laws.length + (laws.length === 1 ? 110 : 0),
      draw: histograms,
    },
    {
      id: 'motions',
      title: 'Under each motion',
      width: 'narrow',
      wanted: () => isDrawn,
      depends: ['quantity'],
      caption: () => 'Marks: median of the draws; bars: 16 to 95\u202f% of them. Differences between motions do not come from the lot.',
      csv: motionData,
      height: () => 60 + Math.min(ROW * laws.length + (laws.length === 1 ? 110 : 0), 420),
      draw: motions,
    },
    {
      id: 'fractiles',
      title: 'In numbers',
      depends: ['quantity'],
      caption: () => (isDrawn ? 'Scatter: standard deviation of the natural logarithm. ' : '') + 'Factors of the bound analyses: ' + BOUNDS + '.',
      csv: allData,
      build: fractiles,
    },
  ],
};

function insideText() {
  if (!isCovered(chosen.quantity)) return 'No coverage: ' + quantity().uncovered + '.';
  const inside = laws.map((law) => law.name + ' ' + Math.round(100 * law.coverage.of[chosen.quantity].inside) + '\u202f%');
  return 'Between the bounds: ' + inside.join(', ') + '.';
}

function histograms(look) {
  const key = chosen.quantity,
    span = spanOf(laws, key),
    gap = laws.length > 1 ? 0.16 / laws.length : 0,
    height = 1 / laws.length;
  const layout = {
    margin: { l: 54, r: 12, t: 22, b: 44 }, bargap: 0, shapes: [], annotations: [],
    xaxis: { title: axisTitle(quantity()), range: span, anchor: laws.length > 1 ? 'y' + laws.length : 'y' },
  };
  const traces = laws.map((law, i) => {
    const high = 1 - i * height - gap,
      low = 1 - (i + 1) * height;
    const axis = i === 0 ? 'y' : 'y' + (i + 1);
    layout[i === 0 ? 'yaxis' : 'yaxis' + (i + 1)] = { domain: [low, high], rangemode: 'tozero', title: 'draws [%]', nticks: 4 };
    layout.shapes.push(...bounds(look, law, key, { low, high }).shapes);
    layout.annotations.push(panelHeading(look, 0, high, plain(law.name)));
    return bars(look, law, key, { yaxis: axis });
  });
  return { traces, layout };
}

function motions(look) {
  const names = study.motions.map(({ name }) => short(name, 12));
  const traces = laws.map((law, k) => {
    const of = law.quantities[chosen.quantity].by_motion;
    return {
      name: law.name, mode: 'markers', x: of.map((_, i) => i + (laws.length > 1 ? (0.5 * (k - (laws.length - 1) / 2)) / laws.length : 0)),
      y: of.map(({ p50 }) => p50),
      error_y: {
        type: 'data', symmetric: false, array: of.map(({ p95, p50 }) => p95 - p50), arrayminus: of.map(({ p16, p50 }) => p50 - p16),
        color: look.law(law), thickness: 1.6, width: 3,
      },
      marker: { color: look.law(law), symbol: symbolOf(law), size: 7 },
      hovertemplate: '%{y:.4g}<extra>' + plain(law.name) + '</extra>',
    };
  });
  return {
    traces,
    layout: {
      showlegend: laws.length > 1, legend: LEGEND, margin: { l: 54, r: 12, t: laws.length > 1 ? 30 : 10, b: 60 },
      xaxis: { ...namedAxis(names, 12), tickangle: names.some((name) => name.length > 3) ? -45 : 0 },
      yaxis: { title: axisTitle(quantity()), rangemode: 'tozero' },
    },
  };
}

const FRACTILES = [
  ['lower', 'Lower bound'], ['nominal', 'Nominal'], ['upper', 'Upper bound'],
  ...(isDrawn ? [['p16', '16\u202f%'], ['p50', '50\u202f%'], ['p84', '84\u202f%'], ['p95', '95\u202f%']] : []),
];

function fractiles() {
  const key = chosen.quantity;
  const uncertain = first.quantities[key].uncertain_std_ln !== null;
  const columns = [
    { title: 'Law', cell: (law) => law.name },
    ...FRACTILES.map(([of, title]) => ({ title, unit: unitText(unitOf(quantity())), number: true, cell: (law) => numberText(law.quantities[key][of]) })),
    ...(isCovered(key) ? [{ title: 'Inside', unit: 'of draws', number: true, cell: (law) => shareText(law.coverage.of[key].inside) }] : []),
    ...(isDrawn
      ? [
          { title: 'Scatter, motions', full: SPREAD, number: true, cell: (law) => spreadText(law.quantities[key].motion_std_ln) },
          { title: 'Scatter, lot', full: SPREAD, number: true, cell: (law) => spreadText(law.quantities[key].lot_std_ln) },
        ]
      : []),
    ...(uncertain ? [{ title: 'Scatter, tests', full: SPREAD, number: true, cell: (law) => spreadText(law.quantities[key].uncertain_std_ln) }] : []),
  ];
  return tableOf(columns, laws, 'Fractiles of ' + quantity().title);
}

function motionData() {
  return {
    columns: ['law', 'motion', 'quantity', 'unit', 'nominal', 'p16', 'p50', 'p84', 'p95'],
    rows: laws.flatMap((law) =>
      law.quantities[chosen.quantity].by_motion.map((of, i) => [law.id, study.motions[i].name, ...nameAndUnit(chosen.quantity), of.nominal, of.p16, of.p50, of.p84, of.p95]),
    ),
  };
}

function allData() {
  const keys = [...FRACTILES.map(([key]) => key), ...(isDrawn ? ['motion_std_ln', 'lot_std_ln', 'uncertain_std_ln'] : [])];
  return {
    columns: ['law', 'quantity', 'unit', ...keys],
    rows: laws.flatMap((law) => study.quantities.map(({ key }) => [law.id, ...nameAndUnit(key), ...keys.map((of) => law.quantities[key][of])])),
  };
}
