import { choose, chosen } from '../choice.js';
import { tableOf } from '../tables.js';
import { atTheHead, isNumber, mean, plain, rangeText, shareText, unitText } from '../text.js';
import { LEGEND } from '../plotting.js';
import { nameOf, outline, wayOf } from './motion.js';
import { isDrawn, laws, nameAndUnit, numberText, placeChooser, quantityOf, study, unitOf } from './study.js';
import { KN, LOOP_HOVER, MM } from '../units.js';

const KINDS = { draw: ['draw of the lot', 'circle'], lot: ['law of the lot', 'square'], lower: ['lower bound', 'triangle-down'], upper: ['upper bound', 'triangle-up'] };
const kindOf = ({ is }) => (Object.hasOwn(KINDS, is) ? KINDS[is] : ['tested device', 'diamond']);
const LEAST_CONTRAST = 0.05; // the range of colours is at least mean +- this share of the mean
const TWISTS = ['corner_over_centre', 'corner_mm', 'centre_mm', 'rotation_mrad', 'worst_energy_share'];

export const planSection = {
  id: 'plan',
  title: 'Plan and torsion',
  short: 'Plan',
  controls: () => [
    ...(laws.length > 1 ? [placeChooser('law-of-plan', 'Law', laws.map((law) => law.name), 'law')] : []),
    placeChooser('bearing', 'Bearing', study.plan.bearings.map(nameOf), 'bearing'),
  ],
  figures: [
    { id: 'plan', title: 'Bearings in plan', width: 'wide', depends: ['law', 'bearing'], caption, csv: planData, clicked: ({ customdata }) => customdata !== undefined && choose({ bearing: customdata }), height: (width) => Math.min(460, 120 + 0.62 * width), draw: plan },
    {
      id: 'torsion',
      title: 'Torsion',
      width: 'narrow',
      depends: ['law'],
      caption: () => 'Means over the motions.' + (isDrawn ? ' Nominal: without draws; any excess of the draws comes from unequal devices.' : ''),
      csv: () => ({
        columns: ['law', 'quantity', 'unit', 'nominal', 'p50', 'p95'],
        rows: laws.flatMap((law) => TWISTS.map((key) => [law.id, ...nameAndUnit(key), ...['nominal', 'p50', 'p95'].map((of) => law.quantities[key][of])])),
      }),
      build: torsion,
    },
    {
      id: 'loops',
      title: 'Loop of a bearing',
      depends: ['law', 'bearing'],
      caption: () =>
        nameOf(study.plan.bearings[chosen.bearing], chosen.bearing) + ', ' + laws[chosen.law].name + ', under ' + study.motions[laws[chosen.law].loops.motion].name + ', ' +
        (laws[chosen.law].loops.of === 'nominal' ? 'of the nominal building' : 'of the first building drawn') + '. For another bearing, click on it in the plan or choose it above.',
      csv: loopData,
      height: () => 380,
      draw: loop,
    },
  ],
};

function loop(look) {
  const law = laws[chosen.law],
    way = wayOf(law, study.plan.bearings[chosen.bearing]),
    force = law.loops.bearings[chosen.bearing];
  const axes = study.motions[law.loops.motion].components === 2 ? ['x', 'y'] : ['x'];
  return {
    traces: axes.map((axis, i) => ({
      name: 'along ' + axis, mode: 'lines', x: way[axis], y: force[axis + '_kN'], line: { color: look.colour(i === 0 ? 'accent' : 'muted'), width: 1.4 },
      hovertemplate: LOOP_HOVER + '<extra>along ' + axis + '</extra>',
    })),
    layout: {
      showlegend: axes.length > 1, legend: LEGEND, margin: { l: 60, r: 12, t: axes.length > 1 ? 30 : 10, b: 44 },
      xaxis: { title: 'displacement of the bearing [' + MM + ']' }, yaxis: { title: 'force [' + KN + ']' },
    },
  };
}

function loopData() {
  const law = laws[chosen.law],
    way = wayOf(law, study.plan.bearings[chosen.bearing]),
    force = law.loops.bearings[chosen.bearing];
  return {
    columns: ['time [s]', 'x [' + MM + ']', 'y [' + MM + ']', 'force x [' + KN + ']', 'force y [' + KN + ']'],
    rows: way.x.map((x, i) => [i * law.loops.step_s, x, way.y[i], force.x_kN[i], force.y_kN[i]]),
  };
}

function caption() {
  const moved = laws[chosen.law].bearings.displacement_mm.filter(isNumber);
  return (
    laws[chosen.law].name + ': averaged over ' + (isDrawn ? 'draws and ' : '') + 'motions, bearings move ' +
    (moved.length > 0 ? rangeText([Math.min(...moved), Math.max(...moved)], MM) : 'an unknown way, since too few analyses have numbers') + ' (stronger colour: more). Cross: centre of mass; line: the slab.'
  );
}

function plan(look) {
  const { bearings, centre } = study.plan;
  const moved = laws[chosen.law].bearings.displacement_mm,
    share = laws[chosen.law].bearings.energy_share;
  // The range of colours has a minimum width, so that values that differ by only a percent get almost the same colour.
  const usual = mean(moved),
    most = Math.max(LEAST_CONTRAST * usual, ...moved.map((mm) => Math.abs(mm - usual)));
  const round = outline();
  const kinds = [...new Set(bearings.map((bearing) => kindOf(bearing)[0]))];
  return {
    traces: [
      { name: 'slab', mode: 'lines', x: round.map(({ x_m }) => x_m), y: round.map(({ y_m }) => y_m), line: { color: look.colour('muted'), width: 1.2 }, hoverinfo: 'skip', showlegend: false },
      ...kinds.map((kind) => {
        const some = bearings.map((bearing, i) => ({ ...bearing, i })).filter((bearing) => kindOf(bearing)[0] === kind);
        return {
          name: kind, mode: 'markers', x: some.map(({ x_m: x }) => x), y: some.map(({ y_m: y }) => y), customdata: some.map(({ i }) => i),
          marker: {
            symbol: kindOf(some[0])[1], size: 15, color: some.map(({ i }) => 0.5 + (0.5 * (moved[i] - usual)) / most), cmin: 0, cmax: 1,
            colorscale: [[0, look.colour('grid')], [1, look.colour('accent')]], line: { color: some.map(({ i }) => look.colour(i === chosen.bearing ? 'ink' : 'accent')), width: some.map(({ i }) => (i === chosen.bearing ? 3 : 1)) },
          },
          text: some.map(({ is, i }) => plain(is) + '<br>' + numberText(moved[i]) + ' ' + MM + ', ' + shareText(share[i]) + ' of the work'),
          hovertemplate: '%{text}<extra></extra>',
        };
      }),
      {
        name: 'centre of mass', mode: 'markers', x: [centre.x_m], y: [centre.y_m], showlegend: false,
        marker: { symbol: 'cross-thin', size: 13, line: { color: look.colour('ink'), width: 2 } }, hovertemplate: 'centre of mass<extra></extra>',
      },
    ],
    layout: {
      showlegend: true,
      margin: { l: 54, r: 12, t: 30, b: 44 },
      xaxis: { title: 'x [m]', zeroline: false },
      yaxis: { title: 'y [m]', zeroline: false, scaleanchor: 'x' },
    },
  };
}

function torsion() {
  const of = laws[chosen.law].quantities;
  return tableOf(
    [
      { title: 'Quantity', cell: (key) => atTheHead(quantityOf(key).title) + (unitOf(quantityOf(key)) ? ' [' + unitText(quantityOf(key).unit) + ']' : '') },
      { title: 'Nominal', number: true, cell: (key) => numberText(of[key].nominal) },
      ...(isDrawn
        ? [
            { title: 'Median', number: true, cell: (key) => numberText(of[key].p50) },
            { title: '95\u202f%', number: true, cell: (key) => numberText(of[key].p95) },
          ]
        : []),
    ],
    TWISTS,
    'Torsion of the building',
    { sorts: false },
  );
}

function planData() {
  return {
    columns: ['x [m]', 'y [m]', 'is', ...laws.flatMap((law) => [law.id + ': displacement [' + MM + ']', law.id + ': share of the work'])],
    rows: study.plan.bearings.map((bearing, i) => [
      bearing.x_m, bearing.y_m, bearing.is, ...laws.flatMap((law) => [law.bearings.displacement_mm[i], law.bearings.energy_share[i]]),
    ]),
  };
}
