// Draws the report from its data block. Everything on the page is an entry of FIGURES: to add a figure, add an entry.
// Text of the input reaches the document through textContent only, and plots through plain().
'use strict';

const report = JSON.parse(document.getElementById('isolaw-data').textContent);
const devices = report.devices.map((device, index) => ({ ...device, index }));
const laws = report.laws.map((law, index) => ({
  ...law,
  index,
  fitOn: new Map(law.devices.map((fit) => [fit.device, fit])),
}));
const usable = devices.filter((device) => device.status === 'ok');
const ranking = report.findings.verdicts.map((verdict) => laws[verdict.law]);
const lawsByObjective = laws
  .filter((law) => law.objective.mean !== null)
  .sort((a, b) => a.objective.mean - b.objective.mean);
const hasFront = laws.some((law) => law.beta !== null && law.objective.mean !== null);

// What the reader has chosen; a figure names the keys that change it.
const chosen = {
  device: usable.find((device) => device.record.drawn > 0)?.index ?? null,
  laws: new Set(ranking.slice(0, 2).map((law) => law.index)),
  grouping: 'law',
};

// ---------------------------------------------------------------------------------------------------- text and numbers

const MINUS = '\u2212',
  THIN = '\u202f',
  DASH = '\u2013';

function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

// Plotly reads markup in labels; a name from a file is text.
function plain(text) {
  return String(text)
    .replace(/[\u0000-\u001f\u007f]/g, ' ')
    .replace(/&/g, '&amp;')
    .replace(/</g, '&lt;')
    .replace(/>/g, '&gt;');
}

const short = (text, most = 14) => (text.length > most ? text.slice(0, most - 1) + '\u2026' : text);
const typeset = (text) => text.replace('-', MINUS);
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

function fixed(value, decimals) {
  return isNumber(value) ? typeset(value.toFixed(decimals)) : DASH;
}

function signed(value, decimals) {
  if (!isNumber(value)) return DASH;
  const text = fixed(value, decimals);
  return Number(value.toFixed(decimals)) > 0 ? '+' + text : text;
}

function superscript(exponent) {
  return String(exponent).replace(/[-0-9]/g, (c) =>
    c === '-' ? '\u207b' : '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[c],
  );
}

// Significant digits; very large and small values as a power of ten.
function significant(value, digits = 3) {
  if (!isNumber(value)) return DASH;
  if (value === 0) return '0';
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent >= 6 || exponent < -3)
    return typeset((value / 10 ** exponent).toFixed(digits - 1)) + '\u00b710' + superscript(exponent);
  return typeset(value.toFixed(Math.max(0, digits - 1 - exponent)));
}

// "N/m^3" -> "N/m³"
const unitText = (unit) =>
  (unit === '' || unit === '1' ? '-' : unit).replace(/\^\(?(-?\d+(?:\.\d+)?)\)?/g, (all, power) =>
    power.includes('.') ? all : superscript(power),
  );

const objectiveText = (statistic) =>
  statistic.mean === null
    ? DASH
    : fixed(statistic.mean, 4) + (statistic.std === null ? '' : ' \u00b1 ' + fixed(statistic.std, 4));

function enumerate(names, most = 5) {
  if (names.length > most) return names.slice(0, most - 1).join(', ') + ' and ' + (names.length - most + 1) + ' more';
  return names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names[names.length - 1];
}

// A number and its percent sign stay on one line.
const sentence = (text) => text.replace(/(\d) %/g, '$1' + THIN + '%');

const count = (number, noun) => number + ' ' + noun + (number === 1 ? '' : 's');

// ------------------------------------------------------------------------------------------------------- data and CSV

// A curve of the data block: offset + step * running sum of integers.
const decodedCurves = new WeakMap();
function curve(coded) {
  if (!coded) return null;
  let values = decodedCurves.get(coded);
  if (!values) {
    let level = 0;
    values = coded.d.map((difference) => coded.o + coded.s * (level += difference));
    decodedCurves.set(coded, values);
  }
  return values;
}

function csvCell(value) {
  if (value === null || value === undefined) return '';
  if (typeof value === 'number') return String(Number(value.toPrecision(9)));
  let text = String(value);
  if (/^[=+\-@\t\r]./s.test(text) && !(text.trim() !== '' && Number.isFinite(Number(text)))) text = "'" + text;
  return /[",\r\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
}

function download(name, { columns, rows }) {
  const text = [columns, ...rows].map((row) => row.map(csvCell).join(',') + '\r\n').join('');
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv;charset=utf-8' }));
  const link = element('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// ------------------------------------------------------------------------------------------------------------ plotting

const SYMBOLS = ['circle', 'square', 'diamond', 'triangle-up', 'triangle-down', 'cross', 'x', 'star'];
const DASHES = ['solid', 'dash', 'dashdot', 'dot', 'longdash', 'longdashdot', '6px,3px', '10px,3px,2px,3px'];

function theme() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue('--' + name).trim();
  return {
    colour,
    law: (law) => colour('law-' + ((law.index % 8) + 1)),
    font: style.getPropertyValue('--sans').trim(),
  };
}
const symbolOf = (law) => SYMBOLS[law.index % SYMBOLS.length];
const dashOf = (place) => DASHES[place % DASHES.length]; // by the order of the chosen laws: the first one is solid

// A layout in the page's typography; axes are merged over the common axis style.
function styled(layout, look) {
  const axis = {
    gridcolor: look.colour('grid'),
    zerolinecolor: look.colour('rule'),
    linecolor: look.colour('rule'),
    showline: true,
    tickfont: { size: 11.5 },
    title: { standoff: 6 },
    automargin: true,
    ticks: '',
  };
  const result = {
    autosize: false, // the page gives every plot its size
    paper_bgcolor: 'rgba(0,0,0,0)',
    plot_bgcolor: 'rgba(0,0,0,0)',
    font: { family: look.font, size: 12.5, color: look.colour('ink') },
    margin: { l: 54, r: 12, t: 10, b: 44 },
    hoverlabel: {
      bgcolor: look.colour('paper'),
      bordercolor: look.colour('rule'),
      font: { family: look.font, size: 12.5, color: look.colour('ink') },
      align: 'left',
    },
    legend: { orientation: 'h', x: 0, y: 1.02, xanchor: 'left', yanchor: 'bottom', font: { size: 12 } },
    modebar: { bgcolor: 'rgba(0,0,0,0)', color: look.colour('muted'), activecolor: look.colour('ink') },
    showlegend: false,
    hovermode: 'closest',
    dragmode: 'zoom',
    ...layout,
  };
  for (const name of Object.keys(result)) {
    if (!/^[xy]axis\d*$/.test(name)) continue;
    const own = result[name];
    const title =
      typeof own.title === 'string'
        ? { text: own.title, standoff: 6, font: { size: 12.5, color: look.colour('muted') } }
        : own.title;
    result[name] = { ...axis, ...own, title };
  }
  return result;
}

// The buttons are named one by one, and no server: Plotly's own default offers to upload the figure.
const PLOT_CONFIG = {
  displaylogo: false,
  displayModeBar: 'hover',
  plotlyServerURL: '',
  modeBarButtons: [['toImage', 'zoom2d', 'pan2d', 'resetScale2d']],
  toImageButtonOptions: { format: 'svg', filename: 'isolaw-figure' },
};

// The range of some values with a share of it free on both sides.
function paddedRange(values, share) {
  const low = Math.min(...values),
    high = Math.max(...values),
    margin = share * (high - low || Math.abs(low) || 1);
  return [low - margin, high + margin];
}

// Where each label of a scatter goes: the first side where it meets no point, no label placed before, and not the
// stair that joins `stair`, the indices of points from left to right. Ranges as drawn, width and height in pixels.
function labelPlaces(points, stair, xRange, yRange, width, height) {
  const at = points.map((p) => [
    ((p.x - xRange[0]) / (xRange[1] - xRange[0])) * width,
    (1 - (p.y - yRange[0]) / (yRange[1] - yRange[0])) * height,
  ]);
  const taken = at.map(([x, y]) => [x - 7, y - 7, x + 7, y + 7]);
  for (let k = 1; k < stair.length; ++k) {
    const [x0, y0] = at[stair[k - 1]],
      [x1, y1] = at[stair[k]];
    taken.push([x0, y0 - 1, x1, y0 + 1], [x1 - 1, y0, x1 + 1, y1]);
  }
  return points.map((point, i) => {
    const [x, y] = at[i],
      w = 7 * point.label.length,
      h = 16;
    const sides = {
      'top center': [x - w / 2, y - 8 - h, x + w / 2, y - 8],
      'middle right': [x + 9, y - h / 2, x + 9 + w, y + h / 2],
      'bottom center': [x - w / 2, y + 8, x + w / 2, y + 8 + h],
      'middle left': [x - 9 - w, y - h / 2, x - 9, y + h / 2],
      'top right': [x + 5, y - 5 - h, x + 5 + w, y - 5],
      'bottom right': [x + 5, y + 5, x + 5 + w, y + 5 + h],
    };
    const free =
      Object.keys(sides).find((side) => {
        const b = sides[side];
        return taken.every((t, k) => k === i || b[2] < t[0] || t[2] < b[0] || b[3] < t[1] || t[3] < b[1]);
      }) ?? 'top center';
    taken.push(sides[free]);
    return free;
  });
}

// ------------------------------------------------------------------------------------------------------------- tables

// columns: [{title, unit, number, pinned}]; rows: [{cells: [text or node], className}]
function table(columns, rows, label) {
  const align = (column) =>
    [
      column.number ? 'number' : '',
      column.pinned ? 'pinned' : '',
      column.tight ? 'tight' : '',
      column.name ? 'name' : '',
      column.screen ? 'screen' : '',
    ]
      .filter(Boolean)
      .join(' ') || null;
  const head = columns.map((column) =>
    element(
      'th',
      { scope: 'col', class: align(column), title: column.full ?? null },
      column.title,
      column.unit ? element('small', {}, column.unit) : null,
    ),
  );
  const body = rows.map((row) =>
    element(
      'tr',
      { class: row.className ?? null },
      ...row.cells.map((cell, i) => {
        if (cell instanceof HTMLTableCellElement) return cell;
        return element(i === 0 ? 'th' : 'td', { scope: i === 0 ? 'row' : null, class: align(columns[i]) }, cell);
      }),
    ),
  );
  // Focusable, so that the keyboard can scroll it.
  return element(
    'div',
    { class: rows.length > 60 ? 'scroll long' : 'scroll', tabindex: '0', role: 'region', 'aria-label': label },
    element('table', {}, element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...body)),
  );
}

function lawKey(law) {
  return element('span', { class: 'key', style: 'border-color: var(--law-' + ((law.index % 8) + 1) + ')' });
}

// The front's markers, as in the plot: filled circle, or open diamond for a dominated law.
function marker(role) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  const shape = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  const dominated = role === 'dominated';
  shape.setAttribute('d', dominated ? 'M6 1 L11 6 L6 11 L1 6 Z' : 'M6 1 A5 5 0 1 1 5.99 1 Z');
  shape.setAttribute('stroke-width', '1.8');
  const colour = 'var(--' + (dominated ? 'poor' : role === 'not ranked' ? 'muted' : 'good') + ')';
  shape.style.stroke = colour;
  shape.style.fill = dominated || role === 'not ranked' ? 'none' : colour;
  svg.append(shape);
  return svg;
}

// --------------------------------------------------------------------------------------------------------- the figures

const FRONT_HEIGHT = 390,
  LOOP_HEIGHT = 400;

const SECTIONS = [
  { id: 'decision', title: 'The decision' },
  { id: 'objective', title: 'Accuracy' },
  { id: 'loops', title: 'Loops', controls: loopControls },
  { id: 'parameters', title: 'Parameters' },
  { id: 'devices', title: 'Devices' },
  { id: 'provenance', title: 'How it was made' },
];

// An entry:
//   id, section, title   title '' shows none
//   width                'wide', 'narrow', 'half' on large screens; full width otherwise
//   wanted()             false leaves the entry out; always wanted when absent
//   depends              keys of `chosen` that change it
//   controls()           nodes above the figure
//   caption()            what to conclude from it
//   csv()                {columns, rows}: its data
//   height(width)        of a plot, in pixels, and
//   draw(look, width)    the plot: {traces, layout};  or
//   build()              anything else: a node
const FIGURES = [
  {
    id: 'front',
    section: 'decision',
    width: 'wide',
    title: 'Accuracy against robustness',
    wanted: () => hasFront,
    caption: () => {
      const dominated = report.findings.verdicts.filter((v) => v.role === 'dominated').map((v) => laws[v.law].id);
      return (
        'Each point is a law; lower is more accurate, further left its parameters agree better from device to device. ' +
        'No law lies both below and left of a filled green point' +
        (dominated.length > 0
          ? '; ' + enumerate(dominated) + (dominated.length === 1 ? ' is' : ' are') + ' beaten in both respects.'
          : '.')
      );
    },
    csv: () => ({
      columns: ['law', 'beta [-]', 'mean OF [-]', 'on front'],
      rows: ranking.map((law) => [law.id, law.beta, law.objective.mean, law.on_front ? 'yes' : 'no']),
    }),
    height: () => FRONT_HEIGHT,
    draw: (look, width) => {
      const shown = laws.filter((law) => law.beta !== null && law.objective.mean !== null);
      const height = FRONT_HEIGHT;
      const edge = shown.filter((law) => law.on_front).sort((a, b) => a.beta - b.beta);
      const xRange = paddedRange(
          shown.map((law) => law.beta),
          0.13,
        ),
        yRange = paddedRange(
          shown.map((law) => law.objective.mean),
          0.13,
        );
      const places = labelPlaces(
        shown.map((law) => ({ x: law.beta, y: law.objective.mean, label: law.id })),
        edge.map((law) => shown.indexOf(law)),
        xRange,
        yRange,
        width - 70,
        height - 85,
      );
      const points = (onFront, name, symbol, colour) => {
        const some = shown.filter((law) => law.on_front === onFront);
        return {
          name,
          x: some.map((law) => law.beta),
          y: some.map((law) => law.objective.mean),
          mode: 'markers+text',
          cliponaxis: false,
          text: some.map((law) => plain(law.id)),
          textposition: some.map((law) => places[shown.indexOf(law)]),
          textfont: { size: 13, color: look.colour(onFront ? 'ink' : 'muted') },
          marker: {
            size: onFront ? 12 : 11,
            symbol,
            color: look.colour(colour),
            line: { width: 2, color: look.colour(colour) },
          },
          hovertemplate: '<b>%{text}</b><br>mean OF %{y:.4f}<br>beta %{x:.3f}<extra></extra>',
        };
      };
      return {
        traces: [
          {
            x: edge.map((law) => law.beta),
            y: edge.map((law) => law.objective.mean),
            mode: 'lines',
            hoverinfo: 'skip',
            showlegend: false,
            opacity: 0.55,
            line: { shape: 'hv', width: 1.2, dash: 'dot', color: look.colour('good') },
          },
          points(true, 'not dominated', 'circle', 'good'),
          points(false, 'dominated', 'diamond-open', 'poor'),
        ],
        layout: {
          showlegend: true,
          xaxis: { title: 'robustness index β [-], smaller is more robust', range: xRange, zeroline: false },
          yaxis: { title: 'mean objective OF [-], smaller is more accurate', range: yRange, zeroline: false },
        },
      };
    },
  },
  {
    id: 'objective-bars',
    section: 'decision',
    width: 'wide',
    title: 'Mean objective per law',
    wanted: () => !hasFront && lawsByObjective.length > 0,
    caption: () =>
      'Shorter is more accurate. Accuracy alone decides here, because the robustness index is undefined: ' +
      report.findings.beta_note +
      '.',
    csv: () => ({
      columns: ['law', 'mean OF [-]', 'std OF [-]', 'best OF [-]'],
      rows: lawsByObjective.map((law) => [law.id, law.objective.mean, law.objective.std, law.objective.best]),
    }),
    height: () => 90 + 38 * lawsByObjective.length,
    draw: (look) => {
      const shown = [...lawsByObjective].reverse();
      return {
        traces: [
          {
            type: 'bar',
            orientation: 'h',
            y: shown.map((law) => plain(law.id)),
            x: shown.map((law) => law.objective.mean),
            marker: { color: shown.map((law) => look.law(law)) },
            width: 0.6,
            error_x: {
              type: 'data',
              array: shown.map((law) => law.objective.std ?? 0),
              color: look.colour('ink'),
              thickness: 1.2,
              width: 4,
            },
            hovertemplate: '<b>%{y}</b><br>mean OF %{x:.4f}<extra></extra>',
          },
        ],
        layout: {
          xaxis: { title: 'mean objective OF [-]', rangemode: 'tozero' },
          yaxis: { showgrid: false, type: 'category' },
        },
      };
    },
  },
  { id: 'verdicts', section: 'decision', width: 'narrow', title: '', build: verdictList },
  {
    id: 'ranking',
    section: 'decision',
    title: 'Ranking by mean objective',
    caption: () =>
      'OF: mean absolute error of the force divided by the standard deviation of the measured force, over devices and runs. ' +
      'β: how far the parameters stray from their mean over the lot. Errors of stiffness and energy: mean magnitude over devices, best fit against the record.',
    csv: () => ({
      columns: [
        'law',
        'mean OF [-]',
        'std OF [-]',
        'best OF [-]',
        'beta [-]',
        'on front',
        'K_eff error [%]',
        'energy error [%]',
      ],
      rows: lawsByObjective.map((law) => [
        law.id,
        law.objective.mean,
        law.objective.std,
        law.objective.best,
        law.beta,
        law.on_front ? 'yes' : 'no',
        law.K_eff_error_percent,
        law.energy_error_percent,
      ]),
    }),
    build: rankingTable,
  },
  {
    id: 'objective-devices',
    section: 'objective',
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
    id: 'loop',
    section: 'loops',
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
    section: 'loops',
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
    section: 'loops',
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
  {
    id: 'parameter-tables',
    section: 'parameters',
    title: 'Identified parameters',
    long: true,
    wanted: () => laws.some((law) => law.parameters.length > 0),
    caption: () =>
      'Mean over the runs, ± standard deviation, and the difference of the device from the lot\u2019s mean in percent. ▲ ▼: the best run lies at the upper or lower ' +
      'bound of its search box, so the bound, not the record, decided the value. Δ: largest difference of a device from the lot\u2019s mean; β is its mean over the calibrated parameters.',
    csv: parameterData,
    build: parameterTables,
  },
  {
    id: 'properties',
    section: 'devices',
    title: 'Test properties per cycle',
    long: true,
    caption: propertiesCaption,
    csv: propertiesData,
    build: propertiesTable,
  },
  {
    id: 'settings',
    section: 'provenance',
    width: 'narrow',
    title: 'Settings',
    caption: () => 'The same files, settings and seed give the same results, whatever the number of threads.',
    build: settingsList,
    csv: () => ({ columns: ['setting', 'value'], rows: settingRows() }),
  },
  {
    id: 'files',
    section: 'provenance',
    width: 'wide',
    title: 'Input files',
    caption: () => 'SHA-256 of each file as it was read: a changed file is another input.',
    csv: () => ({
      columns: ['device', 'file', 'sha256', 'status', 'message'],
      rows: devices.map((d) => [d.name, d.file, d.sha256, d.status, d.message]),
    }),
    build: filesTable,
  },
  {
    id: 'steps',
    section: 'provenance',
    title: 'What was recognised and done to the records',
    long: true,
    build: stepsList,
  },
  {
    id: 'notes',
    section: 'provenance',
    title: 'How the laws were read',
    long: true,
    wanted: () => laws.some((law) => law.notes.length > 0),
    build: lawNotes,
  },
];

// --- the decision

function verdictList() {
  const items = report.findings.verdicts.map((verdict) => {
    const law = laws[verdict.law];
    const inOneLine = verdict.role === 'dominated' || verdict.role === 'not ranked';
    const role = inOneLine ? ' ' : element('span', { class: 'role ' + verdict.role.replace(/ /g, '-') }, verdict.role);
    return element(
      'li',
      { class: inOneLine ? 'brief' : null },
      marker(verdict.role),
      element('div', {}, element('b', {}, law.id), role, inOneLine ? null : element('br'), sentence(verdict.sentence)),
    );
  });
  const warnings = report.findings.warnings.map((warning) => element('li', {}, warning.sentence));
  const few = warnings.length <= 5 ? warnings.length : 4;
  const care =
    warnings.length === 0
      ? element(
          'p',
          { class: 'calm' },
          'Nothing stands out: no device was refused, no run failed, no parameter lies at its bound.',
        )
      : element(
          'div',
          { class: 'warnings' },
          element('h3', {}, 'Take care'),
          element('ul', {}, ...warnings.slice(0, few)),
          few === warnings.length
            ? null
            : element(
                'details',
                {},
                element('summary', {}, warnings.length - few + ' more'),
                element('ul', {}, ...warnings.slice(few)),
              ),
        );
  return element('div', {}, element('ul', { class: 'verdicts' }, ...items), care);
}

function rankingTable() {
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'mean OF ± std', unit: '-', number: true },
    { title: 'best OF', unit: '-', number: true },
    { title: 'β', unit: '-', number: true },
    { title: 'Verdict', tight: true },
    { title: 'stiffness error', unit: '%', number: true },
    { title: 'energy error', unit: '%', number: true },
    { title: 'parameters', unit: 'calibrated', number: true },
    { title: 'Description', screen: true },
  ];
  const roles = new Map(report.findings.verdicts.map((verdict) => [verdict.law, verdict.role]));
  const rows = [...lawsByObjective, ...laws.filter((law) => law.objective.mean === null)].map((law) => {
    const role = roles.get(law.index);
    const tone = role === 'dominated' ? 'poor' : role === 'not ranked' ? 'note' : 'good';
    return {
      cells: [
        element('b', { class: 'strong' }, law.id),
        objectiveText(law.objective),
        fixed(law.objective.best, 4),
        fixed(law.beta, 3),
        element('span', { class: tone }, role),
        fixed(law.K_eff_error_percent, 1),
        fixed(law.energy_error_percent, 1),
        String(law.parameters.filter((p) => p.free).length || DASH),
        element('td', { class: 'note text screen' }, law.title),
      ],
    };
  });
  return table(columns, rows, 'Ranking of the laws');
}

// --- accuracy

function groupingControl() {
  const option = (value, text) => element('option', { value, selected: chosen.grouping === value }, text);
  const select = element('select', { id: 'grouping' }, option('law', 'law'), option('device', 'device'));
  select.addEventListener('change', () => choose('grouping', select.value));
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

// --- loops

function loopControls() {
  const drawable = usable.filter((device) => device.record.drawn > 0);
  if (drawable.length === 0) return [element('p', { class: 'empty' }, 'No record could be used.')];
  const select = element(
    'select',
    { id: 'device' },
    ...drawable.map((device) =>
      element('option', { value: device.index, selected: device.index === chosen.device }, device.name),
    ),
  );
  select.addEventListener('change', () => choose('device', Number(select.value)));
  const boxes = ranking.map((law) => {
    const box = element('input', { type: 'checkbox', value: law.index, checked: chosen.laws.has(law.index) });
    box.addEventListener('change', () => {
      box.checked ? chosen.laws.add(law.index) : chosen.laws.delete(law.index);
      choose('laws', chosen.laws);
    });
    return element('label', {}, box, lawKey(law), law.id);
  });
  return [element('label', {}, 'Device', select), element('fieldset', {}, element('legend', {}, 'Laws'), ...boxes)];
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
  const thinned =
    device.record.drawn < device.record.samples
      ? ' Drawn: ' + device.record.drawn + ' of ' + device.record.samples + ' samples.'
      : '';
  return (
    device.name +
    ', measured (grey) and best fits. ' +
    said.join('; ') +
    (said.length > 0 ? '.' : 'Choose a law above.') +
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
    thinned
  );
}

function historyCaption() {
  const device = devices[chosen.device],
    measured = record(device);
  const peak = Math.max(...measured.F.map(Math.abs));
  const worst = fitsOn(device, chosenLaws()).map(
    ({ law, force }) =>
      law.id + ' ' + significant(Math.max(...force.map((f, i) => Math.abs(measured.F[i] - f))), 3) + THIN + 'kN',
  );
  return (
    'Residual: measured minus computed force. What repeats from cycle to cycle is the law\u2019s own error, what fades is scragging the law does not know.' +
    (worst.length > 0
      ? ' Largest residual: ' + worst.join(', ') + '; peak force ' + significant(peak, 3) + THIN + 'kN.'
      : '')
  );
}

function drawLoop(look) {
  const device = devices[chosen.device],
    measured = record(device);
  return {
    traces: [
      {
        name: 'measured',
        mode: 'lines',
        x: measured.x,
        y: measured.F,
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

// --- parameters

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
  const same = found.every((p) => p[5] === found[0][5] && p[6] === found[0][6]);
  return { same, lower: found[0][5], upper: found[0][6] };
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
    const means = usable.map((device) => law.fitOn.get(device.index)?.parameters[place]?.[0]);
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
          return isNumber(p?.[0])
            ? cell(p[0], parameter.free ? p[1] : null, parameter.free ? p[3] : null, p[4], format, p[2])
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
      const bound = law.parameters.filter((_, i) => law.devices.some((fit) => fit.parameters[i]?.[4])).length;
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
            const [mean, std, best, difference, bound, lower, upper] = fit.parameters[i];
            return [
              law.id,
              parameter.name,
              parameter.unit,
              devices[fit.device].name,
              mean,
              std,
              best,
              difference,
              bound,
              lower,
              upper,
            ];
          }),
      ),
    ),
  };
}

// --- devices

const reportedCycle = (device) => device.cycles.find((cycle) => cycle.number === device.reported) ?? null;

function propertiesCaption() {
  const cycles = devices.map(reportedCycle).filter(Boolean);
  if (cycles.length === 0) return 'No record has a complete cycle with enough samples.';
  const span = (key, digits) => {
    const values = cycles.map((cycle) => cycle[key]),
      low = Math.min(...values),
      high = Math.max(...values);
    return significant(low, digits) === significant(high, digits)
      ? significant(low, digits)
      : significant(low, digits) + ' to ' + significant(high, digits);
  };
  return (
    'From raw values. In bold the cycle that is reported, the third or the last. Over ' +
    count(cycles.length, 'device') +
    ': effective stiffness ' +
    span('K_eff_kN_per_mm', 3) +
    THIN +
    'kN/mm, equivalent viscous damping ' +
    span('damping_percent', 3) +
    THIN +
    '%.'
  );
}

function propertiesData() {
  return {
    columns: ['device', 'cycle', 'amplitude [mm]', 'K_eff [kN/mm]', 'energy [kN mm]', 'damping [%]', 'reported'],
    rows: devices.flatMap((device) =>
      device.cycles.map((c) => [
        device.name,
        c.number,
        c.amplitude_mm,
        c.K_eff_kN_per_mm,
        c.energy_kN_mm,
        c.damping_percent,
        c.number === device.reported ? 'yes' : 'no',
      ]),
    ),
  };
}

function propertiesTable() {
  const some = (key) => devices.some((device) => device[key] !== null && device[key] !== '');
  const facts = [
    { key: 'serial', column: { title: 'Serial' }, text: (d) => d.serial },
    { key: 'lot', column: { title: 'Lot' }, text: (d) => d.lot },
    { key: 'test_date', column: { title: 'Tested' }, text: (d) => d.test_date },
    {
      key: 'temperature_C',
      column: { title: 'Temp.', unit: '°C', number: true },
      text: (d) => fixed(d.temperature_C, 1),
    },
  ].filter((fact) => some(fact.key));
  const strained = some('rubber_thickness_mm');
  const columns = [
    { title: 'Device', pinned: true },
    ...facts.map((fact) => fact.column),
    { title: 'Cycle', number: true },
    { title: 'Amplitude', unit: 'mm', number: true },
    ...(strained ? [{ title: 'Shear strain', unit: '%', number: true }] : []),
    { title: 'Effective stiffness', unit: 'kN/mm', number: true },
    { title: 'Energy', unit: 'kN mm', number: true },
    { title: 'Damping', unit: '%', number: true },
    { title: 'Remark' },
  ];
  const rows = devices.flatMap((device) => {
    const remark =
      device.status !== 'ok' ? 'refused: ' + device.message : device.reported === null ? device.properties_refusal : '';
    const lead = (first) => [
      element('b', { class: 'strong' }, first ? device.name : ''),
      ...facts.map((fact) => (first ? fact.text(device) : '')),
    ];
    const note = (text) => element('td', { class: 'note text' }, text);
    if (device.cycles.length === 0)
      return [{ className: 'group', cells: [...lead(true), ...Array(strained ? 6 : 5).fill(DASH), note(remark)] }];
    return device.cycles.map((cycle, i) => ({
      className: [i === 0 ? 'group' : '', cycle.number === device.reported ? 'strong' : ''].join(' ').trim() || null,
      cells: [
        ...lead(i === 0),
        String(cycle.number),
        fixed(cycle.amplitude_mm, 1),
        ...(strained
          ? [device.rubber_thickness_mm ? fixed((100 * cycle.amplitude_mm) / device.rubber_thickness_mm, 0) : DASH]
          : []),
        significant(cycle.K_eff_kN_per_mm, 4),
        fixed(cycle.energy_kN_mm, 0),
        fixed(cycle.damping_percent, 2),
        note(i === 0 ? remark : ''),
      ],
    }));
  });
  return table(columns, rows, 'Test properties per device and cycle');
}

// --- how it was made

function settingRows() {
  const text = (value) => (typeof value === 'string' ? value : JSON.stringify(value));
  return [
    ['isolaw', report.isolaw],
    ['seed', report.seed],
    ...Object.entries(report.settings).map(([key, value]) => [key, text(value)]),
  ];
}

function settingsList() {
  return element(
    'dl',
    { class: 'settings' },
    ...settingRows().flatMap(([key, value]) => [element('dt', {}, key), element('dd', {}, value)]),
  );
}

function filesTable() {
  const columns = [{ title: 'Device', pinned: true }, { title: 'File' }, { title: 'SHA-256' }, { title: 'Status' }];
  const rows = devices.map((device) => ({
    cells: [
      element('b', { class: 'strong' }, device.name),
      device.file,
      element(
        'span',
        { class: 'hash', title: device.sha256 },
        device.sha256.slice(0, 16) + (device.sha256.length > 16 ? '\u2026' : ''),
      ),
      device.status === 'ok' ? 'used' : element('span', { class: 'poor' }, 'refused'),
    ],
  }));
  return table(columns, rows, 'Input files');
}

function stepsList() {
  const items = devices.map((device) => {
    const sentences = [
      ...device.recognised,
      ...device.warnings.map((text) => 'Take care: ' + text),
      ...device.cleaning,
    ];
    if (device.status !== 'ok') sentences.push('Refused: ' + device.message);
    return element(
      'details',
      { class: 'steps' },
      element('summary', {}, element('b', {}, device.name), ' \u2013 ' + device.file),
      element(
        'ul',
        {},
        ...sentences.map((text) => element('li', {}, text)),
        element('li', {}, 'SHA-256 ', element('code', {}, device.sha256)),
      ),
    );
  });
  return element('div', {}, ...items);
}

function lawNotes() {
  return element(
    'div',
    {},
    ...laws
      .filter((law) => law.notes.length > 0)
      .map((law) =>
        element(
          'details',
          { class: 'steps' },
          element('summary', {}, element('b', {}, law.id), ' \u2013 ' + law.title),
          element('ul', {}, ...law.notes.map((note) => element('li', {}, note))),
        ),
      ),
  );
}

// ------------------------------------------------------------------------------------------------------------ the page

const drawn = new Map(); // figure -> {node, body, caption, seen, stale}

// Room for a plot before it is drawn, so that nothing moves when it is.
function reserve(figure) {
  const { body } = drawn.get(figure);
  const height = figure.height(body.clientWidth);
  body.style.height = height + 'px';
  return height;
}

function render(figure) {
  const place = drawn.get(figure);
  place.stale = false;
  if (figure.caption) place.caption.textContent = figure.caption();
  if (!figure.draw) return;
  const look = theme();
  const width = place.body.clientWidth,
    height = reserve(figure);
  const { traces, layout } = figure.draw(look, width);
  place.body.setAttribute('aria-label', figure.title + '. ' + (figure.caption ? figure.caption() : ''));
  return Plotly.react(place.body, traces, styled({ ...layout, width, height }, look), {
    ...PLOT_CONFIG,
    displayModeBar: width > 480 ? 'hover' : false,
  });
}

// Everything that depends on `key` is drawn again; what is out of sight waits until it is seen.
function choose(key, value) {
  chosen[key] = value;
  for (const [figure, place] of drawn) {
    if (!figure.depends?.includes(key)) continue;
    place.stale = true;
    if (place.seen) render(figure);
  }
}

function buildFigure(figure, observer) {
  const head = figure.title === '' ? null : element('div', { class: 'figure-head' }, element('h3', {}, figure.title));
  if (head && figure.csv) {
    const button = element(
      'button',
      { type: 'button', class: 'csv', 'aria-label': 'Download the data of \u201c' + figure.title + '\u201d as CSV' },
      'CSV',
    );
    button.addEventListener('click', () => download('isolaw-' + figure.id + '.csv', figure.csv()));
    head.append(button);
  }
  const controls = figure.controls ? element('div', { class: 'controls' }, ...figure.controls()) : null;
  const body = element('div', figure.draw ? { class: 'plot', role: 'img', 'aria-label': figure.title } : {});
  const caption = figure.caption ? element('figcaption') : null;
  const node = element(
    'figure',
    { id: 'figure-' + figure.id, class: [figure.width ?? '', figure.long ? 'long' : ''].join(' ').trim() || null },
    head,
    controls,
    body,
    caption,
  );
  if (figure.build) body.append(figure.build());
  if (figure.caption) caption.textContent = figure.caption();
  drawn.set(figure, { node, body, caption, seen: false, stale: Boolean(figure.draw) });
  observer.observe(node);
  node.figure = figure;
  return node;
}

function buildPage() {
  const refused = devices.length - usable.length;
  document.getElementById('title').textContent = report.title || 'Isolation devices';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    count(laws.length, 'law'),
    'seed ' + report.seed,
    'isolaw ' + report.isolaw,
  ].join(' \u00b7 ');
  document.getElementById('colophon').textContent =
    'Made by isolaw ' +
    report.isolaw +
    ' from the campaign\u2019s store. This file needs no network; the data of every figure can be saved as CSV.';

  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const place = drawn.get(target.figure);
        place.seen = isIntersecting;
        if (isIntersecting && place.stale) render(target.figure);
      }
    },
    { rootMargin: '300px 0px' },
  );

  const main = document.getElementById('report'),
    contents = document.getElementById('contents');
  for (const section of SECTIONS) {
    const figures = FIGURES.filter((figure) => figure.section === section.id && (figure.wanted?.() ?? true));
    if (figures.length === 0) continue;
    const node = element(
      'section',
      { id: section.id, 'aria-labelledby': section.id + '-title' },
      element('h2', { id: section.id + '-title' }, section.title),
    );
    if (section.id === 'decision') node.append(element('p', { class: 'headline' }, report.findings.headline));
    const grid = element('div', { class: 'figures' });
    if (section.controls) grid.append(element('div', { class: 'controls' }, ...section.controls()));
    grid.append(...figures.map((figure) => buildFigure(figure, observer)));
    node.append(grid);
    main.append(node);
    contents.append(element('a', { href: '#' + section.id }, section.title));
  }
  for (const figure of drawn.keys()) if (figure.draw) reserve(figure);
  markCurrentSection(main, contents);
  if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView(); // now that it exists
}

function markCurrentSection(main, contents) {
  const links = new Map([...contents.children].map((link) => [link.hash.slice(1), link]));
  const inView = new Set();
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries)
        isIntersecting ? inView.add(target.id) : inView.delete(target.id);
      const current = [...links.keys()].find((id) => inView.has(id));
      for (const [id, link] of links)
        id === current ? link.setAttribute('aria-current', 'true') : link.removeAttribute('aria-current');
    },
    { rootMargin: '-22% 0px -75% 0px' },
  );
  for (const section of main.children) observer.observe(section);
}

function redraw({ everything = false } = {}) {
  for (const [figure, place] of drawn) {
    if (figure.draw) {
      place.stale = true;
      reserve(figure);
    }
    if (everything || (place.seen && place.stale)) render(figure);
  }
}

// On paper: light colours, the width of the page, every figure and every table.
window.addEventListener('beforeprint', () => {
  document.documentElement.dataset.printing = '';
  redraw({ everything: true });
  for (const details of document.querySelectorAll('details.law')) details.print();
  for (const details of document.querySelectorAll('.warnings details')) details.open = true;
});
window.addEventListener('afterprint', () => {
  delete document.documentElement.dataset.printing;
  for (const details of document.querySelectorAll('details.law')) details.restore();
  redraw();
});

window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => redraw());

buildPage();

// Plots follow the width of the page, however it changes; drawing them changes its height only.
let drawnWidth = document.getElementById('report').clientWidth;
new ResizeObserver(([entry]) => {
  const width = Math.round(entry.contentRect.width);
  if (width === drawnWidth) return;
  drawnWidth = width;
  requestAnimationFrame(() => redraw()); // not here: what is drawn changes the height that is being observed
}).observe(document.getElementById('report'));
