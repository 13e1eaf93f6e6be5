// The error of each law for what it is wanted for.

import { chosen } from '../choice.js';
import { errorText, purposeOf, standingsOf } from '../purposes.js';
import { isNumber, plain } from '../text.js';

const COLOURS = { taken: 'good', ties: 'good', behind: 'measured', 'ruled out': 'paper' };
const shown = () => standingsOf(purposeOf(chosen.purpose)).filter(({ error }) => isNumber(error));

// A law that runs away would hide the others: its bar ends at the edge, its number does not.
function edge(bars) {
  const taken = bars.filter(({ place }) => place !== 'ruled out').map(({ error }) => error);
  const all = bars.map(({ error }) => error);
  return Math.min(Math.max(...all), 1.6 * Math.max(...(taken.length > 0 ? taken : [Math.min(...all)])));
}

export function errorsCaption() {
  const { recommendation } = purposeOf(chosen.purpose);
  const bars = shown();
  const out = bars.some(({ place }) => place === 'ruled out');
  if (bars.length === 0) return 'No law has an error here.';
  return 'Error of the force over its standard deviation, ' + (recommendation.measure || 'as known') + (out ? '; hollow: ruled out.' : '.');
}

export function drawErrors(look) {
  const bars = shown().reverse();
  const most = bars.length > 0 ? edge(bars) : 1;
  return {
    traces: [
      {
        type: 'bar',
        orientation: 'h',
        y: bars.map(({ law }) => plain(law.id)),
        x: bars.map(({ error }) => 100 * Math.min(error, most)),
        text: bars.map(({ error }) => errorText(error)),
        textposition: 'outside',
        cliponaxis: false,
        width: 0.62,
        marker: {
          color: bars.map(({ place }) => look.colour(COLOURS[place])),
          line: {
            width: bars.map(({ place }) => (place === 'ruled out' ? 1.5 : 0)),
            color: bars.map(() => look.colour('poor')),
          },
        },
        hovertemplate: '<b>%{y}</b><br>error %{text}<extra></extra>',
      },
    ],
    layout: {
      xaxis: { title: 'error [%]', range: [0, 118 * most] },
      yaxis: { showgrid: false, type: 'category' },
    },
  };
}
