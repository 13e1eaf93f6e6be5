// One law for the lot

section({ id: 'one-law', title: 'One law for the lot', laws: true }, [
  {
    id: 'lot-laws',
    title: 'What one law for all devices costs',
    wanted: () => lotLaws.length > 0,
    caption: lotLawsCaption,
    csv: lotLawsData,
    build: lotLawsTable,
  },
  {
    id: 'lot-devices',
    title: 'Own law, the lot\u2019s law, and the law of all other devices',
    depends: ['lotLaw'],
    wanted: () => lotLaws.length > 0,
    controls: () => [lawChooser('lotLaw', lotLaws)],
    caption: lotDevicesCaption,
    csv: lotDevicesData,
    height: () => 360,
    draw: drawLotDevices,
  },
  {
    id: 'lot-parameters',
    width: 'half',
    title: 'The lot\u2019s parameters',
    depends: ['lotLaw'],
    wanted: () => lotLaws.length > 0,
    caption: lotParametersCaption,
    csv: lotParametersData,
    build: lotParametersTable,
  },
  {
    id: 'lot-correlation',
    width: 'half',
    title: 'How the parameters vary together',
    depends: ['lotLaw'],
    wanted: () => lotLaws.some((law) => law.population !== null),
    caption: correlationCaption,
    csv: correlationData,
    build: correlationTable,
  },
  {
    id: 'lot-outliers',
    title: 'Devices that stand apart from the lot',
    wanted: () => report.outliers.length > 0,
    caption: () =>
      'Properties and misfits far from the median of the lot. Look at the test of such a device before the lot\u2019s law is built on it.',
    csv: () => ({
      columns: ['device', 'property', 'value', 'unit', 'median', 'difference [%]', 'score'],
      rows: report.outliers.map((o) => [o.device, o.property, o.value, o.unit, o.median, o.percent, o.score]),
    }),
    build: apartList,
  },
]);

const ofLot = () => laws[chosen.lotLaw];
const fitsInLot = (law) => law.devices.filter((fit) => isNumber(fit.lot_objective));

function lotLawsCaption() {
  const best = lotLaws
    .filter((law) => isNumber(law.loo_objective))
    .sort((a, b) => a.loo_objective - b.loo_objective)[0];
  return (
    'OF of each device\u2019s own law, of the one law with the least mean over the lot, and of the law of all other devices on the one left out. Least worst: the law that is least bad for its worst device; where the descents are global, no law gets below the bound.' +
    (best
      ? ' For a device that was not tested, ' +
        best.id +
        ' misses least: ' +
        fixed(best.loo_objective, 4) +
        ' on average, against ' +
        fixed(best.objective_converged, 4) +
        ' of each device\u2019s own law.'
      : '')
  );
}

function lotLawsTable() {
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'Own law', unit: 'mean', number: true },
    { title: 'Lot\u2019s law', unit: 'mean', number: true },
    { title: 'Lot\u2019s law', unit: 'worst', number: true },
    { title: 'Least worst', unit: 'bound', number: true },
    { title: 'Left out', unit: 'mean', number: true },
    { title: 'Left out', unit: 'worst', number: true },
    { title: 'β', unit: 'of own laws', number: true },
    { title: 'Runs at the least OF', number: true },
  ];
  const below = (value, text) =>
    element('td', { class: 'number' }, value, text ? element('small', { title: text }, short(text, 16)) : null);
  const rows = lotLaws.map((law) => ({
    cells: [
      lawName(law),
      fixed(law.objective_converged, 4),
      fixed(law.lot.mean_objective, 4),
      below(fixed(law.lot.worst_objective, 4), law.lot.worst_device),
      below(fixed(law.lot.least_worst_objective, 4), fixed(law.lot.least_worst_bound, 4)),
      fixed(law.loo_objective, 4),
      below(fixed(law.loo_worst, 4), law.loo_worst_device),
      fixed(law.beta_converged, 3),
      element(
        'td',
        { class: 'number' },
        isNumber(law.success_share) ? fixed(100 * law.success_share, 0) + THIN + '%' : DASH,
        law.success_reference ? element('small', {}, law.success_reference) : null,
      ),
    ],
  }));
  return table(columns, rows, 'One law for all devices');
}

function lotLawsData() {
  return {
    columns: [
      'law',
      'own least OF [-]',
      "mean OF of the lot's law [-]",
      "worst OF of the lot's law [-]",
      'worst device',
      'least worst OF [-]',
      'bound of it [-]',
      'mean OF left out [-]',
      'worst OF left out [-]',
      'worst device left out',
      'beta of the least objectives [-]',
      'runs at the least OF [%]',
      'least OF of',
    ],
    rows: lotLaws.map((law) => [
      law.id,
      law.objective_converged,
      law.lot.mean_objective,
      law.lot.worst_objective,
      law.lot.worst_device,
      law.lot.least_worst_objective,
      law.lot.least_worst_bound,
      law.loo_objective,
      law.loo_worst,
      law.loo_worst_device,
      law.beta_converged,
      isNumber(law.success_share) ? 100 * law.success_share : null,
      law.success_reference,
    ]),
  };
}

function lotDevicesCaption() {
  const law = ofLot();
  const cost = fitsInLot(law)
    .filter((fit) => isNumber(fit.left_out_objective) && isNumber(fit.optimum))
    .sort((a, b) => b.left_out_objective - b.optimum - (a.left_out_objective - a.optimum));
  return (
    law.id +
    ': from the circle to the square is what sharing one law costs a device, to the diamond what it costs not to have tested it.' +
    (cost.length > 1
      ? ' Most for ' +
        devices[cost[0].device].name +
        ' (' +
        fixed(cost[0].optimum, 4) +
        ' with its own law, ' +
        fixed(cost[0].left_out_objective, 4) +
        ' left out), least for ' +
        devices[cost[cost.length - 1].device].name +
        '.'
      : '')
  );
}

function lotDevicesData() {
  return {
    columns: [
      'law',
      'device',
      'own OF [-]',
      "OF of the lot's law [-]",
      'OF of the least worst law [-]',
      'OF left out [-]',
    ],
    rows: lotLaws.flatMap((law) =>
      fitsInLot(law).map((fit) => [
        law.id,
        devices[fit.device].name,
        fit.optimum,
        fit.lot_objective,
        fit.worst_objective,
        fit.left_out_objective,
      ]),
    ),
  };
}

function drawLotDevices(look, width) {
  const law = ofLot(),
    fits = fitsInLot(law),
    size = fits.length > 60 ? 6 : 9;
  const kinds = [
    { name: 'own law', key: 'optimum', symbol: 'circle', colour: 'law-1' },
    { name: 'the lot\u2019s law', key: 'lot_objective', symbol: 'square', colour: 'law-5' },
    { name: 'left out', key: 'left_out_objective', symbol: 'diamond', colour: 'law-2' },
  ];
  const names = fits.map((fit) => short(devices[fit.device].name)),
    every = Math.ceil(names.length / Math.max(4, Math.min(24, Math.floor(width / 60)))),
    ticks = names.map((_, i) => i).filter((i) => i % every === 0);
  const spans = fits.flatMap((fit, i) => {
    const values = kinds.map(({ key }) => fit[key]).filter(isNumber);
    return [
      [i, Math.min(...values)],
      [i, Math.max(...values)],
      [null, null],
    ];
  });
  return {
    traces: [
      {
        mode: 'lines',
        x: spans.map(([x]) => x),
        y: spans.map(([, y]) => y),
        showlegend: false,
        hoverinfo: 'skip',
        line: { color: look.colour('measured'), width: 1.4 },
      },
      ...kinds.map(({ name, key, symbol, colour }) => ({
        name,
        mode: 'markers',
        x: fits.map((_, i) => i),
        y: fits.map((fit) => fit[key]),
        text: fits.map((fit) => plain(devices[fit.device].name)),
        marker: { symbol, size, color: look.colour(colour) },
        hovertemplate: '<b>%{text}</b>, ' + name + '<br>OF %{y:.4f}<extra></extra>',
      })),
    ],
    layout: {
      showlegend: true,
      xaxis: {
        tickmode: 'array',
        tickvals: ticks,
        ticktext: ticks.map((i) => plain(names[i])),
        range: [-0.6, fits.length - 0.4],
        showgrid: false,
        zeroline: false,
      },
      yaxis: { title: 'objective OF [-]', rangemode: 'tozero' },
    },
  };
}

// A parameter's median and relative scatter over the lot, where it was estimated.
function inPopulation(law, name) {
  const place = law.population?.parameters.indexOf(name) ?? -1;
  return {
    median: law.population?.medians[place] ?? null,
    scatter: law.population?.relative_std[place] ?? null,
  };
}

function lotParametersCaption() {
  const law = ofLot();
  return (
    law.id +
    ' as one law for all devices, and as the devices scatter: median of the lot, standard deviation between devices without the uncertainty of their fits.' +
    (law.population?.note ? ' ' + law.population.note[0].toUpperCase() + law.population.note.slice(1) + '.' : '')
  );
}

function lotParametersTable() {
  const law = ofLot();
  const columns = [
    { title: 'Parameter', pinned: true, tight: true },
    { title: 'Unit', tight: true },
    { title: 'Lot\u2019s law', number: true },
    { title: 'Least worst', number: true },
    { title: 'Median', number: true },
    { title: 'Scatter', unit: '%', number: true },
  ];
  const rows = law.parameters.map((parameter, place) => {
    const { median, scatter } = inPopulation(law, parameter.name);
    const values = [law.lot.parameters[place], law.lot.least_worst_parameters[place], median];
    const sizes = values.filter((value) => isNumber(value) && value !== 0).map(Math.abs);
    const apart = Math.max(...sizes) > 100 * Math.min(...sizes); // no factor serves both
    const format = apart ? { factor: 1, exponent: 0 } : rowFormat(values);
    const text = (value) => (apart ? significant(value) : fixed(value / format.factor, format.decimals));
    return {
      cells: [
        parameter.name,
        (format.exponent !== 0 ? '10' + superscript(format.exponent) + ' ' : '') + unitText(parameter.unit),
        ...values.map((value) => (isNumber(value) ? text(value) : DASH)),
        parameter.free ? (isNumber(scatter) ? fixed(100 * scatter, 1) : DASH) : 'fixed',
      ],
    };
  });
  return table(columns, rows, 'Parameters of the lot\u2019s law ' + law.id);
}

function lotParametersData() {
  return {
    columns: ['law', 'parameter', 'unit', "lot's law", 'least worst law', 'median', 'scatter [%]'],
    rows: lotLaws.flatMap((law) =>
      law.parameters.map((parameter, place) => {
        const { median, scatter } = inPopulation(law, parameter.name);
        return [
          law.id,
          parameter.name,
          parameter.unit,
          law.lot.parameters[place],
          law.lot.least_worst_parameters[place],
          median,
          isNumber(scatter) ? 100 * scatter : null,
        ];
      }),
    ),
  };
}

// Pairs of parameters with a correlation, the strongest first.
function correlations(law) {
  const { parameters = [], correlation = [] } = law.population ?? {};
  return correlation
    .flatMap((row, i) => row.slice(0, i).map((value, j) => ({ names: [parameters[j], parameters[i]], value })))
    .filter(({ value }) => isNumber(value))
    .sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
}

function correlationCaption() {
  const law = ofLot(),
    strong = correlations(law).filter(({ value }) => Math.abs(value) >= 0.7);
  if (correlations(law).length === 0) return law.id + ' has no correlation to show.';
  return (
    'Correlation of the parameters of ' +
    law.id +
    ' between devices, blue: together, rust: against one another; \u2013: a parameter that does not vary. ' +
    (strong.length === 0
      ? 'No two go closely together.'
      : 'Closest: ' +
        strong
          .slice(0, 3)
          .map(({ names, value }) => names.join(' and ') + ' (' + fixed(value, 2) + ')')
          .join(', ') +
        '. Draw a device\u2019s parameters together, never one by one.')
  );
}

function correlationData() {
  return {
    columns: ['law', 'parameter', 'with', 'correlation'],
    rows: lotLaws.flatMap((law) => correlations(law).map(({ names, value }) => [law.id, ...names, value])),
  };
}

function correlationTable() {
  const law = ofLot();
  const { parameters = [], correlation = [], note = '' } = law.population ?? {};
  if (correlation.length === 0)
    return element('p', { class: 'empty' }, note || 'No correlation was estimated for ' + law.id + '.');
  const columns = [
    { title: '', pinned: true, tight: true },
    ...parameters.slice(0, -1).map((name) => ({ title: element('span', {}, name), full: name, mark: true })),
  ];
  const rows = parameters.slice(1).map((name, i) => ({
    cells: [
      name,
      ...parameters.slice(0, -1).map((other, j) => {
        if (j > i) return element('td');
        const value = correlation[i + 1][j];
        if (!isNumber(value)) return element('td', { class: 'mark note' }, DASH);
        return element(
          'td',
          {
            class: 'mark heat ' + (value < 0 ? 'against' : 'together'),
            style: '--share: ' + Math.min(1, Math.abs(value)).toFixed(3),
            title: name + ' with ' + other + ': ' + fixed(value, 3),
          },
          fixed(value, 2),
        );
      }),
    ],
  }));
  const body = table(columns, rows, 'Correlation of the parameters of ' + law.id);
  body.classList.add('marks');
  return body;
}

function apartList() {
  const byDevice = new Map();
  for (const one of report.outliers) byDevice.set(one.device, [...(byDevice.get(one.device) ?? []), one]);
  const items = [...byDevice].map(([name, found]) =>
    element(
      'li',
      {},
      element('b', { class: 'strong' }, name),
      ': ' +
        found
          .map(
            (one) =>
              one.property +
              ' ' +
              withUnit(one.value, one.unit) +
              ' (' +
              signed(one.percent, 0) +
              THIN +
              '% from the median)',
          )
          .join('; '),
    ),
  );
  const few = items.length <= 8 ? items.length : 6;
  return element(
    'div',
    { class: 'prose' },
    element('ul', { class: 'sentences' }, ...items.slice(0, few)),
    few === items.length
      ? null
      : element(
          'details',
          {},
          element('summary', {}, items.length - few + ' more'),
          element('ul', { class: 'sentences' }, ...items.slice(few)),
        ),
  );
}
