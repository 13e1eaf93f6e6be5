import { decadeTicks, namedAxis, symbolOf } from '../plotting.js';
import { lawsByObjective, usable } from '../report.js';
import { THIN, fixed, isNumber, mean, plain, signed, significant } from '../text.js';

export const objectiveSpreadFigure = {
  id: 'objective-spread',
  width: 'half',
  title: 'Spread over the runs',
  wanted: () => spreadEntries().length > 0,
  caption: spreadCaption,
  csv: () => ({
    columns: ['law', 'device', 'std OF over the runs [-]'],
    rows: spreadEntries().map(({ law, device, value }) => [law.id, device.name, value]),
  }),
  height: () => 330,
  draw: drawSpread,
};

export const objectiveRelativeFigure = {
  id: 'objective-relative',
  width: 'half',
  title: 'Each device against its law\u2019s mean',
  wanted: () => relativeEntries().length > 0,
  caption: relativeCaption,
  csv: () => ({
    columns: ['law', 'device', 'mean OF against the mean over devices [%]'],
    rows: relativeEntries().map(({ law, device, value }) => [law.id, device.name, value]),
  }),
  height: () => 330,
  draw: drawRelative,
};

// Standard deviations below this value are drawn at this value, because the runs of a converged search differ only by
// rounding.
const LEAST_SPREAD = 1e-9;

const spreadEntries = () =>
  lawsByObjective.flatMap((law) =>
    usable
      .map((device) => ({ law, device, value: law.fitOn.get(device.index)?.objective.std }))
      .filter(({ value }) => isNumber(value)),
  );

const relativeEntries = () =>
  lawsByObjective.flatMap((law) => {
    const entries = usable
      .map((device) => ({ law, device, objective: law.fitOn.get(device.index)?.objective.mean }))
      .filter(({ objective }) => isNumber(objective));
    const ofLaw = mean(entries.filter(({ device }) => !device.copy_of).map(({ objective }) => objective));
    return entries.length > 1 && ofLaw > 0
      ? entries.map(({ device, objective }) => ({ law, device, value: 100 * (objective / ofLaw - 1) }))
      : [];
  });

const lawsOf = (entries) => [...new Set(entries.map(({ law }) => law))];

function extremes(entries, of) {
  const found = lawsOf(entries)
    .map((law) => ({ law, value: of(entries.filter((entry) => entry.law === law).map(({ value }) => value)) }))
    .sort((a, b) => a.value - b.value);
  return [found[0], found[found.length - 1]];
}

function median(values) {
  const sorted = values.sort((a, b) => a - b),
    middle = (values.length - 1) / 2;
  return (sorted[Math.floor(middle)] + sorted[Math.ceil(middle)]) / 2;
}

function spreadCaption() {
  const [least, most] = extremes(spreadEntries(), median);
  return (
    'Standard deviation of OF over the runs, one mark per device: the scatter of the search itself.' +
    (least.law === most.law
      ? ''
      : ' Smallest for ' + least.law.name + ' (median ' + significant(least.value, 2) + '), largest for ' + most.law.name +
        ' (' + significant(most.value, 2) + ').')
  );
}

function relativeCaption() {
  const [least, most] = extremes(relativeEntries(), (values) => Math.max(...values.map(Math.abs)));
  return (
    'Mean OF of a device against the mean over the devices. A law whose marks lie close together fits all devices equally well' +
    (least.law === most.law
      ? '.'
      : ': most so ' + least.law.name + ' (within ' + fixed(least.value, 0) + THIN + '%), least ' + most.law.name + ' (' +
        fixed(most.value, 0) + THIN + '%).')
  );
}

function byLaw(entries, look, text) {
  const shownLaws = lawsOf(entries);
  const places = new Map(usable.map((device, i) => [device, usable.length === 1 ? 0 : i / (usable.length - 1) - 0.5]));
  return {
    traces: shownLaws.map((law, i) => {
      const own = entries.filter((entry) => entry.law === law);
      return {
        name: plain(law.name), mode: 'markers', x: own.map(({ device }) => i + 0.64 * places.get(device)),
        y: own.map(({ value }) => value), text: own.map(({ device }) => plain(device.name)), customdata: own.map(text),
        marker: { color: look.law(law), symbol: symbolOf(law), size: entries.length > 300 ? 4 : 6 },
        hovertemplate: '<b>' + plain(law.name) + '</b> on %{text}<br>%{customdata}<extra></extra>',
      };
    }),
    xaxis: namedAxis(shownLaws.map((law) => law.name), shownLaws.length),
  };
}

function drawSpread(look) {
  const entries = spreadEntries().map((entry) => ({ ...entry, value: Math.max(entry.value, LEAST_SPREAD) }));
  const { traces, xaxis } = byLaw(entries, look, ({ value }) => 'std of OF ' + significant(value, 2));
  return { traces, layout: { xaxis, yaxis: { title: 'std of OF over the runs [-]', type: 'log', ...decadeTicks(entries.map(({ value }) => value)) } } };
}

function drawRelative(look) {
  const { traces, xaxis } = byLaw(relativeEntries(), look, ({ value }) => signed(value, 1) + THIN + '%');
  return {
    traces,
    layout: {
      xaxis,
      yaxis: { title: 'OF against the law\u2019s mean [%]', zeroline: false },
      shapes: [{ type: 'line', xref: 'paper', x0: 0, x1: 1, y0: 0, y1: 0, line: { color: look.colour('muted'), width: 1.4, dash: 'dot' } }],
    },
  };
}
