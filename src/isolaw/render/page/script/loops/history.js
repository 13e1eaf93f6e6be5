import { chosen } from '../choice.js';
import { dashOf } from '../plotting.js';
import { THIN, plain, significant } from '../text.js';
import { LOOP_HEIGHT, fitCurves, isScored, loopData, measuredCurve, shownLoops } from './fits.js';
import { KN, hovered } from '../units.js';

export const historyFigure = {
  id: 'history',
  width: 'wide',
  title: 'Force and residual over time',
  depends: ['device', 'laws'],
  wanted: () => chosen.device !== null,
  caption: historyCaption,
  csv: () => loopData(),
  height: () => LOOP_HEIGHT,
  draw: drawHistory,
};

function historyCaption() {
  const { device, measured, fits } = shownLoops();
  const peak = Math.max(...measured.F.map(Math.abs));
  const scored = measured.t.map((t) => isScored(device, t));
  const worst = fits.map(
    ({ law, force }) =>
      law.name + ' ' +
      significant(Math.max(...force.map((f, i) => (scored[i] ? Math.abs(measured.F[i] - f) : 0))), 3) + THIN + KN,
  );
  return (
    'Residual: measured minus computed force. A residual that repeats from cycle to cycle is the law\u2019s own error; one that fades is scragging, which the law does not model.' +
    (worst.length > 0
      ? ' Largest residual: ' + worst.join(', ') + '; peak force ' + significant(peak, 3) + THIN + KN + '.'
      : '') +
    (device.scored ? ' Shaded: the part used for the fit; only its residuals are named.' : '')
  );
}

function residualAxis(measured, fits) {
  const most = 0.75 * (Math.max(...measured) - Math.min(...measured) || 1);
  const away = fits.some(({ force }) => force.some((f, i) => Math.abs(measured[i] - f) > most));
  return away ? { range: [-most, most] } : {};
}

function drawHistory(look) {
  const { device, measured, fits, range } = shownLoops();
  return {
    traces: [
      measuredCurve(look, measured.t, measured.F, hovered('y', 'kN', 1)),
      ...fitCurves(look, fits, measured.t, hovered('y', 'kN', 1)),
      ...fits.map(({ law, force }, place) => ({
        mode: 'lines', x: measured.t, y: force.map((f, i) => measured.F[i] - f), yaxis: 'y2', showlegend: false,
        line: { color: look.law(law), width: 1.4, dash: dashOf(place) },
        hovertemplate: 'residual ' + hovered('y', 'kN', 1) + '<extra>' + plain(law.name) + '</extra>',
      })),
    ],
    layout: {
      showlegend: true,
      hovermode: 'x unified',
      shapes: (device.scored ?? []).map(({ from, to }) => ({
        type: 'rect', layer: 'below', yref: 'paper', x0: from, x1: to, y0: 0, y1: 1, line: { width: 0 }, fillcolor: look.colour('scored'),
      })),
      xaxis: { title: device.record.has_time ? 'time [s]' : 'sample', anchor: 'y2' },
      yaxis: { title: 'force [' + KN + ']', domain: [0.38, 1], range },
      yaxis2: { title: 'residual [' + KN + ']', domain: [0, 0.3], ...residualAxis(measured.F, fits) },
    },
  };
}
