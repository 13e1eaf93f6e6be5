// The lot

section({ id: 'devices', title: 'Lot and devices' }, [
  {
    id: 'rule-set',
    title: 'What the lot was held to',
    wanted: () => report.assessment !== null,
    build: ruleSetStatement,
  },
  {
    id: 'lot',
    title: 'The lot, property by property',
    long: true,
    wanted: () => lotQuantities.length > 0,
    caption: lotCaption,
    csv: lotData,
    build: lotTable,
  },
  {
    id: 'lot-strips',
    title: 'Every device of the lot',
    depends: ['tested'],
    wanted: () => stripRows().length > 0,
    caption: () =>
      'One mark a device; ringed: ' +
      (chosen.tested === null ? 'none' : devices[chosen.tested].name) +
      '. Solid line: mean of the lot; dashed: design value; band: limits of one device. Outliers are named.',
    csv: stripData,
    height: () => stripLayout().height,
    draw: drawStrips,
  },
  {
    id: 'outliers',
    title: 'Outliers',
    wanted: () => lotQuantities.length > 0 && report.assessment.lot.outliers.length > 0,
    csv: () => ({
      columns: ['device', 'quantity', 'value', 'unit', 'why'],
      rows: report.assessment.lot.outliers.map((o) => [o.device, o.quantity, o.value, o.unit, o.why]),
    }),
    build: outlierTable,
  },
  {
    id: 'verdict-table',
    title: 'Verdicts, device by device',
    long: true,
    wanted: () => devices.some((device) => device.assessments.length > 0),
    caption: () =>
      'Devices outside a limit come first. Under the verdict the deviation from the design value, or the value.' +
      onScreen(' Choose a device above for clauses, formulas and reasons.'),
    csv: () => assessmentData(devices),
    build: verdictTable,
  },
  {
    id: 'lot-stability',
    title: 'Stability of all devices',
    depends: ['tested', 'block'],
    wanted: () => devices.some((device) => countedCycles(device).length > 0),
    caption: lotStabilityCaption,
    csv: () => cycleData(devices),
    height: (width) => (width < NARROW ? 3 * 190 : 270),
    draw: drawLotStability,
  },
  {
    id: 'factors',
    title: 'Property modification factors',
    long: true,
    wanted: () => (report.assessment?.lot?.factors.length ?? 0) > 0,
    caption: factorCaption,
    csv: factorData,
    build: factorTable,
  },
  {
    id: 'properties',
    title: 'Test properties per device and block',
    long: true,
    caption: propertiesCaption,
    csv: () => cycleData(devices),
    build: propertiesTable,
  },
]);

const sampleText = ({ value, limit, verdict, reason }) =>
  [count(value, 'device') + ' tested', limit, verdict].filter(Boolean).join(', ') + (reason ? ': ' + reason : '');

function ruleSetStatement() {
  const { rule_set: rules, design, lot } = report.assessment;
  const facts = [
    [
      'Rule set',
      rules ? rules.title + (rules.edition ? ', ' + rules.edition : '') : 'none chosen: values only, no limits',
    ],
    ...(rules?.source ? [['Source', rules.source]] : []),
    ...(rules ? [['Verified by', rules.verified_by || 'nobody']] : []),
    [
      'Design values',
      design.length > 0
        ? design.map(({ name, value, unit }) => name + ' ' + value + THIN + unit).join(', ')
        : 'none given: no deviation can be stated',
    ],
    ...(rules && lot?.sample ? [['Sample', sampleText(lot.sample)]] : []),
    ...(lot?.note ? [['The lot', lot.note]] : []),
    ...(lot?.mean_analysis?.sentence ? [['Mean properties', lot.mean_analysis.sentence]] : []),
  ];
  const unverified = rules !== null && !rules.verified_by;
  return element(
    'div',
    {},
    unverified
      ? element(
          'p',
          { class: 'warnings' },
          element('b', {}, 'The limits of this set are not verified: deviations are information, no verdict.'),
        )
      : null,
    element(
      'dl',
      { class: 'facts-list' },
      ...facts.flatMap(([term, text]) => [element('dt', {}, term), element('dd', {}, sentence(text))]),
    ),
  );
}

function lotCaption() {
  const { lot } = report.assessment;
  const failing = devices.filter((device) => device.assessments.some((a) => a.verdict === 'fail')).map((d) => d.name);
  return (
    (isNumber(lot.tested) ? count(lot.tested, 'device') + ' with values' : 'Devices with values') +
    (isNumber(lot.size) ? ' of ' + lot.size : '') +
    (isNumber(lot.required) ? ', ' + lot.required + ' required' : '') +
    '. CoV: standard deviation over the mean.' +
    onScreen(
      ' Tolerance: interval that holds 95\u202f% of all devices with 95\u202f% confidence, if normally distributed.',
    ) +
    (failing.length > 0 ? ' Outside a limit: ' + enumerate(failing) + '.' : '')
  );
}

function lotTable() {
  const columns = [
    { title: 'Property', pinned: true },
    { title: 'Verdict' },
    { title: 'n', number: true },
    { title: 'Mean', number: true },
    { title: 'CoV', unit: '%', number: true },
    { title: 'Smallest', unit: 'device', number: true },
    { title: 'Largest', unit: 'device', number: true },
    { title: 'Design value', number: true },
    { title: 'Deviation', unit: 'mean; worst', number: true },
    { title: 'Limits', unit: 'each device; mean' },
    { title: '5 to 95 %', unit: 'fractiles', number: true, screen: true },
    { title: 'Tolerance', unit: '95/95, k', number: true, screen: true },
  ];
  const extreme = (value, device) =>
    element(
      'td',
      { class: 'number' },
      significant(value, 4),
      element('small', { title: device }, short(device ?? '', 16)),
    );
  const range = (low, high) =>
    isNumber(high) ? (isNumber(low) ? significant(low, 3) + ' \u2013 ' : 'to ') + significant(high, 3) : DASH;
  const rows = lotQuantities.map((q) => ({
    cells: [
      element('span', {}, element('b', { class: 'strong' }, q.quantity), q.unit ? ' ' + unitText(q.unit) : ''),
      element(
        'td',
        { class: 'reasoned' },
        q.verdict ? verdictBadge(q.verdict) : DASH,
        q.reason ? element('small', {}, q.reason) : null,
      ),
      isNumber(q.n) ? String(q.n) : DASH,
      significant(q.mean, 4),
      fixed(q.cov_percent, 1),
      extreme(q.min, q.min_device),
      extreme(q.max, q.max_device),
      significant(q.nominal, 4),
      element(
        'td',
        { class: 'number' },
        deviation(q.deviation_of_mean_percent),
        isNumber(q.worst_deviation_percent)
          ? element('small', {}, 'worst ' + deviation(q.worst_deviation_percent))
          : null,
      ),
      element(
        'td',
        { class: 'tight' },
        limitText(q.limit_individual),
        q.limit_mean ? element('small', {}, 'mean: ' + limitText(q.limit_mean)) : null,
      ),
      range(q.fractile_5, q.fractile_95),
      element(
        'td',
        { class: 'number screen' },
        range(q.tolerance_lower, q.tolerance_upper),
        isNumber(q.tolerance_k) ? element('small', {}, 'k ' + fixed(q.tolerance_k, 3)) : null,
        q.no_lower_bound ? element('small', {}, q.no_lower_bound.split(':')[0]) : null,
      ),
    ],
  }));
  return table(columns, rows, 'The lot, one row a property');
}

function lotData() {
  const keys = Object.keys(lotQuantities[0]);
  return { columns: keys, rows: lotQuantities.map((quantity) => keys.map((key) => quantity[key])) };
}

// The value of a device for a property of the lot: its assessed ones (the mean over both sides), else the reported cycle.
function deviceValue(device, quantity) {
  const own = device.assessments.filter(
    (a) => (a.quantity === quantity || a.quantity.startsWith(quantity + ',')) && isNumber(a.value),
  );
  if (own.length > 0) {
    return {
      value: own.reduce((sum, a) => sum + a.value, 0) / own.length,
      verdict: worstVerdict(own.map((a) => a.verdict)) ?? 'not assessed',
    };
  }
  const key = CYCLE_COLUMNS.find((column) => column.key.startsWith(quantity + '_'))?.key;
  const block = device.blocks.find((b) => b.number === device.reported?.block);
  const value = block?.cycles.find((cycle) => isReported(device, block, cycle))?.[key];
  return isNumber(value) ? { value, verdict: 'not assessed' } : null;
}

const stripRows = () =>
  lotQuantities
    .map((quantity) => ({
      quantity,
      points: devices
        .map((device) => ({ device, ...deviceValue(device, quantity.quantity) }))
        .filter((point) => isNumber(point.value)),
    }))
    .filter(({ points }) => points.length > 0);

const STRIP_HEIGHT = 62,
  STRIP_BETWEEN = 52;
function stripLayout() {
  const rows = stripRows();
  const margin = { l: 14, r: 14, t: 52, b: 30 };
  const inner = rows.length * STRIP_HEIGHT + (rows.length - 1) * STRIP_BETWEEN;
  return { rows, margin, inner, height: margin.t + inner + margin.b };
}

function stripData() {
  return {
    columns: ['device', 'quantity', 'unit', 'value', 'verdict', 'outlier'],
    rows: stripRows().flatMap(({ quantity, points }) =>
      points.map(({ device, value, verdict }) => [
        device.name,
        quantity.quantity,
        quantity.unit,
        value,
        verdict,
        outlierOf(device, quantity) ? 'yes' : 'no',
      ]),
    ),
  };
}
const outlierOf = (device, quantity) =>
  report.assessment.lot.outliers.find((o) => o.device === device.name && o.quantity === quantity.quantity);

function drawStrips(look, width) {
  const { rows, margin, inner } = stripLayout();
  const traces = [],
    layout = { margin, shapes: [], annotations: [], showlegend: true, legend: { ...LEGEND, y: 1 + 24 / inner } };
  const present = Object.keys(VERDICTS).filter((verdict) =>
    rows.some(({ points }) => points.some((p) => p.verdict === verdict)),
  );
  rows.forEach(({ quantity, points }, i) => {
    const suffix = i === 0 ? '' : String(i + 1);
    const top = 1 - (i * (STRIP_HEIGHT + STRIP_BETWEEN)) / inner,
      bottom = top - STRIP_HEIGHT / inner;
    const band = limitBand(quantity.limit_individual, quantity.nominal);
    const values = points.map((point) => point.value);
    const range = paddedRange([...values, quantity.nominal, ...(band ?? [])].filter(isNumber), 0.06);
    layout['xaxis' + suffix] = {
      domain: [0, 1],
      anchor: 'y' + suffix,
      range,
      zeroline: false,
      nticks: width > NARROW ? 9 : 5,
      automargin: false,
    };
    layout['yaxis' + suffix] = {
      domain: [bottom, top],
      anchor: 'x' + suffix,
      range: [-1, 1],
      showticklabels: false,
      showgrid: false,
      zeroline: false,
      fixedrange: true,
      automargin: false,
    };
    layout.annotations.push({
      xref: 'paper',
      yref: 'paper',
      x: 0,
      y: top,
      xanchor: 'left',
      yanchor: 'bottom',
      showarrow: false,
      text:
        '<b>' + plain(quantity.quantity) + '</b>' + (quantity.unit ? ' [' + plain(unitText(quantity.unit)) + ']' : ''),
      font: { size: 12.5, color: look.colour('ink') },
    });
    const whole = { xref: 'x' + suffix, yref: 'y' + suffix + ' domain', y0: 0, y1: 1, layer: 'below' };
    if (band)
      layout.shapes.push({
        ...whole,
        type: 'rect',
        x0: band[0] ?? range[0],
        x1: band[1] ?? range[1],
        fillcolor: look.colour('band'),
        line: { width: 0 },
      });
    for (const [at, dash, colour] of [
      [quantity.nominal, 'dash', 'good'],
      [quantity.mean, 'solid', 'muted'],
    ])
      if (isNumber(at))
        layout.shapes.push({
          ...whole,
          type: 'line',
          x0: at,
          x1: at,
          line: { color: look.colour(colour), width: 1.4, dash },
        });
    // Spread over the strip's height by the golden ratio: neighbours in the list never meet.
    const height = new Map(points.map(({ device }, k) => [device, 1.3 * ((k * 0.618034) % 1) - 0.65]));
    for (const verdict of present) {
      const some = points.filter((point) => point.verdict === verdict);
      if (some.length === 0) continue;
      const known = VERDICTS[verdict];
      traces.push({
        name: verdict,
        legendgroup: verdict,
        showlegend: !traces.some((trace) => trace.name === verdict),
        mode: 'markers',
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x: some.map((point) => point.value),
        y: some.map((point) => height.get(point.device)),
        text: some.map((point) => plain(point.device.name)),
        customdata: some.map((point) => plain(withUnit(point.value, quantity.unit))),
        marker: {
          symbol: known.symbol,
          size: points.length > 60 ? 6 : 8,
          color: look.colour(known.tone === 'muted' ? 'accent' : known.tone),
          line: { width: known.filled ? 0 : 1.5, color: look.colour(known.tone === 'muted' ? 'accent' : known.tone) },
        },
        hovertemplate: '<b>%{text}</b>: %{customdata}<extra>' + verdict + '</extra>',
      });
    }
    const own = points.find(({ device }) => device.index === chosen.tested);
    if (own)
      traces.push({
        mode: 'markers',
        showlegend: false,
        hoverinfo: 'skip',
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x: [own.value],
        y: [height.get(own.device)],
        marker: { symbol: 'circle-open', size: 15, line: { width: 2 }, color: look.colour('ink') },
      });
    layout.annotations.push(
      ...outlierLabels(points, quantity, range, width - margin.l - margin.r).map((label) => ({
        ...label,
        xref: 'x' + suffix,
        yref: 'paper',
        y: top,
        yanchor: 'bottom',
        showarrow: false,
        font: { size: 11.5, color: look.colour('care') },
      })),
    );
  });
  return { traces, layout };
}

// Names of outliers above the strip, moved apart; right of the strip's own heading.
function outlierLabels(points, quantity, range, width) {
  const found = points.filter(({ device }) => outlierOf(device, quantity)).sort((a, b) => a.value - b.value);
  const pixel = (value) => ((value - range[0]) / (range[1] - range[0])) * width;
  const names = found.map(({ device }) => '\u25be ' + short(device.name, 12));
  const widest = Math.max(0, ...names.map((name) => 7 * name.length)) + 6;
  const free = 110, // pixels of the heading
    most = Math.max(1, Math.floor((width - free) / widest));
  const some = found.slice(-most);
  const places =
    some.length > 0
      ? spread(
          some.map((point) => pixel(point.value)),
          widest,
          free + widest / 2,
          width - widest / 2,
        )
      : [];
  return some.map((_, i) => ({
    x: range[0] + (places[i] / width) * (range[1] - range[0]),
    text: plain(names[found.length - some.length + i]),
  }));
}

function outlierTable() {
  const columns = [
    { title: 'Device', pinned: true },
    { title: 'Property' },
    { title: 'Value', number: true },
    { title: 'Why' },
  ];
  const rows = report.assessment.lot.outliers.map((outlier) => ({
    cells: [
      element('b', { class: 'strong' }, outlier.device),
      outlier.quantity,
      withUnit(outlier.value, outlier.unit),
      element('td', { class: 'note text' }, outlier.why),
    ],
  }));
  return table(columns, rows, 'Outliers');
}

function factorCaption() {
  const history = lotQuantities
    .filter((q) => isNumber(q.lambda_test_min))
    .map(
      (q) =>
        q.quantity +
        ' ' +
        fixed(q.lambda_test_min, 3) +
        ' (cycle ' +
        q.lambda_test_min_cycle +
        ') to ' +
        fixed(q.lambda_test_max, 3) +
        ' (cycle ' +
        q.lambda_test_max_cycle +
        ')',
    );
  return (
    'Factors on the design value (on the mean of the lot where there is none) and the bounds they give. The spread of single devices bounds a device; only the spread of the system may bound the whole isolation system.' +
    (history.length > 0
      ? ' Each holds that of the test, smallest and largest counted cycle over the mean of the first three: ' +
        history.join(', ') +
        '.'
      : '')
  );
}

function factorTable() {
  const columns = [
    { title: 'Property', pinned: true },
    { title: 'Source', tight: true },
    { title: 'Spread of', tight: true },
    { title: '\u03bb min', number: true },
    { title: '\u03bb max', number: true },
    { title: 'Lower bound', number: true },
    { title: 'Upper bound', number: true },
    { title: 'Unit', tight: true },
    { title: 'Note' },
  ];
  const { factors } = report.assessment.lot;
  const spreadOf = (source) =>
    source.startsWith('statistical, system') ? 'the system' : source === 'contract band' ? DASH : 'one device';
  const rows = factors.map((factor, i) => {
    const first = i === 0 || factors[i - 1].property !== factor.property;
    return {
      className: first ? 'group' : null,
      cells: [
        element('b', { class: 'strong' }, first ? factor.property : ''),
        factor.source,
        spreadOf(factor.source),
        fixed(factor.lambda_min, 3),
        fixed(factor.lambda_max, 3),
        significant(factor.lower, 4),
        significant(factor.upper, 4),
        unitText(factor.unit),
        element('td', { class: 'note text' }, [factor.note, factor.no_lower_bound].filter(Boolean).join('; ')),
      ],
    };
  });
  return table(columns, rows, 'Property modification factors');
}

function factorData() {
  const keys = [
    'property',
    'source',
    'spec_min',
    'spec_max',
    'lambda_min',
    'lambda_max',
    'lower',
    'upper',
    'unit',
    'note',
    'no_lower_bound',
  ];
  return { columns: keys, rows: report.assessment.lot.factors.map((factor) => keys.map((key) => factor[key])) };
}
