// Accuracy

section({ id: 'objective', title: 'Accuracy', laws: true }, [
  {
    id: 'objective-devices',
    title: 'Objective per law and device',
    depends: ['grouping'],
    wanted: () => lawsByObjective.length > 0,
    controls: groupingControl,
    caption: () => {
      const best = lawsByObjective[0],
        worst = lawsByObjective[lawsByObjective.length - 1];
      const hardness = usable
        .map((device) => {
          const values = laws.map((law) => law.fitOn.get(device.index)?.objective.mean).filter(isNumber);
          return { device, mean: values.reduce((sum, value) => sum + value, 0) / values.length };
        })
        .filter((entry) => isNumber(entry.mean))
        .sort((a, b) => b.mean - a.mean);
      let text =
        'Mean over the runs with ± one standard deviation' +
        (chosen.grouping === 'law' ? '; the line across is the law\u2019s mean over the devices. ' : '. ') +
        (best === worst
          ? ''
          : best.id +
            ' is closest to the records on average (' +
            fixed(best.objective.mean, 4) +
            '), ' +
            worst.id +
            ' furthest (' +
            fixed(worst.objective.mean, 4) +
            '). ');
      if (hardness.length > 1)
        text +=
          hardness[0].device.name +
          ' is the hardest device to reproduce, ' +
          hardness[hardness.length - 1].device.name +
          ' the easiest.';
      return text;
    },
    csv: () => ({
      columns: [
        'law',
        'device',
        'mean OF [-]',
        'std OF [-]',
        'best OF [-]',
        'runs',
        'failed runs',
        'evaluations',
        'failed evaluations',
      ],
      rows: laws.flatMap((law) =>
        law.devices.map((fit) => [
          law.id,
          devices[fit.device].name,
          fit.objective.mean,
          fit.objective.std,
          fit.objective.best,
          fit.runs,
          fit.failed_runs,
          fit.evaluations,
          fit.failed_evaluations,
        ]),
      ),
    }),
    height: () => 380,
    draw: drawObjectives,
  },
  {
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
  },
  {
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
  },
]);

function groupingControl() {
  const option = (value, text) => element('option', { value, selected: chosen.grouping === value }, text);
  const select = element('select', { id: 'grouping' }, option('law', 'law'), option('device', 'device'));
  select.addEventListener('change', () => choose({ grouping: select.value }));
  return [element('label', {}, 'Group by', select)];
}

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
      name: plain(law.id),
      mode: 'markers',
      x: found.map((entry) => entry.x),
      y: found.map((entry) => entry.fit.objective.mean),
      error_y: {
        type: 'data',
        array: found.map((entry) => entry.fit.objective.std ?? 0),
        thickness: 1.2,
        width: members * groups > 300 ? 0 : 3,
        color: look.law(law),
      },
      marker: { color: look.law(law), symbol: symbolOf(law), size: members * groups > 300 ? 5 : 7 },
      text: found.map((entry) => plain(entry.device.name)),
      customdata: found.map((entry) => objectiveText(entry.fit.objective)),
      hovertemplate: '<b>' + plain(law.id) + '</b> on %{text}<br>OF %{customdata}<extra></extra>',
    });
    if (byLaw) {
      traces.push({
        mode: 'lines',
        x: [lawPlace - 0.42, lawPlace + 0.42],
        y: [law.objective.mean, law.objective.mean],
        hoverinfo: 'skip',
        showlegend: false,
        line: { color: look.law(law), width: 1.5 },
      });
    }
  });
  const names = byLaw ? lawsByObjective.map((law) => law.id) : shown.map((device) => short(device.name));
  const every = Math.ceil(names.length / 24);
  const ticks = names.map((_, i) => i).filter((i) => i % every === 0);
  return {
    traces,
    layout: {
      showlegend: !byLaw,
      xaxis: {
        tickmode: 'array',
        tickvals: ticks,
        ticktext: ticks.map((i) => plain(names[i])),
        range: [-0.6, groups - 0.4],
        showgrid: false,
        zeroline: false,
      },
      yaxis: { title: 'objective OF [-]', rangemode: 'tozero' },
    },
  };
}

// The standard deviation of a converged search is rounding; what lies below this is drawn on it.
const LEAST_SPREAD = 1e-9;

const spreadEntries = () =>
  lawsByObjective.flatMap((law) =>
    usable
      .map((device) => ({ law, device, value: law.fitOn.get(device.index)?.objective.std }))
      .filter(({ value }) => isNumber(value)),
  );

// Of the mean objectives of a law: how far a device lies from their mean, in percent of it.
const relativeEntries = () =>
  lawsByObjective.flatMap((law) => {
    const entries = usable
      .map((device) => ({ law, device, mean: law.fitOn.get(device.index)?.objective.mean }))
      .filter(({ mean }) => isNumber(mean));
    const mean = entries.reduce((sum, entry) => sum + entry.mean, 0) / entries.length;
    return entries.length > 1 && mean > 0
      ? entries.map((entry) => ({ law, device: entry.device, value: 100 * (entry.mean / mean - 1) }))
      : [];
  });

function spreadCaption() {
  const medians = lawsByObjective
    .map((law) => {
      const values = spreadEntries()
        .filter((entry) => entry.law === law)
        .map(({ value }) => value)
        .sort((a, b) => a - b);
      const middle = (values.length - 1) / 2;
      return { law, value: (values[Math.floor(middle)] + values[Math.ceil(middle)]) / 2 };
    })
    .filter(({ value }) => isNumber(value))
    .sort((a, b) => a.value - b.value);
  const [least, most] = [medians[0], medians[medians.length - 1]];
  return (
    'Standard deviation of OF over the runs, a mark a device: what the search adds by itself.' +
    (least.law === most.law
      ? ''
      : ' Smallest for ' + least.law.id + ' (median ' + significant(least.value, 2) + '), largest for ' + most.law.id +
        ' (' + significant(most.value, 2) + ').')
  );
}

function relativeCaption() {
  const span = (law) => {
    const values = relativeEntries()
      .filter((entry) => entry.law === law)
      .map(({ value }) => Math.abs(value));
    return Math.max(...values);
  };
  const spans = [...new Set(relativeEntries().map(({ law }) => law))]
    .map((law) => ({ law, value: span(law) }))
    .sort((a, b) => a.value - b.value);
  const [least, most] = [spans[0], spans[spans.length - 1]];
  return (
    'Mean OF of a device against the mean over the devices. A law whose marks lie close together suits all devices alike' +
    (least.law === most.law
      ? '.'
      : ': ' + least.law.id + ' does most (within ' + fixed(least.value, 0) + THIN + '%), ' + most.law.id + ' least (' +
        fixed(most.value, 0) + THIN + '%).')
  );
}

// Marks of devices over the laws, side by side within a law.
function byLaw(entries, look, text) {
  const shownLaws = [...new Set(entries.map(({ law }) => law))];
  const places = new Map(usable.map((device, i) => [device, usable.length === 1 ? 0 : i / (usable.length - 1) - 0.5]));
  return {
    traces: shownLaws.map((law, i) => {
      const own = entries.filter((entry) => entry.law === law);
      return {
        name: plain(law.id),
        mode: 'markers',
        x: own.map(({ device }) => i + 0.64 * places.get(device)),
        y: own.map(({ value }) => value),
        text: own.map(({ device }) => plain(device.name)),
        customdata: own.map(text),
        marker: { color: look.law(law), symbol: symbolOf(law), size: entries.length > 300 ? 4 : 6 },
        hovertemplate: '<b>' + plain(law.id) + '</b> on %{text}<br>%{customdata}<extra></extra>',
      };
    }),
    xaxis: {
      tickmode: 'array',
      tickvals: shownLaws.map((_, i) => i),
      ticktext: shownLaws.map((law) => plain(law.id)),
      range: [-0.6, shownLaws.length - 0.4],
      showgrid: false,
      zeroline: false,
    },
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
