import { chosen } from '../choice.js';
import { decadeTicks } from '../plotting.js';
import { curve, devices, laws, ranking, report } from '../report.js';
import { THIN, plain, significant, spanText } from '../text.js';

export const convergenceFigure = {
  id: 'convergence',
  title: 'Convergence of the search',
  depends: ['law', 'device'],
  wanted: () => convergingLaws.length > 0,
  caption: convergenceCaption,
  csv: convergenceData,
  height: () => 330,
  draw: drawConvergence,
};

const convergingLaws = ranking.filter((law) => law.devices.some((fit) => fit.convergence));
const MOST_CONVERGENCE_CURVES = 40;
const stepName = report.settings.method === 'ga' ? 'generation' : 'descent';

function convergenceOf(fit) {
  if (!fit?.convergence) return null;
  const { steps, stride, runs } = fit.convergence;
  const power = (coded) => curve(coded).map((value) => 10 ** value);
  const median = power(fit.convergence.median);
  return {
    step: median.map((_, k) => Math.min(k * stride, steps - 1) + 1),
    runs,
    median,
    lowest: power(fit.convergence.lowest),
    highest: power(fit.convergence.highest),
  };
}

function convergenceCaption() {
  const law = laws[chosen.law],
    all = law.devices.map((fit) => convergenceOf(fit)).filter(Boolean);
  if (all.length === 0) return 'No run of ' + law.name + ' has a history.';
  const settled = all.map(({ step, median }) => {
    const last = median[median.length - 1];
    return step[median.findIndex((value) => value <= 1.01 * last)];
  });
  const spreads = all.map(({ highest, lowest }) => highest[highest.length - 1] / lowest[lowest.length - 1] - 1);
  return (
    'Best OF so far: median over the runs (line) and, on the chosen device, smallest to largest (band). The median run of ' +
    law.name + ' is within 1' + THIN + '% of its final OF after ' + spanText(settled, 0) + ' ' + stepName + 's; the final OF of a device\u2019s runs differs by up to ' +
    significant(100 * Math.max(...spreads), 2) + THIN + '%.'
  );
}

function convergenceData() {
  return {
    columns: ['law', 'device', stepName, 'lowest OF [-]', 'median OF [-]', 'highest OF [-]'],
    rows: laws.flatMap((law) =>
      law.devices.flatMap((fit) => {
        const c = convergenceOf(fit);
        return c ? c.step.map((step, k) => [law.id, devices[fit.device].name, step, c.lowest[k], c.median[k], c.highest[k]]) : [];
      }),
    ),
  };
}

function drawConvergence(look) {
  const law = laws[chosen.law];
  const shown = law.devices.filter((fit) => fit.convergence).slice(0, MOST_CONVERGENCE_CURVES);
  const own = law.fitOn.get(chosen.device)?.convergence ? law.fitOn.get(chosen.device) : shown[0];
  const traces = shown.map((fit) => {
    const c = convergenceOf(fit);
    return {
      mode: 'lines', x: c.step, y: c.median,
      line: { color: fit === own ? look.law(law) : look.colour('measured'), width: fit === own ? 2 : 1 },
      opacity: fit === own ? 1 : 0.6,
      hovertemplate: '<b>' + plain(devices[fit.device].name) + '</b><br>' + stepName + ' %{x}: median OF %{y:.5f}<extra></extra>',
    };
  });
  if (own) {
    const c = convergenceOf(own);
    traces.unshift({
      mode: 'lines', x: [...c.step, ...[...c.step].reverse()], y: [...c.highest, ...[...c.lowest].reverse()],
      fill: 'toself', fillcolor: look.law(law), opacity: 0.2, line: { width: 0 }, hoverinfo: 'skip',
    });
  }
  return {
    traces,
    layout: {
      xaxis: { title: stepName, zeroline: false },
      yaxis: { title: 'best OF so far [-]', type: 'log', ...decadeTicks(traces.flatMap((trace) => trace.y)) },
    },
  };
}
