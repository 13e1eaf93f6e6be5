// Shows the building in motion. One figure is the plan with the slab and the bearings at a moment, the other the loop
// of one bearing with a dot at the same moment. A slider and a button "Play" change the moment.
import { choose, chosen, onChoice } from '../choice.js';
import { button, element } from '../dom.js';
import { drawn } from '../figure.js';
import { fixed, plain } from '../text.js';
import { KN, LOOP_HOVER, MM, decimalsIn, inUnits } from '../units.js';
import { first, numberText, study } from './study.js';

const SHOWN_SHARE = 0.07; // the largest displacement is drawn as this share of the plan's size
const { loops } = first,
  { bearings, corners, centre } = study.plan,
  MM_IN_M = inUnits(1e3, 'mm');

export const nameOf = ({ x_m: x, y_m: y }, i) => 'Bearing ' + (i + 1) + ' at ' + numberText(x) + ', ' + numberText(y) + ' m';

// Returns the displacement over time of a point of the plan, computed from displacement and rotation of the base's
// centre of mass.
export function wayOf(law, { x_m, y_m }) {
  const { x_mm: x, y_mm: y, rotation_rad: turned } = law.loops;
  const dx = MM_IN_M * (x_m - centre.x_m),
    dy = MM_IN_M * (y_m - centre.y_m);
  return { x: x.map((mm, i) => mm - dy * turned[i]), y: y.map((mm, i) => mm + dx * turned[i]) };
}

// Returns the corners of the slab in the order of its outline. The first corner is repeated at the end.
export function outline() {
  const middle = ['x_m', 'y_m'].map((axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length);
  const angle = ({ x_m, y_m }) => Math.atan2(y_m - middle[1], x_m - middle[0]);
  const round = [...corners].sort((a, b) => angle(a) - angle(b));
  return [...round, round[0]];
}

const bearingWays = bearings.map((bearing) => wayOf(first, bearing)),
  outlineWays = outline().map((corner) => ({ corner, way: wayOf(first, corner) }));
const moved = bearingWays.map(({ x, y }) => x.map((_, i) => Math.hypot(x[i], y[i]))),
  farthest = Math.max(...moved.flat()),
  size = Math.max(...['x_m', 'y_m'].map((axis) => Math.max(...corners.map((one) => one[axis])) - Math.min(...corners.map((one) => one[axis])))),
  scale = farthest > 0 ? (SHOWN_SHARE * size) / farthest : 0;
const last = loops.x_mm.length - 1;
let now = moved.length > 0 ? moved.reduce((best, way) => Math.max(...way) > Math.max(...best) ? way : best).indexOf(farthest) : 0;

export const motionFigures = [
  {
    id: 'moving',
    title: 'The base in motion',
    width: 'half',
    depends: ['bearing'],
    wanted: () => last > 0,
    caption: () =>
      study.motions[loops.motion].name + ', ' + (loops.of === 'nominal' ? 'nominal building' : 'first draw') + ', moved ' +
      numberText(scale * MM_IN_M) + ' times as far. Click a bearing for its loop.',
    clicked: ({ customdata }) => customdata !== undefined && choose({ bearing: customdata }),
    height: () => 300,
    draw: plan,
    below: slider,
  },
  {
    id: 'moving-loop',
    title: 'Loop of a bearing',
    width: 'half',
    depends: ['bearing'],
    wanted: () => last > 0,
    caption: () => nameOf(bearings[chosen.bearing], chosen.bearing) + ', ' + first.name + ', along ' + axis() + '.',
    height: () => 300,
    draw: loop,
  },
];

// Returns the axis, 'x' or 'y', along which the chosen bearing moves farther.
function axis() {
  const largest = (way) => way.reduce((most, mm) => Math.max(most, Math.abs(mm)), 0);
  const { x, y } = bearingWays[chosen.bearing];
  return largest(x) >= largest(y) ? 'x' : 'y';
}

const shifted = ({ x_m, y_m }, { x, y }) => [x_m + scale * x[now], y_m + scale * y[now]];
const place = () => ({ outline: outlineWays.map(({ corner, way }) => shifted(corner, way)), bearings: bearings.map((bearing, i) => shifted(bearing, bearingWays[i])), size: moved.map((way) => way[now]) });

function plan(look) {
  const at = place(),
    x = (points) => points.map(([first]) => first),
    y = (points) => points.map(([, second]) => second);
  const room = 0.6 * size * SHOWN_SHARE + 1.2 * scale * farthest;
  const range = (name) => [Math.min(...corners.map((one) => one[name])) - room, Math.max(...corners.map((one) => one[name])) + room];
  return {
    traces: [
      { mode: 'lines', x: outline().map(({ x_m }) => x_m), y: outline().map(({ y_m }) => y_m), line: { color: look.colour('rule'), width: 1, dash: 'dot' }, hoverinfo: 'skip' },
      { mode: 'markers', x: bearings.map(({ x_m }) => x_m), y: bearings.map(({ y_m }) => y_m), marker: { symbol: 'cross-thin', size: 7, line: { color: look.colour('muted'), width: 1 } }, hoverinfo: 'skip' },
      { mode: 'lines', x: x(at.outline), y: y(at.outline), line: { color: look.colour('ink'), width: 1.6 }, hoverinfo: 'skip' },
      {
        mode: 'markers', x: x(at.bearings), y: y(at.bearings), customdata: bearings.map((_, i) => i),
        marker: {
          size: 12, color: at.size, cmin: 0, cmax: farthest, colorscale: [[0, look.colour('grid')], [1, look.colour('accent')]],
          line: { color: bearings.map((_, i) => look.colour(i === chosen.bearing ? 'ink' : 'accent')), width: bearings.map((_, i) => (i === chosen.bearing ? 3 : 1)) },
          colorbar: { thickness: 9, len: 0.9, outlinewidth: 0, title: { text: MM, side: 'top' }, tickfont: { size: 11 } },
        },
        text: bearings.map((bearing, i) => plain(nameOf(bearing, i)) + '<br>at most ' + numberText(Math.max(...moved[i])) + ' ' + MM),
        hovertemplate: '%{text}<extra></extra>',
      },
    ],
    layout: {
      margin: { l: 54, r: 12, t: 10, b: 44 },
      xaxis: { title: 'x [m]', zeroline: false, range: range('x_m') },
      yaxis: { title: 'y [m]', zeroline: false, range: range('y_m'), scaleanchor: 'x' },
    },
  };
}

const loopOf = () => ({ x: bearingWays[chosen.bearing][axis()], force: loops.bearings[chosen.bearing][axis() + '_kN'] });

function loop(look) {
  const { x, force } = loopOf();
  return {
    traces: [
      { mode: 'lines', x, y: force, line: { color: look.law(first), width: 1.4 }, hovertemplate: LOOP_HOVER + '<extra></extra>' },
      { mode: 'markers', x: [x[now]], y: [force[now]], hoverinfo: 'skip', marker: { size: 11, color: look.colour('paper'), line: { width: 2, color: look.colour('ink') } } },
    ],
    layout: { margin: { l: 60, r: 12, t: 10, b: 44 }, xaxis: { title: 'displacement [' + MM + ']' }, yaxis: { title: 'force [' + KN + ']' } },
  };
}

// Redraws the slab, the bearings and the dot on the loop as they are at the moment `now`.
function move() {
  const [inPlan, inLoop] = motionFigures.map((figure) => drawn.get(figure)?.body);
  const at = place();
  const columns = (points) => [0, 1].map((i) => points.map((point) => point[i]));
  const [ox, oy] = columns(at.outline),
    [bx, by] = columns(at.bearings);
  if (inPlan?.data) Plotly.restyle(inPlan, { x: [ox, bx], y: [oy, by], 'marker.color': [null, at.size] }, [2, 3]);
  const { x, force } = loopOf();
  if (inLoop?.data) Plotly.restyle(inLoop, { x: [[x[now]]], y: [[force[now]]] }, [1]);
}

function slider() {
  const output = element('output', { for: 'moment' });
  const input = element('input', { type: 'range', id: 'moment', min: 0, max: last, value: now });
  const play = button('Play', () => (started === null ? start() : stop()), { class: 'action', id: 'play' });
  // The time on the clock of requestAnimationFrame that corresponds to time 0 of the motion. Null while the motion
  // stands still.
  let started = null;
  const say = () => {
    output.textContent = fixed(now * loops.step_s, 2) + '\u202fs, ' + nameOf(bearings[chosen.bearing], chosen.bearing) + ': ' + fixed(moved[chosen.bearing][now], decimalsIn('mm', 1)) + '\u202f' + MM;
  };
  const show = (moment) => {
    now = moment;
    input.value = now;
    move();
    say();
  };
  const stop = () => {
    started = null;
    play.textContent = 'Play';
  };
  const start = () => {
    if (now >= last) now = 0;
    started = performance.now() - 1e3 * now * loops.step_s;
    play.textContent = 'Pause';
    requestAnimationFrame(frame);
  };
  function frame(time) {
    if (started === null) return;
    show(Math.min(last, Math.max(0, Math.round((time - started) / (1e3 * loops.step_s)))));
    if (now >= last) stop();
    else requestAnimationFrame(frame);
  }
  input.oninput = () => {
    stop();
    show(Number(input.value));
  };
  onChoice(say);
  say();
  return element('div', { class: 'time screen' }, element('label', {}, 'Time', input), play, output);
}
