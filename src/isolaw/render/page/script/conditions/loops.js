import { chooser, chosen } from '../choice.js';
import { THIN, isNumber, plain, trimmed } from '../text.js';
import { KN, LOOP_HOVER, MM } from '../units.js';
import { agedText, atText, conditionOf, loopDevices, referenceCycle, testsOf } from './data.js';

export const loopsFigure = {
  id: 'conditions-loops',
  title: 'One device under its conditions',
  width: 'half',
  depends: ['conditionsDevice'],
  wanted: () => loopDevices.length > 0,
  controls: () => [chooser('conditions-device', 'Device', loopDevices.map((name) => [name, name]), 'conditionsDevice')],
  caption: () => 'Loop of ' + referenceCycle() + ' of each test; thick: at reference.',
  csv: loopData,
  height: (width) => 340 + (width < 480 ? 24 * Math.ceil(testsOf(chosen.conditionsDevice).length / 2) : 0),
  draw: drawLoops,
};

// Returns the legend's text for a test: the condition in which the test differs from the reference.
function testText(test) {
  if (test.role === 'reference') return 'reference' + (isNumber(test.rest_h) ? ' after ' + trimmed(test.rest_h) + THIN + 'h' : '');
  if (test.effect === 'ageing') return 'aged ' + agedText({ days: test.aged_days, at_C: test.aged_at_C });
  const condition = conditionOf(test.effect);
  return condition ? atText(test.effect, test[condition.key]) : test.test + ' (' + test.role + ')';
}

function loopData() {
  return {
    columns: ['device', 'test', 'block', 'condition', 'displacement [' + MM + ']', 'force [' + KN + ']'],
    rows: testsOf(chosen.conditionsDevice).flatMap((test) =>
      test.loop_mm.map((value, i) => [test.device, test.test, test.block, testText(test), value, test.loop_kN[i]]),
    ),
  };
}

// Groups the tests by effect, for the legend, and sorts each group by its condition (temperature, frequency, ...). The
// reference comes last, so that it is drawn over the others.
function sorted(tests) {
  const place = (test) => (test.role === 'reference' ? 'z' : (test.effect ?? 'y'));
  const value = (test) => test[conditionOf(test.effect)?.key] ?? test.order;
  return [...tests].sort((a, b) => place(a).localeCompare(place(b)) || value(a) - value(b));
}

function drawLoops(look, width) {
  const tests = sorted(testsOf(chosen.conditionsDevice));
  const references = tests.filter(({ role }) => role === 'reference');
  const traces = tests.map((test, i) => {
    const again = references.indexOf(test);
    const line = again === 0 ? { color: look.colour('ink'), width: 2.6 }
      : again > 0 ? { color: look.colour('ink'), width: 1.2, dash: 'dot' }
        : { color: look.law({ index: i }), width: 1.5 };
    return {
      name: plain(testText(test)), mode: 'lines', x: test.loop_mm, y: test.loop_kN, line, showlegend: true,
      hovertemplate: LOOP_HOVER + '<extra>' + plain(testText(test)) + '</extra>',
    };
  });
  const narrow = width < 480;
  return {
    traces,
    layout: {
      showlegend: true,
      legend: narrow ? { orientation: 'h', x: 0, y: -0.2, yanchor: 'top', font: { size: 11.5 } } : { x: 1.02, y: 1, font: { size: 11.5 } },
      margin: { l: 58, r: narrow ? 12 : 130, t: 10, b: narrow ? 44 + 24 * Math.ceil(tests.length / 2) : 44 },
      xaxis: { title: 'displacement [' + MM + ']' },
      yaxis: { title: 'force [' + KN + ']' },
    },
  };
}
