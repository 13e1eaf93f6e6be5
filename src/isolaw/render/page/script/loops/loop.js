import { chosen } from '../choice.js';
import { onScreen } from '../dom.js';
import { THIN, enumerate, fixed, signed } from '../text.js';
import { LOOP_HEIGHT, chosenLaws, cutOff, fitCurves, isScored, loopData, measuredCurve, shownLoops } from './fits.js';
import { KN, LOOP_HOVER, MM } from '../units.js';

export const loopFigure = {
  id: 'loop',
  width: 'narrow',
  title: 'Force over displacement',
  depends: ['device', 'laws'],
  wanted: () => chosen.device !== null,
  caption: loopCaption,
  csv: () => loopData(),
  height: () => LOOP_HEIGHT,
  draw: drawLoop,
};

function loopCaption() {
  const { device, fits } = shownLoops();
  const missing = chosenLaws().filter((law) => !law.fitOn.get(device.index)?.force_kN);
  const said = fits.map(
    ({ law, fit }) =>
      law.name + ': OF ' + fixed(fit.objective.best, 4) +
      ', effective stiffness ' + signed(fit.K_eff_error_percent, 1) + THIN + '%, energy ' +
      signed(fit.energy_error_percent, 1) + THIN + '%, damping ' + signed(fit.damping_error_percent, 1) + THIN + '%' +
      (fit.tests.length > 0 ? ' (OF of its tests: ' + fit.tests.map(({ test, objective }) => test + ' ' + fixed(objective, 4)).join(', ') + ')' : ''),
  );
  const why = (law) => (law.fitOn.get(device.index)?.message ? ' (' + law.fitOn.get(device.index).message + ')' : '');
  const partly = device.scored ? ' Solid: used for the fit. Dotted: run through, not scored.' : '';
  const thinned =
    device.record.drawn < device.record.samples
      ? ' Drawn: ' + device.record.drawn + ' of ' + device.record.samples + ' samples.'
      : '';
  const tests = device.tests.length > 0 ? ' Its tests: ' + enumerate(device.tests.map(({ name }) => name)) + '.' : '';
  return (
    device.name + ', measured (grey) and best fits.' + tests + ' ' + said.join('; ') +
    (said.length > 0 ? '.' : onScreen('Choose a law above.')) +
    missing.map((law) => ' ' + law.name + ' has no fit' + why(law) + '.').join('') + partly + cutOff(chosenLaws()) + thinned
  );
}

function parted(values, inside) {
  const near = (i, wanted) => inside[i] === wanted || inside[i - 1] === wanted || inside[i + 1] === wanted;
  return {
    inside: values.map((value, i) => (near(i, true) ? value : null)),
    outside: values.map((value, i) => (inside[i] ? null : value)),
  };
}

function drawLoop(look) {
  const { device, measured, fits, range } = shownLoops();
  const hover = LOOP_HOVER;
  const halves = parted(measured.F, measured.t.map((t) => isScored(device, t)));
  return {
    traces: [
      ...[device.scored && {
        name: 'measured, not scored', mode: 'lines', x: measured.x, y: halves.outside,
        line: { color: look.colour('measured'), width: 1.6, dash: 'dot' },
        hovertemplate: hover + '<extra>measured, not scored</extra>',
      }].filter(Boolean),
      measuredCurve(look, measured.x, halves.inside, hover),
      ...fitCurves(look, fits, measured.x, hover),
    ],
    layout: {
      showlegend: true,
      xaxis: { title: 'displacement [' + MM + ']' },
      yaxis: { title: 'force [' + KN + ']', range },
    },
  };
}
