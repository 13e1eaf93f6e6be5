// Loops

const LOOP_HEIGHT = 400;

section({ id: 'loops', title: 'Loops', controls: loopControls, laws: true }, [
  {
    id: 'loop',
    width: 'narrow',
    title: 'Force over displacement',
    depends: ['device', 'laws'],
    wanted: () => chosen.device !== null,
    caption: loopCaption,
    csv: loopData,
    height: () => LOOP_HEIGHT,
    draw: drawLoop,
  },
  {
    id: 'history',
    width: 'wide',
    title: 'Force over time, and what is left unexplained',
    depends: ['device', 'laws'],
    wanted: () => chosen.device !== null,
    caption: historyCaption,
    csv: loopData,
    height: () => LOOP_HEIGHT,
    draw: drawHistory,
  },
  {
    id: 'fits',
    title: 'All laws on this device',
    depends: ['device', 'order'],
    wanted: () => chosen.device !== null,
    caption: () =>
      'Best run of each law on ' +
      devices[chosen.device].name +
      ': its objective, and its effective stiffness, dissipated energy and damping against the record, on the third counted cycle of the largest amplitude.' +
      onScreen(' The heads of the columns sort; the loops below follow.'),
    csv: fitData,
    build: fitTable,
  },
  {
    id: 'loop-overview',
    title: '',
    depends: ['device', 'order'],
    wanted: () => chosen.device !== null,
    caption: () =>
      'The best fit of each law (coloured) over the measured loop of ' +
      devices[chosen.device].name +
      ' (grey), in one scale, ' +
      ORDERS.find((order) => order.key === chosen.order).first +
      ' first.' +
      cutOff(laws),
    csv: () => loopData(laws),
    height: (width) => overviewGrid(fitsOn(devices[chosen.device], laws).length, width).height,
    draw: drawOverview,
  },
  {
    id: 'cleaning',
    title: 'Displacement over time, as recorded and as the laws saw it',
    depends: ['device'],
    wanted: () => drawable.some((device) => device.raw?.samples > 0),
    caption: cleaningCaption,
    csv: cleaningData,
    height: () => 300,
    draw: drawCleaning,
  },
]);

// What the laws on a device can be sorted by; `of` is smaller the better.
const ORDERS = [
  { key: 'objective', title: 'best OF', unit: '-', first: 'the smallest objective', of: (fit) => fit.objective.best },
  {
    key: 'K_eff_error_percent',
    title: 'stiffness error',
    unit: '%',
    first: 'the smallest error of stiffness',
    of: (fit) => absolute(fit.K_eff_error_percent),
  },
  {
    key: 'energy_error_percent',
    title: 'energy error',
    unit: '%',
    first: 'the smallest error of energy',
    of: (fit) => absolute(fit.energy_error_percent),
  },
  {
    key: 'damping_error_percent',
    title: 'damping error',
    unit: '%',
    first: 'the smallest error of damping',
    of: (fit) => absolute(fit.damping_error_percent),
  },
];
const absolute = (value) => (isNumber(value) ? Math.abs(value) : null);

// Laws on the chosen device in the chosen order, what has no value last.
function inOrder(fits) {
  const { of } = ORDERS.find((order) => order.key === chosen.order);
  return [...fits].sort((a, b) => (of(a.fit) ?? Infinity) - (of(b.fit) ?? Infinity));
}

// What follows a choice made elsewhere: controls that show the same choice.
const followers = [];

// One device for the whole page; what cannot be shown of it stays with the device before.
function chooseDevice(index, changes = {}) {
  if (drawable.some((device) => device.index === index)) changes.device = index;
  if (tested.some((device) => device.index === index)) {
    changes.tested = index;
    if (!devices[index].blocks.some((block) => block.number === chosen.block)) changes.block = 'all';
  }
  choose(changes);
}

function deviceChooser(id, among, key) {
  const select = element(
    'select',
    { id },
    ...among.map((device) =>
      element('option', { value: device.index, selected: device.index === chosen[key] }, device.name),
    ),
  );
  select.addEventListener('change', () => chooseDevice(Number(select.value)));
  followers.push(() => (select.value = chosen[key]));
  return element('label', {}, 'Device', select);
}

function loopControls() {
  if (drawable.length === 0) return [element('p', { class: 'empty' }, 'No record could be used.')];
  const boxes = ranking.map((law) => {
    const box = element('input', { type: 'checkbox', value: law.index, checked: chosen.laws.has(law.index) });
    box.addEventListener('change', () => {
      box.checked ? chosen.laws.add(law.index) : chosen.laws.delete(law.index);
      choose({ laws: chosen.laws });
    });
    return element('label', {}, box, lawKey(law), law.id);
  });
  return [
    deviceChooser('device', drawable, 'device'),
    element('fieldset', {}, element('legend', {}, 'Laws'), ...boxes),
  ];
}

// The chosen laws that have a curve on the chosen device, with it.
function fitsOn(device, among) {
  return among
    .map((law) => ({ law, fit: law.fitOn.get(device.index), force: curve(law.fitOn.get(device.index)?.force_kN) }))
    .filter((entry) => entry.force);
}
const chosenLaws = () => ranking.filter((law) => chosen.laws.has(law.index));
const record = (device) => ({
  t: curve(device.record.time_s),
  x: curve(device.record.disp_mm),
  F: curve(device.record.force_kN),
});

// Whether a time of the record lies in a part the laws were judged by.
const isScored = (device, time) =>
  !device.scored || device.scored.some(({ from, to }) => time >= from && time <= to);

// A line cut in two: where `inside` holds, and the rest; both reach the sample at which it changes.
function parted(values, inside) {
  const near = (i, wanted) => inside[i] === wanted || inside[i - 1] === wanted || inside[i + 1] === wanted;
  return {
    inside: values.map((value, i) => (near(i, true) ? value : null)),
    outside: values.map((value, i) => (inside[i] ? null : value)),
  };
}

// The scale of the forces is that of the record, with half of it to spare: a law that runs away is cut off.
function forceRange(measured, computed) {
  const low = Math.min(...measured),
    high = Math.max(...measured),
    spare = 0.5 * (high - low || 1);
  const all = computed.flatMap((force) => [Math.min(...force), Math.max(...force)]).concat(low, high);
  return paddedRange(
    all.map((force) => Math.min(Math.max(force, low - spare), high + spare)),
    0.06,
  );
}

const chosenForces = () => fitsOn(devices[chosen.device], chosenLaws()).map(({ force }) => force);

function residualAxis(measured, fits) {
  const most = 0.75 * (Math.max(...measured) - Math.min(...measured) || 1);
  const away = fits.some(({ force }) => force.some((f, i) => Math.abs(measured[i] - f) > most));
  return away ? { range: [-most, most] } : {};
}

// Laws whose force leaves the scale, and how far they go.
function cutOff(among) {
  const device = devices[chosen.device],
    { F } = record(device);
  const fits = fitsOn(device, among),
    [low, high] = forceRange(
      F,
      fits.map(({ force }) => force),
    );
  const away = fits.filter(({ force }) => force.some((f) => f < low || f > high));
  if (away.length === 0) return '';
  const largest = ({ law, force }) => law.id + ' to ' + significant(Math.max(...force.map(Math.abs)), 2) + THIN + 'kN';
  return ' Off the scale: ' + enumerate(away.map(largest)) + '.';
}

function loopData(among = chosenLaws()) {
  const device = devices[chosen.device],
    measured = record(device),
    fits = fitsOn(device, among);
  return {
    columns: [
      device.record.has_time ? 'time [s]' : 'sample',
      'displacement [mm]',
      'measured force [kN]',
      ...fits.map(({ law }) => law.id + ' force [kN]'),
    ],
    rows: measured.x.map((x, i) => [measured.t[i], x, measured.F[i], ...fits.map(({ force }) => force[i])]),
  };
}

function loopCaption() {
  const device = devices[chosen.device];
  const missing = chosenLaws().filter((law) => !law.fitOn.get(device.index)?.force_kN);
  const said = fitsOn(device, chosenLaws()).map(
    ({ law, fit }) =>
      law.id +
      ': OF ' +
      fixed(fit.objective.best, 4) +
      ', effective stiffness ' +
      signed(fit.K_eff_error_percent, 1) +
      THIN +
      '%, energy ' +
      signed(fit.energy_error_percent, 1) +
      THIN +
      '%, damping ' +
      signed(fit.damping_error_percent, 1) +
      THIN +
      '%',
  );
  const partly = device.scored
    ? ' The laws were judged by the part of the record drawn solid; dotted, it acts on their state alone.'
    : '';
  const thinned =
    device.record.drawn < device.record.samples
      ? ' Drawn: ' + device.record.drawn + ' of ' + device.record.samples + ' samples.'
      : '';
  return (
    device.name +
    ', measured (grey) and best fits. ' +
    said.join('; ') +
    (said.length > 0 ? '.' : onScreen('Choose a law above.')) +
    missing
      .map(
        (law) =>
          ' ' +
          law.id +
          ' has no fit here' +
          (law.fitOn.get(device.index)?.message ? ' (' + law.fitOn.get(device.index).message + ')' : '') +
          '.',
      )
      .join('') +
    partly +
    cutOff(chosenLaws()) +
    thinned
  );
}

function historyCaption() {
  const device = devices[chosen.device],
    measured = record(device);
  const peak = Math.max(...measured.F.map(Math.abs));
  const scored = measured.t.map((t) => isScored(device, t));
  const worst = fitsOn(device, chosenLaws()).map(
    ({ law, force }) =>
      law.id +
      ' ' +
      significant(Math.max(...force.map((f, i) => (scored[i] ? Math.abs(measured.F[i] - f) : 0))), 3) +
      THIN +
      'kN',
  );
  return (
    'Residual: measured minus computed force. What repeats from cycle to cycle is the law\u2019s own error, what fades is scragging the law does not know.' +
    (worst.length > 0
      ? ' Largest residual: ' + worst.join(', ') + '; peak force ' + significant(peak, 3) + THIN + 'kN.'
      : '') +
    (device.scored ? ' Shaded: the part the laws were judged by, the residuals named here among it.' : '')
  );
}

function drawLoop(look) {
  const device = devices[chosen.device],
    measured = record(device);
  const halves = parted(
    measured.F,
    measured.t.map((t) => isScored(device, t)),
  );
  return {
    traces: [
      ...(device.scored
        ? [
            {
              name: 'measured, not judged',
              mode: 'lines',
              x: measured.x,
              y: halves.outside,
              line: { color: look.colour('measured'), width: 1.6, dash: 'dot' },
              hovertemplate: '%{x:.1f} mm, %{y:.1f} kN<extra>measured, not judged</extra>',
            },
          ]
        : []),
      {
        name: 'measured',
        mode: 'lines',
        x: measured.x,
        y: halves.inside,
        line: { color: look.colour('measured'), width: 3.5 },
        opacity: 0.75,
        hovertemplate: '%{x:.1f} mm, %{y:.1f} kN<extra>measured</extra>',
      },
      ...fitsOn(device, chosenLaws()).map(({ law, force }, place) => ({
        name: plain(law.id),
        mode: 'lines',
        x: measured.x,
        y: force,
        line: { color: look.law(law), width: 1.8, dash: dashOf(place) },
        hovertemplate: '%{x:.1f} mm, %{y:.1f} kN<extra>' + plain(law.id) + '</extra>',
      })),
    ],
    layout: { showlegend: true, xaxis: { title: 'displacement [mm]' }, yaxis: { title: 'force [kN]' } },
  };
}

// The part the laws were judged by, over the whole height of a plot.
const scoredShape = (look, x0, x1) => ({
  type: 'rect',
  layer: 'below',
  yref: 'paper',
  x0,
  x1,
  y0: 0,
  y1: 1,
  line: { width: 0 },
  fillcolor: look.colour('scored'),
});

function drawHistory(look) {
  const device = devices[chosen.device],
    measured = record(device);
  const fits = fitsOn(device, chosenLaws());
  return {
    traces: [
      {
        name: 'measured',
        mode: 'lines',
        x: measured.t,
        y: measured.F,
        line: { color: look.colour('measured'), width: 3.5 },
        opacity: 0.75,
        hovertemplate: '%{y:.1f} kN<extra>measured</extra>',
      },
      ...fits.map(({ law, force }, place) => ({
        name: plain(law.id),
        mode: 'lines',
        x: measured.t,
        y: force,
        line: { color: look.law(law), width: 1.8, dash: dashOf(place) },
        hovertemplate: '%{y:.1f} kN<extra>' + plain(law.id) + '</extra>',
      })),
      ...fits.map(({ law, force }, place) => ({
        mode: 'lines',
        x: measured.t,
        y: force.map((f, i) => measured.F[i] - f),
        yaxis: 'y2',
        showlegend: false,
        line: { color: look.law(law), width: 1.4, dash: dashOf(place) },
        hovertemplate: 'residual %{y:.1f} kN<extra>' + plain(law.id) + '</extra>',
      })),
    ],
    layout: {
      showlegend: true,
      hovermode: 'x unified',
      shapes: (device.scored ?? []).map(({ from, to }) => scoredShape(look, from, to)),
      xaxis: { title: device.record.has_time ? 'time [s]' : 'sample', anchor: 'y2' },
      yaxis: { title: 'force [kN]', domain: [0.38, 1], range: forceRange(measured.F, chosenForces()) },
      yaxis2: { title: 'residual [kN]', domain: [0, 0.3], ...residualAxis(measured.F, fits) },
    },
  };
}

// The small multiples in pixels: panels of one size under a heading each, as many beside one another as fit.
const OVERVIEW_MARGIN = { l: 50, r: 8, t: 8, b: 44 };
function overviewGrid(panels, width) {
  const columns = Math.max(1, Math.min(panels, width > 900 ? 4 : width > 560 ? 3 : 2));
  const rows = Math.max(1, Math.ceil(panels / columns)),
    wide = width / columns > 240;
  const panel = wide ? 190 : 150,
    heading = 22,
    between = 46;
  return {
    columns,
    wide,
    panel,
    heading,
    between,
    height: OVERVIEW_MARGIN.t + heading + rows * panel + (rows - 1) * between + OVERVIEW_MARGIN.b,
  };
}

function drawOverview(look, width) {
  const device = devices[chosen.device],
    measured = record(device);
  const fits = inOrder(fitsOn(device, laws));
  const { columns, wide, panel, heading, between, height } = overviewGrid(fits.length, width);
  const plotHeight = height - OVERVIEW_MARGIN.t - OVERVIEW_MARGIN.b;
  const [low, high] = forceRange(
    measured.F,
    fits.map(({ force }) => force),
  );
  const layout = { margin: OVERVIEW_MARGIN, annotations: [] };
  const traces = [];
  fits.forEach(({ law, fit, force }, i) => {
    const column = i % columns,
      row = Math.floor(i / columns),
      suffix = i === 0 ? '' : String(i + 1);
    const gap = 0.035,
      w = (1 - gap * (columns - 1)) / columns;
    const left = column * (w + gap),
      h = panel / plotHeight,
      top = 1 - (heading + row * (panel + between)) / plotHeight;
    const lowest = i + columns >= fits.length;
    layout['xaxis' + suffix] = {
      domain: [left, left + w],
      anchor: 'y' + suffix,
      nticks: wide ? 6 : 4,
      tickangle: 0,
      title: lowest ? 'mm' : '',
      matches: i > 0 ? 'x' : undefined,
      showticklabels: lowest,
    };
    layout['yaxis' + suffix] = {
      domain: [top - h, top],
      anchor: 'x' + suffix,
      nticks: 5,
      range: [low, high],
      title: column === 0 ? 'kN' : '',
      matches: i > 0 ? 'y' : undefined,
      showticklabels: column === 0,
    };
    layout.annotations.push({
      xref: 'paper',
      yref: 'paper',
      x: left,
      y: top,
      xanchor: 'left',
      yanchor: 'bottom',
      showarrow: false,
      align: 'left',
      text: '<b>' + plain(law.id) + '</b>  OF ' + fixed(fit.objective.best, 4),
      font: { size: 12, color: look.colour('ink') },
    });
    const axes = { xaxis: 'x' + suffix, yaxis: 'y' + suffix, mode: 'lines', showlegend: false };
    traces.push({
      ...axes,
      x: measured.x,
      y: measured.F,
      hoverinfo: 'skip',
      opacity: 0.75,
      line: { color: look.colour('measured'), width: 2.6 },
    });
    traces.push({
      ...axes,
      x: measured.x,
      y: force,
      line: { color: look.law(law), width: 1.5 },
      hovertemplate: '%{x:.1f} mm, %{y:.1f} kN<extra>' + plain(law.id) + '</extra>',
    });
  });
  return { traces, layout };
}

function sortHead(order) {
  const current = order.key === chosen.order;
  const button = element(
    'button',
    { type: 'button', class: 'sort', id: 'sort-' + order.key },
    order.title + (current ? '\u202f\u25b4' : ''),
  );
  button.addEventListener('click', () => {
    choose({ order: order.key });
    document.getElementById('sort-' + order.key)?.focus(); // the table was built anew
  });
  return { title: button, unit: order.unit, number: true, sorted: current };
}

function fitTable() {
  const device = devices[chosen.device];
  const fits = inOrder(
    laws.map((law) => ({ law, fit: law.fitOn.get(device.index) })).filter(({ fit }) => fit),
  );
  const remarks = fits.some(({ fit }) => fit.message);
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    ...ORDERS.map(sortHead),
    { title: 'mean OF \u00b1 std', unit: 'over the runs', number: true },
    { title: 'runs', number: true },
    { title: 'parameter sets', unit: 'tried', number: true, screen: true },
    ...(remarks ? [{ title: 'Remark' }] : []),
  ];
  const rows = fits.map(({ law, fit }) => ({
    cells: [
      lawName(law),
      fixed(fit.objective.best, 4),
      signed(fit.K_eff_error_percent, 1),
      signed(fit.energy_error_percent, 1),
      signed(fit.damping_error_percent, 1),
      objectiveText(fit.objective),
      String(fit.runs) + (fit.failed_runs > 0 ? ', ' + fit.failed_runs + ' failed' : ''),
      significant(fit.evaluations, 3),
      ...(remarks ? [element('td', { class: 'note text' }, fit.message)] : []),
    ],
  }));
  return table(columns, rows, 'All laws on the chosen device');
}

function fitData() {
  return {
    columns: [
      'law', 'device', 'best OF [-]', 'mean OF [-]', 'std OF [-]', 'K_eff error [%]', 'energy error [%]', 'damping error [%]',
      'runs', 'failed runs', 'evaluations', 'message',
    ],
    rows: laws.flatMap((law) =>
      law.devices.map((fit) => [
        law.id, devices[fit.device].name, fit.objective.best, fit.objective.mean, fit.objective.std,
        fit.K_eff_error_percent, fit.energy_error_percent, fit.damping_error_percent,
        fit.runs, fit.failed_runs, fit.evaluations, fit.message,
      ]),
    ),
  };
}

// --- the record before and after cleaning

function cleaningCaption() {
  const device = devices[chosen.device];
  return (
    device.name + ': ' + device.raw.samples + ' samples as recorded, ' + device.record.samples + ' as the laws saw them. ' +
    (device.cleaning.length > 0 ? 'Done to it: ' + sentence(device.cleaning.join('; ')) + '.' : 'Nothing was changed.')
  );
}

function cleaningData() {
  const device = devices[chosen.device],
    axis = rawTime(device),
    measured = record(device),
    raw = curve(device.raw.disp_mm);
  return {
    columns: ['series', axis.timed ? 'time [s]' : 'sample', 'displacement [mm]'],
    rows: [
      ...raw.map((x, k) => ['as recorded', axis.of(rawIndex(device.raw, k)), x]),
      ...measured.x.map((x, k) => ['as the laws saw it', axis.fromRecord(measured.t[k]), x]),
    ],
  };
}

function drawCleaning(look) {
  const device = devices[chosen.device],
    axis = rawTime(device),
    measured = record(device),
    raw = curve(device.raw.disp_mm);
  const hover = axis.timed ? '%{x:.3f} s, %{y:.2f} mm' : 'sample %{x}, %{y:.2f} mm';
  return {
    traces: [
      {
        name: 'as recorded',
        mode: 'lines',
        x: raw.map((_, k) => axis.of(rawIndex(device.raw, k))),
        y: raw,
        line: { color: look.colour('measured'), width: 3 },
        opacity: 0.7,
        hovertemplate: hover + '<extra>as recorded</extra>',
      },
      {
        name: 'as the laws saw it',
        mode: 'lines',
        x: measured.t.map((t) => axis.fromRecord(t)),
        y: measured.x,
        line: { color: look.colour('accent'), width: 1.2 },
        hovertemplate: hover + '<extra>as the laws saw it</extra>',
      },
    ],
    layout: {
      showlegend: true,
      xaxis: { title: axis.title, zeroline: false },
      yaxis: { title: 'displacement [mm]' },
    },
  };
}
