import { NARROW, panelHeading } from '../plotting.js';
import { resultData } from '../report.js';
import { THIN, count, fixed, isNumber, plain, trimmed } from '../text.js';
import { KEYS, chosenProperties, conditions, curvesOf, cyclesText, restText } from './data.js';

export const historyFigure = {
  id: 'conditions-history',
  title: 'Softening over cycles, recovery at rest',
  width: 'wide',
  depends: ['conditionsGroup'],
  wanted: () => tests().length > 0,
  caption: () =>
    'Softening: ' + quantity() + ' of each reference test over its ' + cyclesText(conditions.reference) +
    '. Orange: after a rest; all others: of a new device; dashed: smooth curve, for drawing only.' +
    (conditions.recovery.length > 0 ? ' Recovery: share of the loss in the first cycles that comes back, in K_eff.' : ''),
  csv: historyData,
  height: (width) => (width < NARROW && conditions.recovery.length > 0 ? 520 : 300),
  draw: drawHistory,
};

const quantity = () => chosenProperties()[0];
const tests = () => conditions.tests.filter(({ role, cycles }) => role === 'reference' && cycles.length > 1);
const isNew = ({ cycles }) => cycles[0].history === 'virgin';

// Returns the chosen property in each cycle of a test, divided by its value in the reference cycles of the same test:
// [{number, ratio}].
function ratiosOf(test) {
  const key = KEYS[quantity()];
  return test.cycles.filter((cycle) => isNumber(cycle[key]) && isNumber(test[key])).map(({ number, [key]: value }) => ({ number, ratio: value / test[key] }));
}

function historyData() {
  const rows = tests().flatMap((test) => test.cycles.map((cycle) => [test.device, test.test, test.rest_h, cycle]));
  return resultData('conditions_cycles', rows, ['device', 'test', 'rest [h]']);
}

function drawHistory(look, width) {
  const narrow = width < NARROW, { recovery } = conditions;
  const both = recovery.length > 0;
  const traces = tests().map((test) => {
    const points = ratiosOf(test);
    const name = plain(test.device + ', ' + test.test + (isNumber(test.rest_h) ? ' after ' + trimmed(test.rest_h) + THIN + 'h' : ''));
    const colour = look.colour(isNew(test) ? 'cycle-last' : 'cycle-first');
    return {
      mode: 'lines+markers', x: points.map(({ number }) => number), y: points.map(({ ratio }) => ratio),
      line: { color: colour, width: 1.2 }, marker: { color: colour, size: 5 },
      text: points.map(({ ratio }) => fixed(ratio, 3)), hovertemplate: name + '<br>cycle %{x}: %{text}<extra></extra>',
    };
  });
  for (const { at, lambda } of curvesOf('cycles', quantity()))
    traces.push({ mode: 'lines', x: at, y: lambda, hoverinfo: 'skip', line: { color: look.colour('ink'), width: 1, dash: 'dash' } });
  const largest = Math.max(...traces.flatMap(({ x }) => x));
  const layout = {
    margin: { l: 56, r: 12, t: 22, b: 44 },
    xaxis: {
      title: 'cycle', domain: both && !narrow ? [0, 0.56] : [0, 1], range: [0.6, largest + 0.4], zeroline: false,
      tickformat: 'd', dtick: Math.max(1, Math.ceil(largest / 10)), tick0: 1,
    },
    yaxis: { title: quantity() + ' over reference', domain: both && narrow ? [0.6, 1] : [0, 1], zeroline: false },
    annotations: [panelHeading(look, 0, 1, '<b>softening</b>')],
  };
  if (both) {
    traces.push({
      mode: 'lines+markers', xaxis: 'x2', yaxis: 'y2',
      x: recovery.map(({ rest_h: rest }) => rest), y: recovery.map(({ share }) => 100 * share),
      line: { color: look.colour('accent'), width: 1.8 }, marker: { color: look.colour('accent'), size: 7 },
      text: recovery.map(({ rest_h: rest, share, devices }) => fixed(100 * share, 0) + THIN + '% after ' + restText(rest) + ' on ' + count(devices, 'device')),
      hovertemplate: '%{text}<extra></extra>',
    });
    layout.xaxis2 = {
      title: 'rest [h]', type: 'log', domain: narrow ? [0, 1] : [0.68, 1], anchor: 'y2', zeroline: false,
      tickmode: 'array', tickvals: recovery.map(({ rest_h: rest }) => rest), ticktext: recovery.map(({ rest_h: rest }) => trimmed(rest)),
    };
    layout.yaxis2 = { title: 'recovered [%]', domain: narrow ? [0, 0.38] : [0, 1], anchor: 'x2', range: [0, 100], zeroline: false };
    layout.annotations.push(panelHeading(look, narrow ? 0 : 0.68, narrow ? 0.38 : 1, '<b>recovery</b>'));
  }
  return { traces, layout };
}
