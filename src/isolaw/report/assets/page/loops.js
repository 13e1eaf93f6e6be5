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
    id: 'loop-overview',
    title: 'All laws on this device',
    depends: ['device'],
    wanted: () => chosen.device !== null,
    caption: () =>
      'The best fit of each law (coloured) over the measured loop of ' +
      devices[chosen.device].name +
      ' (grey), in one scale, the smallest objective first.',
    csv: () => loopData(laws),
    height: (width) => overviewGrid(fitsOn(devices[chosen.device], laws).length, width).height,
    draw: drawOverview,
  },
]);


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
  !device.scored || device.scored.some(([first, last]) => time >= first && time <= last);

// A line cut in two: where `inside` holds, and the rest; both reach the sample at which it changes.
function parted(values, inside) {
  const near = (i, wanted) => inside[i] === wanted || inside[i - 1] === wanted || inside[i + 1] === wanted;
  return {
    inside: values.map((value, i) => (near(i, true) ? value : null)),
    outside: values.map((value, i) => (inside[i] ? null : value)),
  };
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
      shapes: (device.scored ?? []).map(([x0, x1]) => scoredShape(look, x0, x1)),
      xaxis: { title: device.record.has_time ? 'time [s]' : 'sample', anchor: 'y2' },
      yaxis: { title: 'force [kN]', domain: [0.38, 1] },
      yaxis2: { title: 'residual [kN]', domain: [0, 0.3] },
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
  const fits = fitsOn(device, laws).sort(
    (a, b) => (a.fit.objective.best ?? Infinity) - (b.fit.objective.best ?? Infinity),
  );
  const { columns, wide, panel, heading, between, height } = overviewGrid(fits.length, width);
  const plotHeight = height - OVERVIEW_MARGIN.t - OVERVIEW_MARGIN.b;
  const forces = [measured.F, ...fits.map(({ force }) => force)];
  const low = Math.min(...forces.map((f) => Math.min(...f))),
    high = Math.max(...forces.map((f) => Math.max(...f))),
    margin = 0.06 * (high - low || 1);
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
      range: [low - margin, high + margin],
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
