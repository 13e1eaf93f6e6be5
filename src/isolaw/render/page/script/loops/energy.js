import { chosen } from '../choice.js';
import { counted, noCycles } from '../cycles.js';
import { emptyPlot, namedAxis, symbolOf } from '../plotting.js';
import { rawTime } from '../raw.js';
import { THIN, enumerate, fixed, isNumber, plain, signed } from '../text.js';
import { LOOP_HEIGHT, shownLoops } from './fits.js';
import { KN_MM, decimalsIn, hovered } from '../units.js';

export const energyFigure = {
  id: 'loop-energy',
  title: 'Energy dissipated per cycle',
  depends: ['device', 'laws'],
  wanted: () => chosen.device !== null,
  caption: energyCaption,
  csv: energyData,
  height: () => 0.8 * LOOP_HEIGHT,
  draw: drawEnergy,
};

// Returns the work of the drawn force between two times, which may lie between samples. Returns null if the record does
// not reach the two times.
function energy({ t, x }, F, from, to) {
  const spare = 1.5 * (t[1] - t[0]);
  if (from < t[0] - spare || to > t[t.length - 1] + spare) return null;
  const at = (values, time) => {
    const found = t.findIndex((other) => other >= time);
    const after = found < 0 ? t.length - 1 : Math.max(1, found),
      before = after - 1,
      share = Math.min(1, Math.max(0, (time - t[before]) / (t[after] - t[before])));
    return values[before] + share * (values[after] - values[before]);
  };
  let sum = 0,
    [lastX, lastF] = [at(x, from), at(F, from)];
  const add = (nextX, nextF) => {
    sum += 0.5 * (lastF + nextF) * (nextX - lastX);
    [lastX, lastF] = [nextX, nextF];
  };
  t.forEach((time, i) => time > from && time < to && add(x[i], F[i]));
  add(at(x, to), at(F, to));
  return sum;
}

function energies() {
  const { device, measured: curves, fits } = shownLoops();
  const time = rawTime(device);
  const cycles = device.blocks
    .flatMap((block) => counted(block).map((cycle) => ({ block, cycle })))
    .map(({ block, cycle }) => {
      const of = (F) => energy(curves, F, time.of(cycle.first), time.of(cycle.last));
      return { block, cycle, measured: of(curves.F), computed: fits.map(({ force }) => of(force)) };
    })
    .filter(({ measured }) => isNumber(measured) && measured !== 0);
  return { device, fits, cycles };
}

function totalError(cycles, place) {
  const measured = cycles.reduce((sum, one) => sum + one.measured, 0);
  return 100 * (cycles.reduce((sum, one) => sum + one.computed[place], 0) / measured - 1);
}

// The axis ends at twice the largest measured energy, so that one law with huge forces does not flatten all others.
const highest = (cycles) => 2 * Math.max(...cycles.map(({ measured }) => measured));
const runsAway = (cycles, place) => cycles.some(({ computed }) => computed[place] > highest(cycles));

function energyCaption() {
  const { device, fits, cycles } = energies();
  if (cycles.length === 0) return device.name + ' has no cycle to compare: ' + noCycles(device) + '.';
  const said = fits.map(({ law }, place) => law.name + ' ' + signed(totalError(cycles, place), 1) + THIN + '%');
  const away = fits.filter((_, place) => runsAway(cycles, place)).map(({ law }) => law.name);
  return (
    'Energy of each cycle: area of the measured loop (bars) and of the best fits\u2019 loops (markers), from the samples drawn.' +
    (said.length > 0 ? ' Energy error of the laws over all cycles: ' + said.join(', ') + '.' : '') +
    ' If bars fall from cycle to cycle and markers stay level, the device scrags and the law does not model it.' +
    (away.length > 0 ? ' Off the scale: ' + enumerate(away) + '.' : '')
  );
}

function energyData() {
  const { fits, cycles } = energies();
  return {
    columns: ['block', 'cycle', 'measured energy [' + KN_MM + ']', ...fits.map(({ law }) => law.name + ' energy [' + KN_MM + ']')],
    rows: cycles.map(({ block, cycle, measured, computed }) => [block.number, cycle.number, measured, ...computed]),
  };
}

function drawEnergy(look, width) {
  const { device, fits, cycles } = energies();
  if (cycles.length === 0) return emptyPlot(look, noCycles(device));
  const several = device.blocks.length > 1;
  const names = cycles.map(({ block, cycle }) => (several ? block.number + '.' : '') + cycle.number);
  const x = cycles.map((_, i) => i),
    places = names.map((name) => (several ? 'block.cycle ' : 'cycle ') + name);
  const against = (value, measured) => ' (' + signed(100 * (value / measured - 1), 1) + '%)';
  return {
    traces: [
      {
        type: 'bar', name: 'measured', x, y: cycles.map(({ measured }) => measured), width: 0.7, opacity: 0.75,
        marker: { color: look.colour('measured') }, customdata: places,
        hovertemplate: '%{customdata}: ' + hovered('y', 'kN mm', 0) + '<extra>measured</extra>',
      },
      ...fits.map(({ law }, place) => ({
        name: plain(law.name), mode: 'markers', y: cycles.map(({ computed }) => computed[place]),
        // Markers at the same place would hide one another, so they are side by side.
        x: x.map((value) => value + (0.5 * (place + 1)) / (fits.length + 1) - 0.25),
        marker: { color: look.law(law), symbol: symbolOf(law), size: 8, line: { color: look.colour('paper'), width: 1 } },
        customdata: cycles.map(
          ({ measured, computed }, i) =>
            places[i] + ': ' + fixed(computed[place], decimalsIn('kN mm', 0)) + ' ' + KN_MM + against(computed[place], measured),
        ),
        hovertemplate: '%{customdata}<extra>' + plain(law.name) + '</extra>',
      })),
    ],
    layout: {
      showlegend: true,
      xaxis: { ...namedAxis(names, Math.floor(width / 30)), title: several ? 'block.cycle' : 'cycle' },
      yaxis: {
        title: 'energy [' + KN_MM + ']',
        ...(fits.some((_, place) => runsAway(cycles, place)) ? { range: [0, highest(cycles)] } : { rangemode: 'tozero' }),
      },
    },
  };
}
