import { chooser, chosen } from '../choice.js';
import { namedAxis, symbolOf } from '../plotting.js';
import { fitData, laws, lawsByObjective, usable } from '../report.js';
import { fixed, isNumber, mean, objectiveText, plain, short } from '../text.js';

export const objectiveDevicesFigure = {
  id: 'objective-devices',
  title: 'Objective per law and device',
  depends: ['grouping'],
  wanted: () => lawsByObjective.length > 0,
  controls: () => [chooser('grouping', 'Group by', [['law', 'law'], ['device', 'device']], 'grouping')],
  caption: () => {
    const best = lawsByObjective[0],
      worst = lawsByObjective[lawsByObjective.length - 1];
    const hardness = usable
      .map((device) => ({
        device,
        mean: mean(laws.map((law) => law.fitOn.get(device.index)?.objective.mean).filter(isNumber)),
      }))
      .filter((entry) => isNumber(entry.mean))
      .sort((a, b) => b.mean - a.mean);
    let text =
      'Mean over the runs with ± one standard deviation' +
      (chosen.grouping === 'law' ? '; the line across is the law\u2019s mean over the devices. ' : '. ') +
      (best === worst
        ? ''
        : best.name +
          ' is closest to the records on average (' +
          fixed(best.objective.mean, 4) + '), ' + worst.name + ' furthest (' + fixed(worst.objective.mean, 4) + '). ');
    if (hardness.length > 1)
      text +=
        hardness[0].device.name +
        ' is the hardest device to reproduce, ' + hardness[hardness.length - 1].device.name + ' the easiest.';
    return text;
  },
  csv: () => fitData(['objective', 'runs', 'failed_runs', 'evaluations', 'failed_evaluations']),
  height: () => 380,
  draw: drawObjectives,
};

function drawObjectives(look) {
  const byLaw = chosen.grouping === 'law';
  const shown = usable.filter((device) => laws.some((law) => law.fitOn.get(device.index)?.objective.mean !== null));
  const groups = byLaw ? lawsByObjective.length : shown.length;
  const members = byLaw ? shown.length : lawsByObjective.length;
  const position = (group, member) => group + (members === 1 ? 0 : (member / (members - 1) - 0.5) * 0.7);
  const traces = [];
  lawsByObjective.forEach((law, lawPlace) => {
    const found = shown
      .map((device, devicePlace) => ({
        device,
        fit: law.fitOn.get(device.index),
        x: byLaw ? position(lawPlace, devicePlace) : position(devicePlace, lawPlace),
      }))
      .filter((entry) => isNumber(entry.fit?.objective.mean));
    traces.push({
      name: plain(law.name),
      mode: 'markers',
      x: found.map((entry) => entry.x),
      y: found.map((entry) => entry.fit.objective.mean),
      error_y: {
        type: 'data', array: found.map((entry) => entry.fit.objective.std ?? 0), thickness: 1.2,
        width: members * groups > 300 ? 0 : 3, color: look.law(law),
      },
      marker: { color: look.law(law), symbol: symbolOf(law), size: members * groups > 300 ? 5 : 7 },
      text: found.map((entry) => plain(entry.device.name)),
      customdata: found.map((entry) => objectiveText(entry.fit.objective)),
      hovertemplate: '<b>' + plain(law.name) + '</b> on %{text}<br>OF %{customdata}<extra></extra>',
    });
    if (byLaw) {
      traces.push({
        mode: 'lines', x: [lawPlace - 0.42, lawPlace + 0.42], y: [law.objective.mean, law.objective.mean],
        hoverinfo: 'skip', showlegend: false, line: { color: look.law(law), width: 1.5 },
      });
    }
  });
  const names = byLaw ? lawsByObjective.map((law) => law.name) : shown.map((device) => short(device.name));
  return {
    traces,
    layout: {
      showlegend: !byLaw,
      xaxis: namedAxis(names, 24),
      yaxis: { title: 'objective OF [-]', rangemode: 'tozero' },
    },
  };
}
