// Properties: the cycles of one device

section({ id: 'properties', title: 'Properties', controls: propertyControls }, [
  {
    id: 'warnings',
    title: '', // with laws they stand under the decision
    wanted: () => inspection && report.findings.warnings.length > 0,
    build: takeCare,
  },
  {
    id: 'cycles',
    width: 'wide',
    title: 'Loops, cycle by cycle',
    depends: ['tested', 'block'],
    wanted: () => chosen.tested !== null,
    caption: cyclesCaption,
    csv: rawData,
    height: () => CYCLES_HEIGHT,
    draw: drawCycles,
  },
  {
    id: 'stability',
    width: 'narrow',
    title: 'Stability from cycle to cycle',
    depends: ['tested', 'block'],
    wanted: () => chosen.tested !== null,
    caption: stabilityCaption,
    csv: stabilityData,
    height: () => CYCLES_HEIGHT,
    draw: drawStability,
  },
  {
    id: 'cycle-history',
    title: 'Displacement history with blocks and cycles',
    depends: ['tested'],
    wanted: () => chosen.tested !== null,
    caption: cycleHistoryCaption,
    csv: rawData,
    height: () => 320,
    draw: drawCycleHistory,
  },
  {
    id: 'cycle-table',
    title: 'Properties of every cycle',
    long: true,
    depends: ['tested'],
    wanted: () => chosen.tested !== null,
    caption: cycleTableCaption,
    csv: () => cycleData([devices[chosen.tested]]),
    build: cycleTable,
  },
  {
    id: 'assessments',
    title: 'Against the rule set',
    long: true,
    depends: ['tested'],
    wanted: () => chosen.tested !== null && devices.some((device) => device.assessments.length > 0),
    caption: () =>
      devices[chosen.tested].name +
      ' alone; the lot follows below.' +
      (isVerified() ? '' : ' Deviations are information, no verdict.'),
    csv: () => assessmentData([devices[chosen.tested]]),
    build: assessmentTable,
  },
]);

const CYCLES_HEIGHT = 470,
  NARROW = 620;

// Every number of a cycle: its key in the data, its heading, and how it reads.
const CYCLE_COLUMNS = [
  { key: 'amplitude_mm', title: 'Amplitude', unit: 'mm', text: (v) => fixed(v, 1) },
  { key: 'd_plus_mm', title: 'd+', unit: 'mm', text: (v) => fixed(v, 1), csvOnly: true },
  { key: 'd_minus_mm', title: 'd\u2212', unit: 'mm', text: (v) => fixed(v, 1), csvOnly: true },
  { key: 'F_plus_kN', title: 'F+', unit: 'kN', text: (v) => fixed(v, 1), screen: true },
  { key: 'F_minus_kN', title: 'F\u2212', unit: 'kN', text: (v) => fixed(v, 1), screen: true },
  { key: 'K_eff_kN_per_mm', title: 'K_eff', unit: 'kN/mm', text: (v) => significant(v, 4) },
  { key: 'K_plus_kN_per_mm', title: 'K+', unit: 'kN/mm', text: (v) => significant(v, 4), screen: true },
  { key: 'K_minus_kN_per_mm', title: 'K\u2212', unit: 'kN/mm', text: (v) => significant(v, 4), screen: true },
  { key: 'energy_kN_mm', title: 'Energy', unit: 'kN mm', text: (v) => fixed(v, 0) },
  { key: 'damping_percent', title: 'Damping', unit: '%', text: (v) => fixed(v, 2) },
  { key: 'Q_d_kN', title: 'Q_d', unit: 'kN', text: (v) => fixed(v, 1) },
  { key: 'K_d_kN_per_mm', title: 'K_d', unit: 'kN/mm', text: (v) => significant(v, 3) },
  { key: 'D_y_mm', title: 'D_y', unit: 'mm', text: (v) => fixed(v, 2), csvOnly: true },
  { key: 'K_1_kN_per_mm', title: 'K_1', unit: 'kN/mm', text: (v) => significant(v, 3), csvOnly: true },
  { key: 'period_s', title: 'Period', unit: 's', text: (v) => significant(v, 3), csvOnly: true },
  { key: 'v_max_mm_s', title: 'v_max', unit: 'mm/s', text: (v) => significant(v, 3), screen: true },
  { key: 'N_mean_kN', title: 'N mean', unit: 'kN', text: (v) => fixed(v, 0), screen: true },
  { key: 'N_min_kN', title: 'N min', unit: 'kN', text: (v) => fixed(v, 0), csvOnly: true },
  { key: 'N_max_kN', title: 'N max', unit: 'kN', text: (v) => fixed(v, 0), csvOnly: true },
  { key: 'strain_percent', title: 'Strain', unit: '%', text: (v) => fixed(v, 0) },
  { key: 'G_MPa', title: 'G', unit: 'MPa', text: (v) => significant(v, 3) },
  { key: 'closure_mm', title: 'Closure d', unit: 'mm', text: (v) => significant(v, 2), csvOnly: true },
  { key: 'closure_kN', title: 'Closure F', unit: 'kN', text: (v) => significant(v, 2), csvOnly: true },
];

// The three properties that are followed from cycle to cycle: their key in a cycle, in `stability` and in rule sets.
const FOLLOWED = [
  { key: 'K_eff_kN_per_mm', name: 'K_eff', title: 'K_eff [kN/mm]', text: (v) => significant(v, 4) + THIN + 'kN/mm' },
  { key: 'damping_percent', name: 'damping', title: 'damping [%]', text: (v) => fixed(v, 2) + THIN + '%' },
  { key: 'energy_kN_mm', name: 'energy', title: 'energy [kN mm]', text: (v) => fixed(v, 0) + THIN + 'kN mm' },
];

const counted = (block) => block.cycles.filter((cycle) => cycle.counts);
const countedCycles = (device) => device.blocks.flatMap(counted);
const largestNumber = (device) => Math.max(1, ...countedCycles(device).map((cycle) => cycle.number));
const chosenBlocks = (device) =>
  device.blocks.filter((block) => chosen.block === 'all' || block.number === chosen.block);

function blockText(block) {
  return (
    'block ' +
    block.number +
    ', ±' +
    significant(block.amplitude_mm, 3) +
    THIN +
    'mm' +
    (isNumber(block.frequency_Hz) ? ', ' + significant(block.frequency_Hz, 2) + THIN + 'Hz' : '') +
    (block.waveform ? ', ' + block.waveform : '')
  );
}
const cycleText = (block, cycle) =>
  'block ' + block.number + ', ' + (cycle.counts ? 'cycle ' + cycle.number : 'not counted: ' + cycle.reason);

function propertyControls() {
  const select = element('select', { id: 'block' });
  const fill = () => {
    const blocks = devices[chosen.tested]?.blocks ?? [];
    select.replaceChildren(
      element('option', { value: 'all' }, 'all'),
      ...blocks.map((block) => element('option', { value: block.number }, blockText(block))),
    );
    select.value = chosen.block;
    select.disabled = blocks.length < 2;
  };
  fill();
  let shown = chosen.tested;
  followers.push(() => {
    if (shown !== chosen.tested) fill();
    shown = chosen.tested;
    select.value = chosen.block;
  });
  select.addEventListener('change', () => choose({ block: select.value === 'all' ? 'all' : Number(select.value) }));
  return tested.length === 0
    ? [element('p', { class: 'empty' }, 'No record could be read.')]
    : [deviceChooser('tested', tested, 'tested'), element('label', {}, 'Block', select)];
}

// The colour of a cycle on its way from the first one, 0, to the last, 1.
function cycleScale(look) {
  const stops = ['first', 'middle', 'last'].map((name) =>
    [1, 3, 5].map((i) => parseInt(look.colour('cycle-' + name).slice(i, i + 2), 16)),
  );
  return (share) => {
    const [from, to] = share < 0.5 ? [stops[0], stops[1]] : [stops[1], stops[2]];
    const way = share < 0.5 ? 2 * share : 2 * share - 1;
    return 'rgb(' + from.map((c, i) => Math.round(c + way * (to[i] - c))).join(',') + ')';
  };
}
const shareOf = (cycle, largest) => (largest > 1 ? (cycle.number - 1) / (largest - 1) : 1);

const rawIndex = (raw, k) => Math.min(k * raw.stride, raw.samples - 1);

// The samples of a curve of the raw record from one fractional sample index to another, the ends interpolated.
function slice(raw, values, first, last) {
  const at = (index) => {
    const k = Math.min(Math.max(0, Math.floor(index / raw.stride)), values.length - 2);
    const from = rawIndex(raw, k),
      to = rawIndex(raw, k + 1);
    return values[k] + ((index - from) / (to - from || 1)) * (values[k + 1] - values[k]);
  };
  if (values.length < 2) return [...values];
  const inside = values.filter((_, k) => rawIndex(raw, k) > first && rawIndex(raw, k) < last);
  return [at(first), ...inside, at(last)];
}

// From raw sample indices to what the record's time_s holds and back. Evenly sampled, as recording machines do.
// Where a raw sample lies on the time axis; without time the axis counts samples, as the record the laws saw does.
function rawTime(device) {
  const { raw } = device;
  const t = raw?.time_s ? curve(raw.time_s) : null;
  const timed = t !== null && t.length > 1;
  const between = (index) => {
    const k = Math.min(Math.floor(index / raw.stride), t.length - 2);
    const from = rawIndex(raw, k),
      to = rawIndex(raw, k + 1);
    return t[k] + ((index - from) / (to - from)) * (t[k + 1] - t[k]);
  };
  return {
    timed,
    title: timed ? 'time [s]' : 'sample',
    of: (index) => (timed ? between(index) : index),
    fromRecord: (time) => time,
  };
}

function rawData() {
  const device = devices[chosen.tested],
    raw = device.raw,
    axis = rawTime(device);
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  let position = 0;
  const spans = device.blocks.flatMap((block) => block.cycles.map((cycle) => ({ block, cycle })));
  return {
    columns: ['sample', ...(axis.timed ? ['time [s]'] : []), 'displacement [mm]', 'force [kN]', 'block', 'cycle'],
    rows: x.map((value, k) => {
      const index = rawIndex(raw, k);
      while (position < spans.length && spans[position].cycle.last < index) ++position;
      const span = spans[position];
      const inside = span !== undefined && index >= span.cycle.first;
      return [
        index,
        ...(axis.timed ? [axis.of(index)] : []),
        value,
        F[k],
        inside ? span.block.number : null,
        inside && span.cycle.counts ? span.cycle.number : null,
      ];
    }),
  };
}

function cyclesCaption() {
  const device = devices[chosen.tested],
    blocks = chosenBlocks(device);
  const uncounted = blocks.flatMap((block) => block.cycles).filter((cycle) => !cycle.counts).length;
  if (device.blocks.length === 0) return device.name + ', as recorded. No cycles: ' + noCycles(device);
  return (
    device.name +
    ', raw values' +
    (device.corrections.length > 0 ? ' after ' + count(device.corrections.length, 'correction') : '') +
    '. The number stands at the positive peak of each loop' +
    (blocks.length > 1 ? ', block and cycle' : '') +
    '; the colour runs from the first cycle (orange) to the last (blue).' +
    (uncounted > 0
      ? ' Dashed: ' + count(uncounted, 'cycle') + ' that ' + (uncounted === 1 ? 'does' : 'do') + ' not count.'
      : '') +
    (device.raw.stride > 1 ? ' Drawn: one sample in ' + device.raw.stride + '.' : '')
  );
}
const noCycles = (device) => device.properties_refusal || device.message || 'none was found';

// Places of least movement for labels that are `gap` apart at least, between `low` and `high`; `wanted` ascends.
function spread(wanted, gap, low, high) {
  const most = high - (wanted.length - 1) * gap;
  const groups = [];
  wanted.forEach((value, i) => {
    groups.push({ sum: Math.max(low, Math.min(most, value - i * gap)), size: 1 });
    while (groups.length > 1) {
      const [before, last] = groups.slice(-2);
      if (before.sum / before.size <= last.sum / last.size) break;
      groups.splice(-2, 2, { sum: before.sum + last.sum, size: before.size + last.size });
    }
  });
  return groups.flatMap((group) => Array(group.size).fill(group.sum / group.size)).map((value, i) => value + i * gap);
}

// Numbers of the loops, joined to their positive peaks: those of the outermost peaks in the margin at the right, the
// others up and left of their peaks, where a hysteresis loop leaves room. `pixel` gives the place of a peak.
function peakLabels(labels, pixel, room, height) {
  const gap = 15,
    columns = [];
  for (const label of labels.map((l) => ({ ...l, at: pixel(l.x, l.y) })).sort((a, b) => a.at[0] - b.at[0])) {
    const column = columns[columns.length - 1];
    if (column && label.at[0] - column[column.length - 1].at[0] < 40) column.push(label);
    else columns.push([label]);
  }
  return columns.flatMap((column, place) => {
    const outermost = place === columns.length - 1;
    column.sort((a, b) => a.at[1] - b.at[1]);
    const needed = 8 + (column.length - 1) * gap;
    const bottom = outermost
      ? height - 8
      : Math.max(column[0].at[1] - 12, Math.min(needed, column[column.length - 1].at[1] + 12));
    const most = Math.max(2, Math.floor((bottom - 8) / gap) + 1);
    const every = Math.ceil(column.length / most);
    const named = column.filter((label) => every === 1 || label.number % every === 1 % every);
    const wanted = outermost ? named.map((l) => l.at[1]) : named.map((_, i) => bottom - (named.length - 1 - i) * gap);
    const places = spread(wanted, gap, 8, bottom);
    const edge = outermost
      ? Math.max(...column.map((l) => l.at[0])) + room
      : Math.min(...column.map((l) => l.at[0])) - 26;
    return named.map((label, i) => ({
      x: label.x,
      y: label.y,
      ax: edge - label.at[0],
      ay: places[i] - label.at[1],
      text: label.text,
      xanchor: outermost ? 'left' : 'right',
      color: label.color,
    }));
  });
}

function drawCycles(look, width) {
  const device = devices[chosen.tested],
    raw = device.raw,
    colour = cycleScale(look),
    largest = largestNumber(device);
  const x = curve(raw.disp_mm),
    F = curve(raw.force_kN);
  const blocks = chosenBlocks(device);
  const hover = (name) => '%{x:.1f} mm, %{y:.1f} kN<extra>' + plain(name) + '</extra>';
  const traces = [],
    labels = [];
  if (device.blocks.length === 0)
    traces.push({
      mode: 'lines',
      x,
      y: F,
      line: { color: look.colour('measured'), width: 1.4 },
      hovertemplate: hover('no cycle'),
    });
  for (const block of blocks) {
    for (const cycle of [...block.cycles].sort((a, b) => a.number - b.number)) {
      const share = shareOf(cycle, largest);
      traces.push({
        mode: 'lines',
        x: slice(raw, x, cycle.first, cycle.last),
        y: slice(raw, F, cycle.first, cycle.last),
        line: cycle.counts
          ? { color: colour(share), width: 1.6 }
          : { color: look.colour('muted'), width: 1.2, dash: 'dash' },
        hovertemplate: hover(cycleText(block, cycle)),
      });
      if (cycle.counts && isNumber(cycle.d_plus_mm) && isNumber(cycle.F_plus_kN))
        labels.push({
          x: cycle.d_plus_mm,
          y: cycle.F_plus_kN,
          number: cycle.number,
          text: (blocks.length > 1 ? block.number + '\u00b7' : '') + cycle.number,
          color: colour(share),
        });
    }
  }
  const xs = traces.flatMap((trace) => trace.x),
    ys = traces.flatMap((trace) => trace.y);
  const margin = { l: 58, r: 10, t: 26, b: 44 };
  const plotWidth = width - margin.l - margin.r,
    plotHeight = CYCLES_HEIGHT - margin.t - margin.b;
  const extent = (values) => values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
  const [left, right] = extent(xs),
    [low, high] = extent(ys);
  const tail = labels.length > 0 ? 52 : 0; // for the numbers at the right
  const wide = right - left || 1,
    tall = high - low || 1;
  const xRange = [left - 0.04 * wide, right + 0.04 * wide + (tail / (plotWidth - tail)) * 1.08 * wide],
    yRange = [low - 0.05 * tall, high + 0.05 * tall];
  const pixel = (px, py) => [
    ((px - xRange[0]) / (xRange[1] - xRange[0])) * plotWidth,
    (1 - (py - yRange[0]) / (yRange[1] - yRange[0])) * plotHeight,
  ];
  return {
    traces,
    layout: {
      margin,
      xaxis: { title: 'displacement [mm]', range: xRange, automargin: false },
      yaxis: { title: 'force [kN]', range: yRange, automargin: false },
      annotations: peakLabels(labels, pixel, 26, plotHeight).map((label) => ({
        ...label,
        color: undefined,
        text: '<b>' + label.text + '</b>',
        arrowhead: 0,
        arrowwidth: 0.8,
        arrowcolor: look.colour('muted'),
        font: { size: 11.5, color: label.color },
        bgcolor: look.colour('paper'),
        borderpad: 0.5,
      })),
    },
  };
}

function cycleHistoryCaption() {
  const device = devices[chosen.tested];
  const reasons = new Map();
  for (const cycle of device.blocks.flatMap((block) => block.cycles))
    if (!cycle.counts) reasons.set(cycle.reason, (reasons.get(cycle.reason) ?? 0) + 1);
  const said = [...reasons].map(([reason, times]) => reason + (times > 1 ? ' (' + times + ' times)' : ''));
  return (
    (device.blocks.length === 0
      ? 'No cycles: ' + noCycles(device)
      : count(device.blocks.length, 'block') + ', ' + count(countedCycles(device).length, 'cycle') + ' counted.') +
    (said.length > 0 ? ' Pale and marked \u2013, not counted: ' + enumerate(said, 4) + '.' : '') +
    (!inspection && device.scored ? ' The bar along the bottom: the part the laws were judged by.' : '')
  );
}

function drawCycleHistory(look, width) {
  const device = devices[chosen.tested],
    raw = device.raw,
    axis = rawTime(device),
    colour = cycleScale(look),
    largest = largestNumber(device);
  const x = curve(raw.disp_mm);
  const margin = { l: 58, r: 12, t: 26, b: 44 };
  const perSample = (width - margin.l - margin.r) / raw.samples;
  const [STRIP, BOTTOM] = [0.84, 0];
  const shapes = [],
    annotations = [],
    marks = { x: [], text: [] };
  const strip = (x0, x1, y0, y1, look) =>
    shapes.push({ type: 'rect', yref: 'y2', x0: axis.of(x0), x1: axis.of(x1), y0, y1, line: { width: 0 }, ...look });
  const write = (index, y, text, size, color, xanchor = 'center') =>
    annotations.push({
      x: axis.of(index),
      y,
      yref: 'y2',
      text,
      showarrow: false,
      xanchor,
      yanchor: 'bottom',
      font: { size, color },
      borderpad: 0,
    });
  for (const block of device.blocks) {
    const first = block.cycles[0].first,
      last = block.cycles[block.cycles.length - 1].last;
    const amplitude = '±' + significant(block.amplitude_mm, 3) + THIN + 'mm';
    const frequency = isNumber(block.frequency_Hz) ? ', ' + significant(block.frequency_Hz, 2) + THIN + 'Hz' : '';
    const name = 'Block ' + block.number;
    const fitting = [name + ': ' + amplitude + frequency, name + ': ' + amplitude, name, String(block.number)].find(
      (text) => 6.8 * text.length < perSample * (last - first),
    );
    strip(first, last, 0.58, 0.6, { fillcolor: look.colour('muted') });
    if (fitting) write(first, 0.62, plain(fitting), 11.5, look.colour('ink'), 'left');
    const narrowest = Math.min(...counted(block).map((cycle) => cycle.last - cycle.first)) * perSample;
    const every = Math.max(1, Math.ceil((6 + 7 * String(counted(block).length).length) / narrowest));
    for (const cycle of block.cycles) {
      const middle = (cycle.first + cycle.last) / 2,
        gap = Math.min(1 / perSample, 0.1 * (cycle.last - cycle.first));
      marks.x.push(axis.of(middle));
      marks.text.push(plain(cycleText(block, cycle)));
      if (cycle.counts) {
        strip(cycle.first + gap, cycle.last - gap, 0.02, 0.14, { fillcolor: colour(shareOf(cycle, largest)) });
        if (cycle.number % every === 1 % every)
          write(middle, 0.17, String(cycle.number), 11, colour(shareOf(cycle, largest)));
      } else {
        write(middle, 0.17, '\u2013', 11, look.colour('muted'));
        shapes.push({
          type: 'rect',
          layer: 'below',
          yref: 'y domain',
          x0: axis.of(cycle.first),
          x1: axis.of(cycle.last),
          y0: 0,
          y1: 1,
          fillcolor: look.colour('uncounted'),
          line: { width: 0.8, dash: 'dot', color: look.colour('muted') },
        });
      }
    }
  }
  for (const { from, to } of (!inspection && device.scored) || [])
    shapes.push({
      type: 'rect',
      yref: 'y domain',
      x0: axis.fromRecord(from),
      x1: axis.fromRecord(to),
      y0: BOTTOM,
      y1: 0.03,
      fillcolor: look.colour('accent'),
      line: { width: 0 },
    });
  return {
    traces: [
      {
        mode: 'lines',
        x: x.map((_, k) => axis.of(rawIndex(raw, k))),
        y: x,
        line: { color: look.colour('measured'), width: 1.3 },
        hovertemplate: axis.timed
          ? '%{x:.2f} s, %{y:.1f} mm<extra></extra>'
          : 'sample %{x}, %{y:.1f} mm<extra></extra>',
      },
      {
        mode: 'markers',
        x: marks.x,
        y: marks.x.map(() => 0.2),
        yaxis: 'y2',
        text: marks.text,
        marker: { size: 16, opacity: 0, color: look.colour('muted') },
        hovertemplate: '%{text}<extra></extra>',
      },
    ],
    layout: {
      margin,
      shapes,
      annotations,
      xaxis: { title: axis.title, zeroline: false, range: [axis.of(0), axis.of(raw.samples - 1)] },
      yaxis: { title: 'displacement [mm]', domain: [0, STRIP - 0.03], automargin: false },
      yaxis2: { domain: [STRIP, 1], range: [0, 1], visible: false, fixedrange: true },
    },
  };
}
