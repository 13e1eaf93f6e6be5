import { chosen, onChoice } from '../choice.js';
import { chooseDevice } from '../choosers.js';
import { reportedCycle } from '../cycles.js';
import { button, element } from '../dom.js';
import { svg } from '../element.js';
import { record } from '../loops/fits.js';
import { colourOf, paddedRange } from '../plotting.js';
import { curve, devices, drawable, headingOf, headingText, laws, report } from '../report.js';
import { THIN, isNumber, plain, signed } from '../text.js';
import { MOST_LOOPS, cyclesShown } from './loop.js';

const several = drawable.length > 1;

// A small loop for each device of the lot. A press on a loop chooses its device in all sections.
export const deviceLoopsFigure = {
  id: 'device-loops',
  title: '',
  wanted: () => several && drawable.length <= MOST_LOOPS,
  depends: ['law'],
  build: loopStrip,
};

// The devices of a lot that is too large for loops: a point for each device, by stiffness and damping.
export const devicePointsFigure = {
  id: 'device-points',
  title: 'Every device',
  wanted: () => several && drawable.length > MOST_LOOPS && pointsOf().length > 1,
  depends: ['device'],
  caption: () => 'Effective stiffness and damping of the reported cycle. Press a point to choose its device everywhere. Ringed: the device chosen; orange: devices that stand apart from the lot.',
  height: () => 300,
  draw: drawPoints,
  clicked: ({ customdata }) => chooseDevice(customdata),
};

const apartOf = ({ name }) => report.outliers.filter((one) => one.device === name);
const apartText = (device) => apartOf(device).map(said).join(', ');
const said = ({ property, percent }) => property + ' ' + signed(percent, 0) + THIN + '%';
const oneReason = (device) => apartOf(device).slice(0, 1).map(said).join(''); // a small loop has room for one reason

const WIDE = 110,
  HIGH = 60;

function outline(x, F, limits) {
  const at = (value, most, size) => ((value / most + 1) / 2) * size;
  return x.map((value, i) => (i === 0 ? 'M' : 'L') + at(value, limits.x, WIDE).toFixed(1) + ' ' + at(-F[i], limits.F, HIGH).toFixed(1)).join('');
}

// Returns one loop of a device: the last of the cycles that the large figure draws in black. Most tests end with their
// largest amplitude, so this usually is the largest loop.
function oneLoop(device) {
  const { t, x, F } = record(device),
    force = curve(laws[chosen.law]?.fitOn.get(device.index)?.force_kN),
    span = cyclesShown(device)?.at(-1);
  const places = t.map((_, i) => i).filter((i) => !span || (t[i] >= span[0] && t[i] <= span[1]));
  const of = (values) => places.map((i) => values[i]);
  return { x: of(x), F: of(F), force: force && of(force) };
}

function loopStrip() {
  const loops = drawable.map((device) => ({ device, ...oneLoop(device) }));
  const most = (key) => Math.max(...loops.flatMap((loop) => loop[key].map(Math.abs))) * 1.06 || 1;
  const limits = { x: most('x'), F: most('F') };
  const colour = laws[chosen.law] ? 'var(--' + colourOf(laws[chosen.law]) + ')' : '';
  const tiles = loops.map(({ device, x, F, force }) => {
    const apart = oneReason(device);
    const lines = [[F, 'var(--ink)'], [force, colour]].filter(([values]) => values);
    const paths = lines.map(([values, stroke]) => svg('path', { d: outline(x, values, limits), style: 'stroke: ' + stroke }));
    const drawing = svg('svg', { viewBox: `0 0 ${WIDE} ${HIGH}`, 'aria-hidden': 'true' }, ...paths);
    const tile = button('', () => chooseDevice(device.index), { class: apart ? 'tile apart' : 'tile', 'data-device': device.index });
    tile.append(drawing, element('span', {}, device.name), ...(apart ? [element('small', {}, apart)] : []));
    return tile;
  });
  const follow = () => {
    for (const tile of tiles) tile.setAttribute('aria-pressed', String(Number(tile.dataset.device) === chosen.device));
  };
  onChoice(follow);
  follow();
  const refused = devices
    .filter((device) => !drawable.includes(device))
    .map((device) => element('div', { class: 'tile refused' }, element('span', {}, device.name), element('small', {}, 'refused')));
  return element('div', { class: 'tiles', role: 'group', 'aria-label': 'Device' }, ...tiles, ...refused);
}

const pointsOf = () =>
  drawable
    .map((device) => ({ device, x: reportedCycle(device)?.K_eff_kN_per_mm, y: reportedCycle(device)?.damping_percent }))
    .filter(({ x, y }) => isNumber(x) && isNumber(y));

function drawPoints(look) {
  const points = pointsOf();
  const colour = ({ device }) => look.colour(apartOf(device).length > 0 ? 'care' : 'accent');
  return {
    traces: [
      {
        mode: 'markers', x: points.map(({ x }) => x), y: points.map(({ y }) => y), customdata: points.map(({ device }) => device.index),
        text: points.map(({ device }) => plain(device.name) + (apartText(device) ? '<br>' + plain(apartText(device)) : '')),
        hovertemplate: '<b>%{text}</b><br>%{x:.4g}, %{y:.4g}<extra></extra>',
        marker: {
          size: points.map(({ device }) => (device.index === chosen.device ? 13 : 7)), color: points.map(colour),
          line: { width: points.map(({ device }) => (device.index === chosen.device ? 2.5 : 0)), color: look.colour('ink') },
        },
      },
    ],
    layout: {
      xaxis: { title: headingText(headingOf('cycles', 'K_eff_kN_per_mm')), range: paddedRange(points.map(({ x }) => x), 0.06), zeroline: false },
      yaxis: { title: headingText(headingOf('cycles', 'damping_percent')), range: paddedRange(points.map(({ y }) => y), 0.1), zeroline: false },
    },
  };
}
