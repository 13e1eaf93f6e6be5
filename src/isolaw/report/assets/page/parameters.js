// Parameters

section({ id: 'parameters', title: 'Parameters', controls: parameterControls, laws: true }, [
  {
    id: 'parameter-panels',
    title: 'Every parameter over the devices',
    depends: ['law'],
    wanted: () => chosen.law !== null && panelPlaces(laws[chosen.law]).length > 0,
    caption: panelsCaption,
    csv: parameterData,
    height: (width) => panelGrid(panelPlaces(laws[chosen.law]).length, width).height,
    draw: drawPanels,
  },
  {
    id: 'convergence',
    title: 'How the search came down',
    depends: ['law', 'device'],
    wanted: () => convergingLaws.length > 0,
    caption: convergenceCaption,
    csv: convergenceData,
    height: () => 330,
    draw: drawConvergence,
  },
  {
    id: 'parameter-tables',
    title: 'Identified parameters',
    long: true,
    wanted: () => laws.some((law) => law.parameters.length > 0),
    caption: () =>
      'Mean over the runs, ± standard deviation, and the difference of the device from the lot\u2019s mean in percent. ▲ ▼: the best run lies at the upper or lower ' +
      'bound of its search box, so the bound, not the record, decided the value. Δ: largest difference of a device from the lot\u2019s mean; β is its mean over the calibrated parameters.',
    csv: parameterData,
    build: parameterTables,
  },
]);

// One scale and one number of decimals per row, so that its numbers line up: a factor of 1000^n and three or four digits.
function rowFormat(values) {
  const largest = Math.max(0, ...values.filter(isNumber).map(Math.abs));
  if (largest === 0) return { factor: 1, exponent: 0, decimals: 2 };
  let exponent = 3 * Math.floor(Math.log10(largest) / 3);
  if (largest < 1e4 && largest >= 1e-2) exponent = 0;
  const scaled = largest / 10 ** exponent;
  return { factor: 10 ** exponent, exponent, decimals: Math.max(0, 3 - Math.max(-2, Math.floor(Math.log10(scaled)))) };
}

const trimmed = (value) => typeset(String(Number(value.toPrecision(4))));

function bounds(law, place) {
  const found = law.devices.map((fit) => fit.parameters[place]).filter(Boolean);
  if (found.length === 0) return null;
  const same = found.every((p) => p.lower === found[0].lower && p.upper === found[0].upper);
  return { same, lower: found[0].lower, upper: found[0].upper };
}

function parameterTable(law, shown) {
  const columns = [
    { title: 'Quantity', pinned: true },
    { title: 'Unit', tight: true },
    { title: 'Bounds' },
    { title: 'Lot mean', number: true },
    { title: 'Δ', unit: '%', number: true },
    ...shown.map((device) => ({ title: device.name, full: device.name, name: true, number: true })),
  ];
  const cell = (mean, std, difference, bound, format, best) => {
    const text = [
      element(
        'span',
        { class: 'cell-mean', 'data-mark': bound === 'upper' ? '▲' : '▼' },
        fixed(mean / format.factor, format.decimals),
      ),
      std === null ? null : element('span', { class: 'cell-std' }, '± ' + fixed(std / format.factor, format.decimals)),
      difference === null ? null : element('span', { class: 'cell-difference' }, signed(difference, 1) + THIN + '%'),
    ];
    const title = bound ? 'the best run, ' + significant(best, 4) + ', lies at the ' + bound + ' bound' : null;
    return element('td', { class: 'number' + (bound ? ' at-bound' : ''), title }, ...text);
  };
  const none = (fit) => element('td', { class: 'number note', title: fit?.message || null }, DASH);
  const meanOf = (values) => {
    const some = values.filter(isNumber);
    return some.length > 0 ? some.reduce((sum, v) => sum + v, 0) / some.length : null;
  };

  const objective = {
    cells: [
      element('b', { class: 'strong' }, 'OF'),
      '-',
      '',
      fixed(law.objective.mean, 4),
      '',
      ...shown.map((device) => {
        const fit = law.fitOn.get(device.index);
        return isNumber(fit?.objective.mean)
          ? cell(fit.objective.mean, fit.objective.std, null, '', { factor: 1, decimals: 4 }, null)
          : none(fit);
      }),
    ],
  };
  const rows = law.parameters.map((parameter, place) => {
    const means = usable.map((device) => law.fitOn.get(device.index)?.parameters[place]?.mean);
    const format = rowFormat(means);
    const box = bounds(law, place),
      lot = meanOf(means);
    return {
      cells: [
        parameter.name,
        (format.exponent !== 0 ? '10' + superscript(format.exponent) + ' ' : '') +
          (parameter.unit ? unitText(parameter.unit) : '-'),
        element(
          'td',
          { class: 'bounds' },
          !parameter.free
            ? 'fixed'
            : !box
              ? ''
              : box.same
                ? trimmed(box.lower / format.factor) + ' … ' + trimmed(box.upper / format.factor)
                : 'per device',
        ),
        isNumber(lot) ? fixed(lot / format.factor, format.decimals) : DASH,
        parameter.delta === null ? '' : fixed(100 * parameter.delta, 1),
        ...shown.map((device) => {
          const fit = law.fitOn.get(device.index),
            p = fit?.parameters[place];
          return isNumber(p?.mean)
            ? cell(p.mean, parameter.free ? p.std : null, parameter.free ? p.percent_of_lot : null, p.at_bound, format, p.best)
            : none(fit);
        }),
      ],
    };
  });
  return table(columns, [objective, ...rows], 'Parameters of ' + law.id);
}

const DEVICES_PER_PRINTED_BLOCK = 6,
  MOST_PRINTED_DEVICES = 30;

function parameterTables() {
  return element(
    'div',
    {},
    ...ranking.map((law, place) => {
      const bound = law.parameters.filter((_, i) => law.devices.some((fit) => fit.parameters[i]?.at_bound)).length;
      const widest = law.parameters.filter((p) => p.delta !== null).sort((a, b) => b.delta - a.delta)[0];
      const body = element('div');
      const details = element(
        'details',
        { class: 'law' },
        element(
          'summary',
          {},
          element('b', {}, law.id),
          element('span', {}, law.title),
          element(
            'span',
            {},
            'OF ' + fixed(law.objective.mean, 4) + (law.beta === null ? '' : ', β ' + fixed(law.beta, 3)),
          ),
          widest
            ? element('span', {}, widest.name + ' strays most, ' + fixed(100 * widest.delta, 0) + THIN + '%')
            : null,
          bound > 0 ? element('span', {}, count(bound, 'parameter') + ' at a bound somewhere') : null,
        ),
        body,
      );
      const fill = () => {
        if (details.open && !body.firstChild) body.append(parameterTable(law, usable));
      };
      details.addEventListener('toggle', fill);
      if (place === 0) {
        details.open = true;
        fill();
      }
      // Paper does not scroll: blocks of devices below one another, as Table A.5 has it; of a large lot its mean alone.
      details.print = () => {
        const blocks = [];
        for (let first = 0; first < usable.length; first += DEVICES_PER_PRINTED_BLOCK)
          blocks.push(usable.slice(first, first + DEVICES_PER_PRINTED_BLOCK));
        body.replaceChildren(
          ...(usable.length <= MOST_PRINTED_DEVICES ? blocks : [[]]).map((block) => parameterTable(law, block)),
        );
        details.wasOpen = details.open;
        details.open = true;
      };
      details.restore = () => {
        body.replaceChildren();
        details.open = details.wasOpen;
        fill();
      };
      return details;
    }),
  );
}

function parameterData() {
  return {
    columns: [
      'law',
      'parameter',
      'unit',
      'device',
      'mean',
      'std',
      'std/|mean|',
      'best',
      'difference from lot [%]',
      'at bound',
      'lower',
      'upper',
    ],
    rows: laws.flatMap((law) =>
      law.parameters.flatMap((parameter, i) =>
        law.devices
          .filter((fit) => fit.parameters[i])
          .map((fit) => {
            const { mean, std, best, percent_of_lot, at_bound, lower, upper } = fit.parameters[i];
            return [
              law.id,
              parameter.name,
              parameter.unit,
              devices[fit.device].name,
              mean,
              std,
              isNumber(std) && mean !== 0 ? Math.abs(std / mean) : null,
              best,
              percent_of_lot,
              at_bound,
              lower,
              upper,
            ];
          }),
      ),
    ),
  };
}

// --- panels of parameters: values with their spread over the runs on the left, difference from the lot on the right

function parameterControls() {
  return chosen.law === null ? [] : [lawChooser('law', ranking)];
}

// Free parameters with a value on some device.
const panelPlaces = (law) =>
  law.parameters
    .map((_, place) => place)
    .filter(
      (place) => law.parameters[place].free && law.devices.some((fit) => isNumber(fit.parameters[place]?.mean)),
    );

const PANEL_MARGIN = { l: 62, r: 52, t: 8, b: 40 };
function panelGrid(panels, width) {
  const printing = 'printing' in document.documentElement.dataset; // a figure is no longer than a page
  const columns = width > 900 || printing ? 3 : width > NARROW ? 2 : 1;
  const rows = Math.max(1, Math.ceil(panels / columns)),
    panel = printing ? 95 : 140,
    heading = 20,
    between = 34 + heading;
  const inner = heading + rows * panel + (rows - 1) * between;
  return { columns, panel, heading, between, inner, height: PANEL_MARGIN.t + inner + PANEL_MARGIN.b };
}

// A parameter of a law over the devices, with the mean of the devices' means.
function overDevices(law, place) {
  const entries = usable
    .map((device, x) => ({ device, x, row: law.fitOn.get(device.index)?.parameters[place] }))
    .filter(({ row }) => isNumber(row?.mean));
  const lot = entries.reduce((sum, { row }) => sum + row.mean, 0) / entries.length;
  return { entries, lot };
}

function panelsCaption() {
  const law = laws[chosen.law];
  const strayed = panelPlaces(law)
    .map((place) => law.parameters[place])
    .filter((p) => isNumber(p.delta))
    .sort((a, b) => b.delta - a.delta);
  const bound = panelPlaces(law).filter((place) => law.devices.some((fit) => fit.parameters[place]?.at_bound));
  return (
    'Mean over the runs \u00b1 standard deviation (left), and the difference from the mean over the devices, dotted (right). ' +
    (strayed.length > 1
      ? strayed[0].name + ' differs most from device to device (' + fixed(100 * strayed[0].delta, 0) + THIN + '%), ' +
        strayed[strayed.length - 1].name + ' least (' + fixed(100 * strayed[strayed.length - 1].delta, 0) + THIN + '%).'
      : '') +
    (usable.some((device) => device.name.length > 6) ? ' Devices are numbered in the order of the lot.' : '') +
    (bound.length > 0
      ? ' Open marks: the best run lies at a bound of its box (' + enumerate(bound.map((place) => law.parameters[place].name)) + ').'
      : '')
  );
}

function drawPanels(look, width) {
  const law = laws[chosen.law],
    places = panelPlaces(law);
  const { columns, panel, heading, between, inner } = panelGrid(places.length, width);
  const layout = { margin: PANEL_MARGIN, annotations: [], shapes: [] },
    traces = [];
  const every = Math.ceil(usable.length / (columns === 1 ? 12 : 11)),
    ticks = usable.map((_, i) => i).filter((i) => i % every === 0);
  const named = usable.every((device) => device.name.length <= 6); // else numbers, in the order of the lot
  const gap = columns === 1 ? 0 : 118 / (width - PANEL_MARGIN.l - PANEL_MARGIN.r),
    wide = (1 - gap * (columns - 1)) / columns;
  places.forEach((place, i) => {
    const left = (i % columns) * (wide + gap),
      top = 1 - (heading + Math.floor(i / columns) * (panel + between)) / inner;
    const name = (number) => (number === 1 ? '' : String(number));
    const x = name(i + 1), y = name(2 * i + 1), right = name(2 * i + 2);
    const { entries, lot } = overDevices(law, place),
      { factor, exponent } = rowFormat(entries.map(({ row }) => row.mean));
    const values = entries.flatMap(({ row }) => [(row.mean - (row.std ?? 0)) / factor, (row.mean + (row.std ?? 0)) / factor]);
    const range = paddedRange([...values, lot / factor], 0.08);
    const percent = (value) => (lot !== 0 ? 100 * ((value * factor) / lot - 1) : 0); // of a negative mean falling upwards
    layout['xaxis' + x] = {
      domain: [left, left + wide],
      anchor: 'y' + y,
      range: [-0.6, usable.length - 0.4],
      tickmode: 'array',
      tickvals: ticks,
      ticktext: ticks.map((k) => plain(named ? usable[k].name : String(k + 1))),
      tickfont: { size: 10.5 },
      showgrid: false,
      zeroline: false,
      automargin: false,
    };
    layout['yaxis' + y] = { domain: [top - panel / inner, top], anchor: 'x' + x, range, nticks: 5, zeroline: false, automargin: false };
    if (lot !== 0)
      layout['yaxis' + right] = {
        domain: [top - panel / inner, top],
        anchor: 'x' + x,
        overlaying: 'y' + y,
        side: 'right',
        range: range.map(percent),
        tickmode: 'auto', // not in step with the left axis
        nticks: 5,
        ticksuffix: THIN + '%',
        showgrid: false,
        zeroline: false,
        automargin: false,
      };
    const { unit } = law.parameters[place];
    const scale = [exponent !== 0 ? '10' + superscript(exponent) : '', unit && unit !== '1' ? unitText(unit) : ''].filter(Boolean).join(' ');
    layout.annotations.push({
      xref: 'paper', yref: 'paper', x: left, y: top, xanchor: 'left', yanchor: 'bottom', showarrow: false,
      text: '<b>' + plain(law.parameters[place].name) + '</b>' + (scale ? ' [' + plain(scale) + ']' : ''),
      font: { size: 12, color: look.colour('ink') },
    });
    layout.shapes.push({
      type: 'line', xref: 'x' + x + ' domain', x0: 0, x1: 1, yref: 'y' + y, y0: lot / factor, y1: lot / factor,
      line: { color: look.colour('muted'), width: 1.3, dash: 'dot' },
    });
    traces.push({
      mode: 'markers',
      xaxis: 'x' + x,
      yaxis: 'y' + y,
      x: entries.map((entry) => entry.x),
      y: entries.map(({ row }) => row.mean / factor),
      error_y: {
        type: 'data',
        array: entries.map(({ row }) => (row.std ?? 0) / factor),
        color: look.law(law),
        thickness: 1.2,
        width: usable.length > 40 ? 0 : 3,
      },
      marker: {
        color: look.law(law),
        size: usable.length > 60 ? 4 : 6,
        symbol: entries.map(({ row }) => (row.at_bound ? 'circle-open' : 'circle')),
        line: { width: 1.5, color: look.law(law) },
      },
      text: entries.map(({ device }) => plain(device.name)),
      customdata: entries.map(
        ({ row }) =>
          significant(row.mean, 4) + (isNumber(row.std) ? ' \u00b1 ' + significant(row.std, 2) : '') +
          (unit && unit !== '1' ? ' ' + plain(unitText(unit)) : '') +
          (isNumber(row.std) && row.mean !== 0 ? ' (\u03c3/|\u03bc| ' + significant(Math.abs(row.std / row.mean), 2) + ')' : '') +
          (isNumber(row.percent_of_lot) ? ', ' + signed(row.percent_of_lot, 1) + THIN + '%' : '') +
          (row.at_bound ? '<br>best run at the ' + row.at_bound + ' bound' : ''),
      ),
      hovertemplate: '<b>' + plain(law.parameters[place].name) + '</b> on %{text}<br>%{customdata}<extra></extra>',
    });
    // An axis without a trace is not drawn.
    if (lot !== 0)
      traces.push({ mode: 'markers', xaxis: 'x' + x, yaxis: 'y' + right, x: [0], y: [0], opacity: 0, hoverinfo: 'skip', marker: { size: 1 } });
  });
  return { traces, layout };
}

// --- convergence

const convergingLaws = ranking.filter((law) => law.devices.some((fit) => fit.convergence));
const MOST_CONVERGENCE_CURVES = 40;

// After how many generations or starts, and the objective then.
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
const stepName = report.settings.method === 'ga' ? 'generation' : 'descent';

function convergenceCaption() {
  const law = laws[chosen.law],
    all = law.devices.map((fit) => convergenceOf(fit)).filter(Boolean);
  if (all.length === 0) return 'No run of ' + law.id + ' has a history.';
  const settled = all.map(({ step, median }) => {
    const last = median[median.length - 1];
    return step[median.findIndex((value) => value <= 1.01 * last)];
  });
  const spreads = all.map(({ highest, lowest }) => highest[highest.length - 1] / lowest[lowest.length - 1] - 1);
  return (
    'Best OF so far: median over the runs (line) and, on the chosen device, smallest to largest (band). The median run of ' +
    law.id + ' is within 1' + THIN + '% of its end after ' + spanText(settled, 0) + ' ' + stepName + 's; at the end the runs of a device differ by up to ' +
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
      mode: 'lines',
      x: c.step,
      y: c.median,
      line: { color: fit === own ? look.law(law) : look.colour('measured'), width: fit === own ? 2 : 1 },
      opacity: fit === own ? 1 : 0.6,
      hovertemplate: '<b>' + plain(devices[fit.device].name) + '</b><br>' + stepName + ' %{x}: median OF %{y:.5f}<extra></extra>',
    };
  });
  if (own) {
    const c = convergenceOf(own);
    traces.unshift({
      mode: 'lines',
      x: [...c.step, ...[...c.step].reverse()],
      y: [...c.highest, ...[...c.lowest].reverse()],
      fill: 'toself',
      fillcolor: look.law(law),
      opacity: 0.2,
      line: { width: 0 },
      hoverinfo: 'skip',
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
