import { chosen } from '../choice.js';
import { emptyPlot } from '../plotting.js';
import { laws } from '../report.js';
import { atTheHead, fixed, plain } from '../text.js';
import { KN, LOOP_HOVER, MM } from '../units.js';
import { conditions, factorText, referenceCycle, statusWord } from './data.js';

const all = conditions?.bounds.length > 0 ? (conditions.bound_laws ?? []) : [];
const SIDES = ['upper', 'lower'];
const law = () => laws[chosen.law] ?? laws[0];
const shown = () => all.find((of) => of.law === law().id);
const isThere = (of) => of && !of.obstacle;

// The reason why no law has bounds over the design conditions; empty if at least one law has them.
export const obstacle = all.some(isThere) ? '' : (all[0]?.obstacle ?? '');

export const boundLawsFigure = {
  id: 'bound-laws',
  title: 'The law over the design conditions',
  width: 'half',
  depends: ['law'],
  wanted: () => all.some(isThere),
  caption,
  csv: boundLawData,
  height: () => 340,
  draw: drawBoundLaws,
};

function lawText(side) {
  const bound = shown()[side];
  const times = (factor) => '\u00d7\u202f' + factorText(factor);
  const how = bound.one_factor
    ? 'the whole force ' + times(bound.elastic_factor) + ', so that its energy is off by ' + fixed(bound.energy_off_percent, 1) + '\u202f%'
    : 'elastic part ' + times(bound.elastic_factor) + ', hysteretic part ' + times(bound.hysteretic_factor);
  return atTheHead(side) + ' bound law (' + statusWord(bound.status) + '): ' + how + '.';
}

function caption() {
  const of = shown();
  if (!isThere(of)) return '';
  return law().name + ' of ' + (of.device ?? 'the lot') + ', ' + referenceCycle() + '; grey: reference tests. ' + SIDES.map(lawText).join(' ');
}

function boundLawData() {
  return {
    columns: ['law', 'device', 'displacement [' + MM + ']', 'force [' + KN + ']', ...SIDES.map((side) => side + ' bound [' + KN + ']')],
    rows: all.filter(isThere).flatMap((of) =>
      of.disp_mm.map((value, i) => [of.law, of.device ?? 'lot', value, of.force_kN[i], ...SIDES.map((side) => of[side].force_kN[i])]),
    ),
  };
}

function drawBoundLaws(look) {
  const of = shown();
  if (!isThere(of)) return emptyPlot(look, of?.obstacle ?? 'This law has no fit here.');
  const measured = conditions.tests.filter((test) => test.role === 'reference');
  const line = (name, x, y, style) => ({ name, mode: 'lines', x, y, line: style, hovertemplate: LOOP_HOVER + '<extra>' + plain(name) + '</extra>' });
  return {
    traces: [
      line('reference tests', measured.flatMap((test) => [...test.loop_mm, null]), measured.flatMap((test) => [...test.loop_kN, null]), {
        color: look.colour('measured'), width: 1,
      }),
      line(law().name, of.disp_mm, of.force_kN, { color: look.law(law()), width: 2.2 }),
      line('upper bound', of.disp_mm, of.upper.force_kN, { color: look.colour('ink'), width: 1.4 }),
      line('lower bound', of.disp_mm, of.lower.force_kN, { color: look.colour('ink'), width: 1.4, dash: 'dash' }),
    ],
    layout: {
      showlegend: true,
      margin: { l: 58, r: 12, t: 36, b: 44 },
      xaxis: { title: 'displacement [' + MM + ']' },
      yaxis: { title: 'force [' + KN + ']' },
    },
  };
}
