import { chosen } from '../choice.js';
import { NARROW, textWidth } from '../plotting.js';
import { TONES, errorText, purposeOf, standingsOf } from '../purposes.js';
import { isNumber, plain } from '../text.js';

const COLOURS = { behind: 'measured', 'ruled out': 'paper' };
const colourOf = (place) => COLOURS[place] ?? TONES[purposeOf(chosen.purpose).recommendation.sure];
const shown = () => standingsOf(purposeOf(chosen.purpose)).filter(({ error }) => isNumber(error));

// Returns where the chart ends. Longer bars are cut, since one huge error would make all other bars tiny.
function edge(bars) {
  const taken = bars.filter(({ place }) => place !== 'ruled out').map(({ error }) => error);
  const all = bars.map(({ error }) => error),
    largest = Math.max(...(taken.length > 0 ? taken : [Math.min(...all)])),
    near = all.filter((error) => error <= 2 * largest);
  return near.length === all.length ? Math.max(...all) : Math.max(1.6 * largest, 1.15 * Math.max(...near));
}

const isCut = (error, most) => error > 1.001 * most;
const BAR = 0.62;

export const errorsHeight = () => Math.max(360, 70 + 28 * shown().length);

export function errorsCaption() {
  const bars = shown();
  const said = [
    bars.some(({ place }) => place === 'ruled out') ? 'hollow: ruled out' : '',
    bars.some(({ error }) => isCut(error, edge(bars))) ? 'broken: longer than drawn' : '',
  ].filter(Boolean);
  if (bars.length === 0) return 'No law has an error here.';
  return ['Mean of the two errors, over the force\u2019s standard deviation', ...said].join('; ') + '.';
}

function breakMark(look, x, y) {
  const stroke = (from, colour, width) => ({
    type: 'line', layer: 'above', xsizemode: 'pixel', ysizemode: 'pixel', xanchor: x, yanchor: y, x0: from, x1: from + 8, y0: -16, y1: 16,
    line: { color: look.colour(colour), width },
  });
  return [stroke(-27, 'paper', 6), stroke(-30.5, 'poor', 1.2), stroke(-23.5, 'poor', 1.2)];
}

export function drawErrors(look, width) {
  const bars = shown().reverse();
  const most = bars.length > 0 ? edge(bars) : 1;
  const tails = bars.map(({ error }) => textWidth(look, errorText(error), 12.5));
  const names = bars.map(({ law }) => plain(law.name));
  return {
    traces: [
      {
        type: 'bar',
        orientation: 'h',
        y: names,
        x: bars.map(({ error }) => 100 * Math.min(error, most)),
        text: bars.map(({ error }) => errorText(error)),
        textposition: 'outside',
        textangle: 0,
        constraintext: 'none',
        cliponaxis: false,
        width: BAR,
        marker: {
          color: bars.map(({ place }) => look.colour(colourOf(place))),
          line: {
            width: bars.map(({ place }) => (place === 'ruled out' ? 1.5 : 0)),
            color: bars.map(() => look.colour('poor')),
          },
        },
        hovertemplate: '<b>%{y}</b><br>error %{text}<extra></extra>',
      },
    ],
    layout: {
      margin: { l: 54, r: 14 + Math.max(0, ...tails), t: 10, b: 44 },
      shapes: bars.flatMap(({ error }, i) => (isCut(error, most) ? breakMark(look, 100 * most, names[i]) : [])),
      xaxis: { title: 'error [%]', range: [0, 102 * most], nticks: width < NARROW ? 5 : 8 },
      yaxis: { showgrid: false, type: 'category', dtick: 1 },
    },
  };
}
