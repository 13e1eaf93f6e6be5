import { choose, chosen, lawBoxes } from '../choice.js';
import { element } from '../dom.js';
import { LEGEND, dashOf } from '../plotting.js';
import { fixed, plain } from '../text.js';
import { laws, placeChooser, study } from './study.js';
import { KN, LOOP_HOVER, MM, decimalsIn, hovered } from '../units.js';

const shown = () => laws.filter((law) => chosen.laws.has(law.index));
const of = (law) => law.histories[chosen.motion];
const lines = (look, x, y, hover) =>
  shown().map((law, i) => ({
    name: law.name, mode: 'lines', x: x(of(law)), y: y(of(law)), line: { color: look.law(law), width: 1.3, dash: dashOf(i) },
    hovertemplate: hover + '<extra>' + plain(law.name) + '</extra>',
  }));
const several = () => study.motions[chosen.motion].components === 2;
const DEPENDS = ['motion', 'laws', 'axis'];
const layout = (x, y, more = {}) => ({
  showlegend: shown().length > 1, legend: LEGEND, margin: { l: 60, r: 12, t: shown().length > 1 ? 30 : 10, b: 44 }, xaxis: { title: x, ...more.xaxis }, yaxis: { title: y, ...more.yaxis },
});

export const historySection = {
  id: 'history',
  title: 'Histories and loops',
  short: 'Histories',
  controls,
  figures: [
    {
      id: 'history',
      title: 'Displacement of the centre',
      depends: DEPENDS,
      caption: () =>
        study.motions[chosen.motion].name + ', along ' + chosen.axis + ': the nominal building, without draws' +
        (shown().length > 0 ? '; at most ' + shown().map((law) => fixed(largest(law), decimalsIn('mm', 0)) + ' ' + MM + ' (' + law.name + ')').join(', ') + ' in any direction.' : '. Choose a law above.'),
      csv,
      height: () => 300,
      draw: (look) => ({
        traces: lines(look, (h) => h.x_mm.map((_, i) => i * h.step_s), (h) => h[chosen.axis + '_mm'], '%{x:.2f} s, ' + hovered('y', 'mm', 1)),
        layout: layout('time [s]', chosen.axis + ' [' + MM + ']'),
      }),
    },
    {
      id: 'loop',
      title: 'Loop of all bearings',
      width: 'half',
      depends: DEPENDS,
      caption: () => 'Sum of the bearings\u2019 forces over the displacement of the centre, along ' + chosen.axis + '.',
      csv,
      height: () => 380,
      draw: (look) => ({
        traces: lines(look, (h) => h[chosen.axis + '_mm'], (h) => h['shear_' + chosen.axis + '_kN'], LOOP_HOVER),
        layout: layout('displacement of the centre [' + MM + ']', 'force [' + KN + ']'),
      }),
    },
    {
      id: 'orbit',
      title: 'The centre in plan',
      width: 'half',
      depends: DEPENDS,
      caption: () => (several() ? 'Path of the centre of mass of the base.' : 'The motion has one component.'),
      csv,
      height: () => 380,
      draw: (look) => ({
        traces: lines(look, (h) => h.x_mm, (h) => h.y_mm, hovered('x', 'mm', 1) + ', ' + hovered('y', 'mm', 1)),
        layout: layout('x [' + MM + ']', 'y [' + MM + ']', { yaxis: { scaleanchor: 'x' } }),
      }),
    },
    {
      id: 'spectra',
      title: 'Floor spectra',
      depends: ['laws'],
      caption: () => 'Acceleration of equipment, by its period, on the roof (solid) and on the base (dotted): 5\u202f% damped pseudo-acceleration of the nominal building, mean over the motions.',
      csv: () => ({
        columns: ['law', 'period [s]', ...shown().slice(0, 1).flatMap((law) => law.floor_spectra.floors_g.map((_, floor) => (floor === 0 ? 'base' : 'floor ' + floor) + ' [g]'))],
        rows: shown().flatMap((law) => law.floor_spectra.periods_s.map((period, i) => [law.id, period, ...law.floor_spectra.floors_g.map((floor) => floor[i])])),
      }),
      height: () => 320,
      draw: (look) => ({
        traces: shown().flatMap((law) => {
          const { periods_s: x, floors_g: floors } = law.floor_spectra;
          return [['roof', floors.length - 1, 'solid'], ['base', 0, 'dot']].slice(0, floors.length > 1 ? 2 : 1).map(([place, floor, dash]) => ({
            name: law.name + ', ' + place, mode: 'lines', x, y: floors[floor], line: { color: look.law(law), width: 1.5, dash },
            hovertemplate: '%{x:.2f} s, %{y:.3f} g<extra>' + plain(law.name) + ', ' + place + '</extra>',
          }));
        }),
        layout: layout('period [s]', 'pseudo-acceleration [g]', { xaxis: { type: 'log' }, yaxis: { rangemode: 'tozero' } }),
      }),
    },
  ],
};

const largest = (law) => of(law).x_mm.reduce((most, x, i) => Math.max(most, Math.hypot(x, of(law).y_mm[i])), 0);

function controls() {
  const axes = ['x', 'y'].map((axis) =>
    element('label', {}, element('input', { type: 'radio', name: 'axis', value: axis, checked: chosen.axis === axis, change: () => choose({ axis }) }), axis),
  );
  return [
    placeChooser('motion', 'Motion', study.motions.map(({ name }) => name), 'motion'),
    element('fieldset', {}, element('legend', {}, 'Along'), axes),
    ...(laws.length > 1 ? [lawBoxes(laws)] : []),
  ];
}

function csv() {
  return {
    columns: ['law', 'time [s]', 'x [' + MM + ']', 'y [' + MM + ']', 'force x [' + KN + ']', 'force y [' + KN + ']'],
    rows: shown().flatMap((law) => {
      const h = of(law);
      return h.x_mm.map((x, i) => [law.id, i * h.step_s, x, h.y_mm[i], h.shear_x_kN[i], h.shear_y_kN[i]]);
    }),
  };
}
