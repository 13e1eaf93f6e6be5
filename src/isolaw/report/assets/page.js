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
const drawable = usable.filter((device) => device.record.drawn > 0); // beside the laws' loops
const tested = devices.filter((device) => device.raw?.samples > 0); // whose raw record can be shown
const inspection = laws.length === 0; // records alone, no identification
const ranking = report.findings.verdicts.map((verdict) => laws[verdict.law]);
const lawsByObjective = laws
  .filter((law) => law.objective.mean !== null)
  .sort((a, b) => a.objective.mean - b.objective.mean);
const examinedLaws = lawsByObjective.filter((law) => law.devices.some((fit) => fit.determination !== null));
const lotLaws = lawsByObjective.filter((law) => law.lot !== null);
const predictedLaws = lawsByObjective.filter((law) => law.predicted_objective !== null);

// Accuracy against robustness, three ways; those that some law has both coordinates of.
const VIEWS = [
  {
    id: 'published',
    title: 'as published',
    robust: (law) => law.beta,
    accurate: (law) => law.objective.mean,
    onFront: (law) => law.on_front,
    whyNot: (law) => law.beta_note,
    axes: ['robustness index β [-], smaller is more robust', 'mean objective OF [-], smaller is more accurate'],
    columns: ['beta [-]', 'mean OF [-]'],
    says: 'lower is more accurate, further left its parameters agree better from device to device.',
  },
  {
    id: 'converged',
    title: 'without the optimiser\u2019s noise',
    robust: (law) => law.beta_converged,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_converged,
    whyNot: (law) => law.beta_converged_note,
    axes: ['β of the least objectives [-]', 'least objective OF [-], mean over devices'],
    columns: ['beta of the least objectives [-]', 'least OF [-]'],
    says: 'as published, but of the least objective of every device instead of the means over runs, and without parameters that most tests do not determine.',
  },
  {
    id: 'left-out',
    title: 'device left out',
    robust: (law) => law.loo_objective,
    accurate: (law) => law.objective_converged,
    onFront: (law) => law.on_front_loo,
    whyNot: () => '',
    axes: ['OF on a device by the law of all others [-]', 'least objective OF [-], mean over devices'],
    columns: ['OF on devices left out [-]', 'least OF [-]'],
    says: 'lower is more accurate on a tested device, further left better for a device that was not tested: one law, fitted to all others.',
  },
].filter((view) => laws.some((law) => isPlaced(view, law)));
function isPlaced(view, law) {
  return isNumber(view.robust(law)) && isNumber(view.accurate(law));
}
const hasFront = VIEWS.length > 0;

// What the reader has chosen; a figure names the keys that change it.
const chosen = {
  device: drawable[0]?.index ?? null,
  tested: tested.find((device) => device.blocks.length > 0)?.index ?? tested[0]?.index ?? null,
  block: 'all',
  laws: new Set(ranking.slice(0, 2).map((law) => law.index)),
  grouping: 'law',
  view: VIEWS[0]?.id,
  examined: examinedLaws[0]?.index ?? null, // a law
  parameter: 0, // its place among the law's
  lotLaw: lotLaws[0]?.index ?? null,
};
chosen.parameter = firstExamined(laws[chosen.examined]);

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
function isNumber(value) {
  return typeof value === 'number' && Number.isFinite(value);
}

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

// What a caption says of controls, columns and downloads that paper does not have.
const onScreen = (text) => ('printing' in document.documentElement.dataset ? '' : text);

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

const LEGEND = { orientation: 'h', x: 0, y: 1.02, xanchor: 'left', yanchor: 'bottom', font: { size: 12 } };

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
    legend: LEGEND,
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
        if (b[0] < -40 || b[2] > width + 10) return false;
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
      column.mark ? 'mark' : '',
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

// A small sign of [path, fill, stroke] in a field of 12 by 12.
const ROUND = 'M6 .8 A5.2 5.2 0 1 1 5.99 .8 Z';
function icon(...shapes) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  for (const [d, fill, stroke] of shapes) {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', d);
    path.style.fill = fill;
    path.style.stroke = stroke;
    svg.append(path);
  }
  return svg;
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

// An entry with laws: true is left out where there are none.
const SECTIONS = [
  { id: 'decision', title: 'The decision', laws: true },
  { id: 'objective', title: 'Accuracy', laws: true },
  { id: 'loops', title: 'Loops', controls: loopControls, laws: true },
  { id: 'determination', title: 'What the tests determine', laws: true },
  { id: 'one-law', title: 'One law for the lot', laws: true },
  { id: 'prediction', title: 'Prediction across the record', laws: true },
  { id: 'properties', title: 'Properties', controls: propertyControls },
  { id: 'devices', title: 'Lot and devices' },
  { id: 'parameters', title: 'Parameters', laws: true },
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
//   build()              anything else: a node; built again when what it depends on changes
const FIGURES = [
  {
    id: 'front',
    section: 'decision',
    width: 'wide',
    title: 'Accuracy against robustness',
    wanted: () => hasFront,
    depends: ['view'],
    controls: VIEWS.length > 1 ? viewControl : null,
    caption: frontCaption,
    csv: () => ({
      columns: [
        'law',
        ...VIEWS.flatMap((view) => [...view.columns, 'on front ' + view.title.replace('\u2019', "'")]),
        'prediction collapses',
      ],
      rows: ranking.map((law) => [
        law.id,
        ...VIEWS.flatMap((view) => [view.robust(law), view.accurate(law), view.onFront(law) ? 'yes' : 'no']),
        law.prediction_collapses ? 'yes' : 'no',
      ]),
    }),
    height: () => FRONT_HEIGHT,
    draw: drawFront,
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
      '.' +
      collapseNote(lawsByObjective),
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
  {
    id: 'converged',
    section: 'decision',
    width: 'wide',
    title: 'Without the optimiser\u2019s noise, and for an untested device',
    wanted: () => report.findings.converged.length > 0,
    build: () =>
      element(
        'ul',
        { class: 'sentences' },
        ...report.findings.converged.map((text) =>
          element('li', {}, ...(/\bfront\b/.test(text) ? withBadges(sentence(text)) : [sentence(text)])),
        ),
      ),
  },
  { id: 'verdicts', section: 'decision', width: 'narrow', title: '', build: verdictList },
  {
    id: 'ranking',
    section: 'decision',
    title: 'Ranking by mean objective',
    caption: () =>
      'OF: mean absolute error of the force divided by the standard deviation of the measured force, over devices and runs. ' +
      'β: how far the parameters stray from their mean over the lot. Errors of stiffness and energy: mean magnitude over devices, best fit against the record.' +
      onScreen(
        laws.some((law) => isNumber(law.success_share))
          ? ' Found: runs that ended within ' +
              percentText(report.thresholds.found_within) +
              ' of the least objective known; where they are few, the mean says more of the search than of the law.'
          : '',
      ),
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
        'runs at the least OF [%]',
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
        isNumber(law.success_share) ? 100 * law.success_share : null,
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
    id: 'determined',
    section: 'determination',
    width: 'wide',
    title: 'Parameters by device',
    long: true,
    depends: ['examined'],
    wanted: () => examinedLaws.length > 0,
    controls: () => [lawChooser('examined', examinedLaws, (law) => ({ parameter: firstExamined(law) }))],
    caption: determinedCaption,
    csv: determinedData,
    build: determinedTable,
  },
  {
    id: 'profile',
    section: 'determination',
    width: 'narrow',
    title: 'How far the parameter may go',
    depends: ['examined', 'parameter', 'device'],
    wanted: () => examinedLaws.length > 0 && chosen.device !== null,
    caption: profileCaption,
    csv: profileData,
    height: () => PROFILE_HEIGHT,
    draw: drawProfile,
  },
  {
    id: 'trade-offs',
    section: 'determination',
    width: 'wide',
    title: 'What changes together, and the intervals',
    depends: ['examined', 'device'],
    wanted: () => examinedLaws.length > 0 && chosen.device !== null,
    build: tradeOffs,
  },
  {
    id: 'lot-laws',
    section: 'one-law',
    title: 'What one law for all devices costs',
    wanted: () => lotLaws.length > 0,
    caption: lotLawsCaption,
    csv: lotLawsData,
    build: lotLawsTable,
  },
  {
    id: 'lot-devices',
    section: 'one-law',
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
    section: 'one-law',
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
    section: 'one-law',
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
    section: 'one-law',
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
  {
    id: 'predictions',
    section: 'prediction',
    title: 'Objective per block',
    wanted: () => predictedLaws.length > 0,
    caption: predictionCaption,
    csv: predictionData,
    build: predictionTable,
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
    id: 'warnings',
    section: 'properties',
    title: '', // with laws they stand under the decision
    wanted: () => inspection && report.findings.warnings.length > 0,
    build: takeCare,
  },
  {
    id: 'cycles',
    section: 'properties',
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
    section: 'properties',
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
    section: 'properties',
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
    section: 'properties',
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
    section: 'properties',
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
  {
    id: 'rule-set',
    section: 'devices',
    title: 'What the lot was held to',
    wanted: () => report.assessment !== null,
    build: ruleSetStatement,
  },
  {
    id: 'lot',
    section: 'devices',
    title: 'The lot, property by property',
    long: true,
    wanted: () => lotQuantities.length > 0,
    caption: lotCaption,
    csv: lotData,
    build: lotTable,
  },
  {
    id: 'lot-strips',
    section: 'devices',
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
    section: 'devices',
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
    section: 'devices',
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
    section: 'devices',
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
    section: 'devices',
    title: 'Property modification factors',
    long: true,
    wanted: () => (report.assessment?.lot?.factors.length ?? 0) > 0,
    caption: factorCaption,
    csv: factorData,
    build: factorTable,
  },
  {
    id: 'properties',
    section: 'devices',
    title: 'Test properties per device and block',
    long: true,
    caption: propertiesCaption,
    csv: () => cycleData(devices),
    build: propertiesTable,
  },
  {
    id: 'settings',
    section: 'provenance',
    width: 'narrow',
    title: 'Settings',
    caption: () =>
      inspection
        ? 'Properties are of raw values; they depend on the files and on how these were read.'
        : 'The same files, settings and seed give the same results, whatever the number of threads.',
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

// A law's name; where its prediction collapses, that stands beside it wherever it is recommended.
function collapseBadge() {
  return element(
    'span',
    { class: 'badge', title: 'misses the blocks it was not fitted to: see Prediction across the record' },
    'prediction collapses',
  );
}
const lawName = (law) =>
  element(
    'span',
    {},
    element('b', { class: 'strong' }, law.id),
    ...(law.prediction_collapses ? [' ', collapseBadge()] : []),
  );

// A sentence in which the first mention of such a law has its badge.
function withBadges(text) {
  const parts = [text];
  for (const law of laws.filter((one) => one.prediction_collapses)) {
    const name = new RegExp('(?<![\\w-])' + law.id.replace(/[^\w]/g, '\\$&') + '(?![\\w-])');
    const at = parts.findIndex((part) => typeof part === 'string' && name.test(part));
    if (at < 0) continue;
    const end = parts[at].search(name) + law.id.length;
    parts.splice(at, 1, parts[at].slice(0, end) + ' ', collapseBadge(), parts[at].slice(end));
  }
  return parts;
}

const percentText = (share) => Number((100 * share).toPrecision(3)) + THIN + '%';
const shownView = () => VIEWS.find((view) => view.id === chosen.view);

function viewControl() {
  const buttons = VIEWS.map((view) => {
    const button = element('button', { type: 'button', value: view.id }, view.title);
    button.addEventListener('click', () => choose({ view: view.id }));
    return button;
  });
  const follow = () => {
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.value === chosen.view));
  };
  followers.push(follow);
  follow();
  return [element('div', { class: 'choice', role: 'group', 'aria-label': 'View' }, ...buttons)];
}

function frontCaption() {
  const view = shownView();
  const placed = laws.filter((law) => isPlaced(view, law));
  const dominated = ranking.filter((law) => placed.includes(law) && !view.onFront(law)).map((law) => law.id);
  const missing = ranking.filter((law) => !placed.includes(law));
  const leftOut = view.id !== 'converged' ? [] : placed.filter((law) => law.left_out_of_beta.length > 0);
  const reduced = view.id !== 'converged' ? [] : placed.filter((law) => law.reduced).map((law) => law.id);
  return (
    'Each point is a law; ' +
    view.says +
    ' No law lies both below and left of a filled green point' +
    (dominated.length > 0
      ? '; ' + enumerate(dominated) + (dominated.length === 1 ? ' is' : ' are') + ' beaten in both respects.'
      : '.') +
    (leftOut.length > 0
      ? ' Left out of β: ' + leftOut.map((law) => enumerate(law.left_out_of_beta) + ' of ' + law.id).join('; ') + '.'
      : '') +
    (reduced.length > 0 ? ' Of the form without the redundant parameter: ' + enumerate(reduced) + '.' : '') +
    (missing.length > 0
      ? ' Not shown: ' +
        missing.map((law) => law.id + (view.whyNot(law) ? ' (' + view.whyNot(law) + ')' : '')).join('; ') +
        '.'
      : '') +
    collapseNote(placed)
  );
}

function collapseNote(among) {
  const names = among.filter((law) => law.prediction_collapses).map((law) => law.id);
  return names.length > 0 ? ' Prediction across the record collapses: ' + enumerate(names) + '.' : '';
}

function drawFront(look, width) {
  const view = shownView();
  const shown = laws.filter((law) => isPlaced(view, law));
  const height = FRONT_HEIGHT;
  const edge = shown.filter(view.onFront).sort((a, b) => view.robust(a) - view.robust(b));
  const xRange = paddedRange(shown.map(view.robust), 0.13),
    yRange = paddedRange(shown.map(view.accurate), 0.13);
  const places = labelPlaces(
    shown.map((law) => ({ x: view.robust(law), y: view.accurate(law), label: law.id })),
    edge.map((law) => shown.indexOf(law)),
    xRange,
    yRange,
    width - 70,
    height - 85,
  );
  const points = (onFront, name, symbol, colour) => {
    const some = shown.filter((law) => view.onFront(law) === onFront);
    return {
      name,
      x: some.map(view.robust),
      y: some.map(view.accurate),
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
      hovertemplate:
        '<b>%{text}</b><br>' +
        view.columns[1].replace(' [-]', '') +
        ' %{y:.4f}<br>' +
        view.columns[0].replace(' [-]', '') +
        ' %{x:.3f}<extra></extra>',
    };
  };
  return {
    traces: [
      {
        x: edge.map(view.robust),
        y: edge.map(view.accurate),
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
      xaxis: { title: view.axes[0], range: xRange, zeroline: false },
      yaxis: { title: view.axes[1], range: yRange, zeroline: false },
    },
  };
}

function verdictList() {
  const items = report.findings.verdicts.map((verdict) => {
    const law = laws[verdict.law];
    const inOneLine = verdict.role === 'dominated' || verdict.role === 'not ranked';
    const role = inOneLine ? ' ' : element('span', { class: 'role ' + verdict.role.replace(/ /g, '-') }, verdict.role);
    return element(
      'li',
      { class: inOneLine ? 'brief' : null },
      marker(verdict.role),
      element('div', {}, lawName(law), role, inOneLine ? null : element('br'), sentence(verdict.sentence)),
    );
  });
  const care =
    report.findings.warnings.length === 0
      ? element(
          'p',
          { class: 'calm' },
          'Nothing stands out: no device was refused, no run failed, no parameter lies at its bound.',
        )
      : takeCare();
  return element('div', {}, element('ul', { class: 'verdicts' }, ...items), care);
}

function takeCare() {
  const warnings = report.findings.warnings.map((warning) => element('li', {}, warning.sentence));
  const few = warnings.length <= 5 ? warnings.length : 4;
  return element(
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
}

function rankingTable() {
  const searched = laws.some((law) => isNumber(law.success_share));
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'mean OF ± std', unit: '-', number: true },
    { title: 'best OF', unit: '-', number: true },
    { title: 'β', unit: '-', number: true },
    { title: 'Verdict', tight: true },
    { title: 'stiffness error', unit: '%', number: true },
    { title: 'energy error', unit: '%', number: true },
    ...(searched ? [{ title: 'found', unit: '% of runs', number: true, screen: true }] : []),
    { title: 'parameters', unit: 'calibrated', number: true },
    { title: 'Description', screen: true },
  ];
  const roles = new Map(report.findings.verdicts.map((verdict) => [verdict.law, verdict.role]));
  const rows = [...lawsByObjective, ...laws.filter((law) => law.objective.mean === null)].map((law) => {
    const role = roles.get(law.index);
    const tone = role === 'dominated' ? 'poor' : role === 'not ranked' ? 'note' : 'good';
    return {
      cells: [
        lawName(law),
        objectiveText(law.objective),
        fixed(law.objective.best, 4),
        fixed(law.beta, 3),
        element('span', { class: tone }, role),
        fixed(law.K_eff_error_percent, 1),
        fixed(law.energy_error_percent, 1),
        ...(searched ? [isNumber(law.success_share) ? fixed(100 * law.success_share, 0) : DASH] : []),
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

// --- loops

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

// --- what the tests determine

const PROFILE_HEIGHT = 400;

// Word and shape say the same; the colour only repeats them.
const DETERMINATIONS = {
  determined: { tone: 'good', path: ROUND, filled: true },
  'weakly determined': { tone: 'accent', path: ROUND, filled: false, mark: 'M6 .8 A5.2 5.2 0 0 0 6 11.2 Z' },
  undetermined: { tone: 'poor', path: ROUND, filled: false },
  'at its bound': { tone: 'care', path: 'M6 1.2 L10.6 8.2 H1.4 Z M1.4 11 H10.6', filled: true },
};

function determinationMark(verdict) {
  const { tone, path, filled, mark } = DETERMINATIONS[verdict];
  const colour = 'var(--' + tone + ')';
  return icon([path, filled ? colour : 'none', colour], ...(mark ? [[mark, colour, 'none']] : []));
}

function lawChooser(key, among, changes = () => ({})) {
  const select = element(
    'select',
    { id: key },
    ...among.map((law) => element('option', { value: law.index, selected: law.index === chosen[key] }, law.id)),
  );
  select.addEventListener('change', () => {
    const law = laws[Number(select.value)];
    choose({ [key]: law.index, ...changes(law) });
  });
  return element('label', {}, 'Law', select);
}

// Places of the parameters that were examined on some device.
function examinedPlaces(law) {
  return law.parameters
    .map((_, place) => place)
    .filter((place) => law.devices.some((fit) => fit.determination?.[place]));
}
function firstExamined(law) {
  return law ? (examinedPlaces(law)[0] ?? 0) : 0;
}

// What is known of a parameter on a device; null where it was not examined.
function examination(law, device, place) {
  const fit = law?.fitOn.get(device);
  const row = fit?.determination?.[place];
  if (!row) return null;
  const [verdict, optimum, low, high, openBelow, openAbove, linearLow, linearHigh, bootLow, bootHigh, values, levels] =
    row;
  return {
    law,
    fit,
    parameter: law.parameters[place],
    verdict,
    optimum,
    open: [low, high],
    ends: [openBelow, openAbove],
    linear: [linearLow, linearHigh],
    bootstrap: [bootLow, bootHigh],
    values,
    objectives: levels,
    box: fit.parameters[place].slice(5, 7),
  };
}
const chosenExamination = () => examination(laws[chosen.examined], chosen.device, chosen.parameter);

// "0.15 to 0.2 kN/mm"; as many digits as tell the two apart, three at least.
function rangeText([low, high], unit) {
  for (let digits = 3; digits < 7; ++digits)
    if (low === high || significant(low, digits) !== significant(high, digits))
      return (low === high ? '' : significant(low, digits) + ' to ') + withUnit(high, unitText(unit), digits);
  return withUnit(high, unitText(unit), 7);
}

function determinedCaption() {
  const law = laws[chosen.examined];
  const fits = law.devices.filter((fit) => fit.determination);
  const blind = examinedPlaces(law)
    .map((place) => ({
      name: law.parameters[place].name,
      times: fits.filter((fit) => fit.determination[place]?.[0] === 'undetermined').length,
    }))
    .filter(({ times }) => times > 0);
  const missing = usable.filter((device) => !law.fitOn.get(device.index)?.determination).map((device) => device.name);
  return (
    (blind.length === 0
      ? 'The tests determine every parameter of ' + law.id + ' that does not lie at its bound.'
      : 'The tests leave open ' +
        enumerate(
          blind.map(({ name, times }) =>
            times === fits.length ? name : name + ' (' + times + ' of ' + count(fits.length, 'device') + ')',
          ),
          7,
        ) +
        ': other values give loops that nobody can tell apart, so do not compare such values between devices.') +
    (missing.length > 0 ? ' Not examined: ' + enumerate(missing) + '.' : '') +
    onScreen(' Choose a cell, by the mouse or the arrow keys, for its profile.')
  );
}

function determinedData() {
  return {
    columns: [
      'law',
      'device',
      'parameter',
      'unit',
      'verdict',
      'optimum',
      'open from',
      'open to',
      'ends at the box below',
      'ends at the box above',
      'linear from',
      'linear to',
      'bootstrap from',
      'bootstrap to',
    ],
    rows: examinedLaws.flatMap((law) =>
      law.devices.flatMap((fit) =>
        examinedPlaces(law)
          .map((place) => examination(law, fit.device, place))
          .filter(Boolean)
          .map((one) => [
            law.id,
            devices[fit.device].name,
            one.parameter.name,
            one.parameter.unit,
            one.verdict,
            one.optimum,
            ...one.open,
            ...one.ends.map((end) => (end ? 'yes' : 'no')),
            ...one.linear,
            ...one.bootstrap,
          ]),
      ),
    ),
  };
}

function determinedTable() {
  const law = laws[chosen.examined];
  const places = examinedPlaces(law);
  const fits = law.devices.filter((fit) => fit.determination);
  const columns = [
    { title: 'Device', pinned: true, name: true },
    ...places.map((place) => {
      const { name, unit } = law.parameters[place];
      return { title: element('span', {}, name), full: name + ' [' + unitText(unit) + ']', mark: true };
    }),
  ];
  const cell = (fit, place) => {
    const one = examination(law, fit.device, place);
    if (!one) return element('td', { class: 'mark note' }, DASH);
    const text =
      one.parameter.name +
      ' on ' +
      devices[fit.device].name +
      ': ' +
      one.verdict +
      ', ' +
      rangeText(one.open, one.parameter.unit);
    const button = element(
      'button',
      {
        type: 'button',
        class: DETERMINATIONS[one.verdict].tone,
        tabindex: '-1',
        title: text,
        'aria-label': text,
        'data-device': fit.device,
        'data-parameter': place,
      },
      determinationMark(one.verdict),
    );
    return element('td', { class: 'mark' }, button);
  };
  const shares = places.map((place) => {
    const verdicts = fits.map((fit) => fit.determination[place]?.[0]).filter(Boolean);
    return String(verdicts.filter((verdict) => verdict === 'undetermined').length);
  });
  const body = table(
    columns,
    [
      ...fits.map((fit) => ({ cells: [devices[fit.device].name, ...places.map((place) => cell(fit, place))] })),
      ...(fits.length > 1
        ? [
            {
              className: 'group',
              cells: [
                element(
                  'span',
                  { class: 'note', title: 'devices whose test leaves it undetermined' },
                  'open, of ' + fits.length,
                ),
                ...shares.map((share) => element('td', { class: 'mark note' }, share)),
              ],
            },
          ]
        : []),
    ],
    'Whether the tests determine the parameters of ' + law.id,
  );
  body.classList.add('marks');
  body.classList.toggle('upright', places.length > 12);
  body.addEventListener('click', (event) => chooseCell(event.target.closest('button')));
  body.addEventListener('keydown', (event) => {
    const next = cellBeside(event.target.closest('button'), event.key);
    if (!next) return;
    event.preventDefault();
    chooseCell(next);
    next.focus();
  });
  markChosenCell(body);
  return element('div', {}, body, determinedLegend());
}

function determinedLegend() {
  const { determined_within: near, weakly_determined_within: far } = report.thresholds;
  const meaning = {
    determined: 'known to ±' + percentText(near),
    'weakly determined': 'to ±' + percentText(far) + ', or its range ends at the box',
    undetermined: 'anything further, or all of the box',
    'at its bound': 'the box, not the test, decides the value',
  };
  return element(
    'ul',
    { class: 'legend' },
    ...Object.keys(DETERMINATIONS).map((verdict) =>
      element(
        'li',
        {},
        element('span', { class: 'verdict ' + DETERMINATIONS[verdict].tone }, determinationMark(verdict), verdict),
        ' ' + meaning[verdict],
      ),
    ),
  );
}

function chooseCell(button) {
  if (button) chooseDevice(Number(button.dataset.device), { parameter: Number(button.dataset.parameter) });
}

// The cell that a key leads to, past those that were not examined.
function cellBeside(button, key) {
  const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key] ?? [0, 0];
  if (!button || (dx === 0 && dy === 0)) return null;
  let row = button.closest('tr'),
    column = button.closest('td').cellIndex;
  for (;;) {
    column += dx;
    if (dy !== 0) row = dy > 0 ? row.nextElementSibling : row.previousElementSibling;
    const cell = row?.cells[column];
    if (!cell) return null;
    if (cell.querySelector('button')) return cell.querySelector('button');
  }
}

// One cell is pressed and reached by the tabulator, the arrow keys lead to the others.
function markChosenCell(body) {
  if (!body) return;
  for (const button of body.querySelectorAll('button[tabindex="0"]')) {
    button.tabIndex = -1;
    button.setAttribute('aria-pressed', 'false');
  }
  const own = body.querySelector(
    'button[data-device="' + chosen.device + '"][data-parameter="' + chosen.parameter + '"]',
  );
  own?.setAttribute('aria-pressed', 'true');
  const reached = own ?? body.querySelector('button');
  if (reached) reached.tabIndex = 0;
}
followers.push(() => markChosenCell(document.querySelector('#figure-determined .marks')));

function profileCaption() {
  const one = chosenExamination();
  const law = laws[chosen.examined],
    where = law.id + ' on ' + devices[chosen.device].name;
  if (!one) return where + ' was not examined.';
  const { name, unit } = one.parameter;
  const ends = one.ends[0] && one.ends[1] ? 'both ends are' : one.ends[0] ? 'the lower end is' : 'the upper end is';
  return (
    where +
    '. ' +
    name +
    ' is held at each point and all others are fitted again. Below the dashed line, ' +
    significant(one.fit.rise, 2) +
    ' above the least objective of ' +
    fixed(one.fit.optimum, 4) +
    ', the loops get no worse to the eye: there ' +
    name +
    ' may be ' +
    rangeText(one.open, unit) +
    (one.ends.some(Boolean) ? ' (' + ends + ' the search box\u2019s)' : '') +
    ', so it is ' +
    one.verdict +
    '.'
  );
}

function profileData() {
  const one = chosenExamination();
  return {
    columns: ['law', 'device', 'parameter', 'unit', 'value', 'least OF [-]'],
    rows: one
      ? one.values.map((value, i) => [
          one.law.id,
          devices[chosen.device].name,
          one.parameter.name,
          one.parameter.unit,
          value,
          one.objectives[i],
        ])
      : [],
  };
}

// The axis of a parameter: powers of ten where its values span many, of negative ones too; else a factor as in tables.
function parameterAxis({ name, unit }, values) {
  const sizes = values.map(Math.abs),
    largest = Math.max(...sizes),
    sign = Math.sign(values[0]);
  const log = values.every((value) => Math.sign(value) === sign && value !== 0) && largest > 20 * Math.min(...sizes);
  const format = rowFormat(values);
  const factor = log ? sign : format.factor;
  const scaled = log || format.exponent === 0 ? '' : '10' + superscript(format.exponent) + ' ';
  const places = values.map((value) => value / factor);
  const range = paddedRange(log ? places.map(Math.log10) : places, 0.04);
  const start = log && sign < 0 ? [...range].reverse() : range;
  return {
    of: (value) => value / factor,
    share: (place) => ((log ? Math.log10(place) : place) - start[0]) / (start[1] - start[0]), // of the width
    layout: {
      title: plain(name + ' [' + scaled + unitText(unit) + ']'),
      type: log ? 'log' : 'linear',
      range: start,
      ...(log ? { dtick: 1, exponentformat: 'power', tickprefix: sign < 0 ? MINUS : '' } : { nticks: 7 }),
      zeroline: false,
    },
  };
}

function drawProfile(look, width) {
  const one = chosenExamination();
  if (!one) return emptyPlot(look, 'not examined');
  const { values, objectives, optimum, fit } = one;
  const limit = fit.optimum + fit.rise;
  const bars = [
    { title: 'open range', range: one.open, colour: 'good' },
    { title: 'linearised', range: one.linear, colour: 'law-1' },
    { title: 'bootstrap', range: one.bootstrap, colour: 'law-4' },
  ].filter(({ range }) => range.every(isNumber));
  const axis = parameterAxis(one.parameter, [...values, optimum, ...bars.flatMap(({ range }) => range)]);
  const top = Math.max(fit.optimum + 2 * fit.rise, Math.min(Math.max(...objectives), fit.optimum + 6 * fit.rise)),
    low = fit.optimum - 0.12 * (top - fit.optimum);
  const level = (i) => bars.length - i;
  const ends = one.open.map(axis.of);
  const curvePoints = [
    ...values.map((value, i) => [value, objectives[i]]),
    ...one.open.filter((_, i) => !one.ends[i]).map((value) => [value, limit]), // where the profile crosses it
  ].sort((a, b) => a[0] - b[0]);
  const text = (value) => withUnit(value, unitText(one.parameter.unit));
  return {
    traces: [
      {
        mode: 'lines',
        x: [ends[0], ends[0], ends[1], ends[1], ends[0]],
        y: [low, 2 * top, 2 * top, low, low],
        fill: 'toself',
        fillcolor: look.colour('band'),
        line: { width: 0 },
        hoverinfo: 'skip',
      },
      {
        mode: 'lines',
        x: curvePoints.map(([value]) => axis.of(value)),
        y: curvePoints.map(([, objective]) => objective),
        hoverinfo: 'skip',
        line: { color: look.colour('ink'), width: 1.8 },
      },
      {
        mode: 'markers',
        x: values.map(axis.of),
        y: objectives,
        text: values.map(text),
        marker: { color: look.colour('ink'), size: 6 },
        hovertemplate: '%{text}<br>least OF %{y:.5f}<extra></extra>',
      },
      {
        mode: 'markers',
        x: [axis.of(optimum)],
        y: [fit.optimum],
        text: [text(optimum)],
        marker: { color: look.colour('good'), size: 11, line: { color: look.colour('paper'), width: 1.5 } },
        hovertemplate: 'least objective %{y:.5f}<br>at %{text}<extra></extra>',
      },
      ...bars.map(({ title, range, colour }, i) => ({
        mode: 'lines+markers',
        yaxis: 'y2',
        x: range.map(axis.of),
        y: [level(i), level(i)],
        line: { color: look.colour(colour), width: 5 },
        marker: { color: look.colour(colour), size: 11, symbol: 'line-ns-open', line: { width: 2.5 } },
        text: [plain(title + ': ' + rangeText(range, one.parameter.unit))],
        hovertemplate: '%{text}<extra></extra>',
      })),
    ],
    layout: {
      margin: { l: 70, r: 12, t: 10, b: 44 },
      xaxis: { ...axis.layout, anchor: 'y2' },
      yaxis: {
        title: 'least objective OF [-]',
        domain: [0.32, 1],
        range: [low, top + 0.05 * (top - low)],
        zeroline: false,
        nticks: 6,
      },
      yaxis2: {
        domain: [0, 0.2],
        range: [0.4, bars.length + 0.6],
        tickmode: 'array',
        tickvals: bars.map((_, i) => level(i)),
        ticktext: bars.map(({ title }) => title),
        showgrid: false,
        zeroline: false,
        fixedrange: true,
      },
      shapes: [
        {
          type: 'line',
          xref: 'paper',
          x0: 0,
          x1: 1,
          y0: limit,
          y1: limit,
          line: { color: look.colour('muted'), width: 1.2, dash: 'dash' },
        },
      ],
      annotations: [
        {
          xref: 'paper',
          x: Math.min(0.8, Math.max(0.2, axis.share((ends[0] + ends[1]) / 2))), // the curve lies below here
          y: limit,
          xanchor: 'center',
          yanchor: 'bottom',
          showarrow: false,
          text: 'visibly worse above',
          font: { size: 11.5, color: look.colour('muted') },
        },
      ],
    },
  };
}

function intervalSentence({ level, samples, block, replicates }) {
  if (!isNumber(level)) return null;
  return (
    'The bars under the profile are intervals of ' +
    percentText(level) +
    ': by linearisation' +
    (replicates > 0 ? ', and from ' + count(replicates, 'fit') + ' of the bootstrap' : '') +
    ', in blocks of ' +
    count(block, 'sample') +
    ' of ' +
    samples +
    ' because neighbouring residuals are alike. They say how far another record of the same device could move the fit, ' +
    'taking the law\u2019s misfit for noise; they are no statement on whether the law is true. A parameter at its bound is held there.'
  );
}

function tradeOffs() {
  const law = laws[chosen.examined],
    fit = law.fitOn.get(chosen.device);
  const name = devices[chosen.device].name;
  if (!fit?.determination) return element('p', { class: 'empty' }, law.id + ' on ' + name + ' was not examined.');
  return element(
    'div',
    { class: 'prose' },
    fit.trade_offs.length === 0
      ? element('p', {}, 'On ' + name + ' no parameters of ' + law.id + ' change together unseen.')
      : element(
          'div',
          {},
          element('p', {}, 'The loops of ' + law.id + ' on ' + name + ':'),
          element('ul', { class: 'sentences' }, ...fit.trade_offs.map((text) => element('li', {}, sentence(text)))),
        ),
    law.reduced_form
      ? element(
          'p',
          {},
          element('code', {}, law.reduced_form),
          ' searches a form of the same loops without the redundant parameter.',
        )
      : null,
    element('p', {}, intervalSentence(fit.intervals)),
  );
}

// --- one law for the lot

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

// --- prediction across the record

// A column per block, and apart for a block that is fitted on some devices and predicted on others.
function scoredBlocks() {
  const found = new Map();
  for (const law of predictedLaws)
    for (const fit of law.devices)
      for (const { block, fitted } of fit.blocks) {
        const shown = devices[fit.device].blocks.find((one) => one.number === block);
        const amplitudes = found.get(block + ' ' + fitted)?.amplitudes ?? [];
        if (shown) amplitudes.push(shown.amplitude_mm);
        found.set(block + ' ' + fitted, { block, fitted, amplitudes });
      }
  return [...found.values()].sort((a, b) => a.block - b.block || Number(b.fitted) - Number(a.fitted));
}
const scoresOf = (law, { block, fitted }) =>
  law.devices.flatMap((fit) =>
    fit.blocks
      .filter((score) => score.block === block && score.fitted === fitted)
      .map((score) => ({ device: devices[fit.device].name, objective: score.objective })),
  );
const missText = (objective) => (objective < 10 ? fixed(objective, 4) : significant(objective, 3));
const average = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function predictionCaption() {
  const { collapsed_objective: most, collapsed_ratio: ratio } = report.thresholds;
  const best = [...predictedLaws].sort((a, b) => a.predicted_objective - b.predicted_objective)[0],
    closest = [...predictedLaws].sort((a, b) => a.fitted_objective - b.fitted_objective)[0];
  const collapsing = predictedLaws.filter((law) => law.prediction_collapses).map((law) => law.id);
  return (
    'Every law runs through the whole record and was fitted to the blocks so marked alone. ' +
    (best === closest
      ? best.id + ' is closest both to the blocks it was fitted to and to the others.'
      : closest.id + ' is closest to the blocks it was fitted to, ' + best.id + ' to the others.') +
    (collapsing.length > 0
      ? ' The prediction of ' +
        enumerate(collapsing) +
        ' collapses: no law for other amplitudes or frequencies than those of the fit.'
      : ' No prediction collapses.') +
    ' A prediction collapses that misses a block by more than ' +
    (most === 1 ? '' : most + ' times ') +
    'the standard deviation of its force (OF ' +
    most +
    '), or by more than ' +
    ratio +
    ' times what the fitted blocks are missed by.'
  );
}

function predictionTable() {
  const blocks = scoredBlocks();
  const columns = [
    { title: 'Law', pinned: true, tight: true },
    { title: 'Prediction', tight: true },
    ...blocks.map(({ block, fitted, amplitudes }) => ({
      title: 'Block ' + block,
      unit:
        (amplitudes.length > 0 ? '±' + significant(average(amplitudes), 3) + THIN + 'mm, ' : '') +
        (fitted ? 'fitted' : 'predicted'),
      number: true,
    })),
    { title: 'Fitted', unit: 'mean', number: true },
    { title: 'Predicted', unit: 'mean', number: true },
    { title: 'Predicted', unit: '/ fitted', number: true },
    { title: 'Worst', unit: 'predicted', number: true },
  ];
  const rows = predictedLaws.map((law) => ({
    cells: [
      element('b', { class: 'strong' }, law.id),
      law.prediction_collapses ? element('span', { class: 'badge' }, 'collapses') : 'does not collapse',
      ...blocks.map((column) => {
        const scores = scoresOf(law, column);
        if (scores.length === 0) return element('td', { class: 'number note' }, DASH);
        const worst = scores.reduce((a, b) => (b.objective > a.objective ? b : a));
        return element(
          'td',
          { class: 'number' },
          missText(average(scores.map(({ objective }) => objective))),
          scores.length > 1
            ? element(
                'small',
                { title: worst.device },
                'worst ' + missText(worst.objective) + ', ' + short(worst.device),
              )
            : null,
        );
      }),
      fixed(law.fitted_objective, 4),
      missText(law.predicted_objective),
      law.fitted_objective > 0 ? significant(law.predicted_objective / law.fitted_objective, 2) : DASH,
      missText(law.worst_predicted),
    ],
  }));
  return table(columns, rows, 'Objective of every law on every block');
}

function predictionData() {
  return {
    columns: ['law', 'device', 'block', 'fitted or predicted', 'OF [-]', 'prediction collapses'],
    rows: predictedLaws.flatMap((law) =>
      law.devices.flatMap((fit) =>
        fit.blocks.map(({ block, fitted, objective }) => [
          law.id,
          devices[fit.device].name,
          block,
          fitted ? 'fitted' : 'predicted',
          objective,
          law.prediction_collapses ? 'yes' : 'no',
        ]),
      ),
    ),
  };
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

// --- properties: the cycles of one device

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
  for (const [from, to] of (!inspection && device.scored) || [])
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

// --- stability

// Three panels beside one another, below one another where there is no room, with cycle numbers along their abscissa.
function followedPanels(stacked, largest) {
  const layout = { annotations: [] };
  FOLLOWED.forEach((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1),
      gap = stacked ? 0.09 : 0.08,
      size = (1 - 2 * gap) / 3;
    const along = [i * (size + gap), i * (size + gap) + size];
    const down = [1 - along[1], 1 - along[0]];
    layout['xaxis' + suffix] = {
      domain: stacked ? [0, 1] : along,
      anchor: 'y' + suffix,
      range: [0.6, largest + 0.4],
      tickformat: 'd',
      dtick: Math.max(1, Math.ceil(largest / 10)),
      tick0: 1,
      zeroline: false,
      title: stacked && i < 2 ? '' : 'cycle',
      showticklabels: !stacked || i === 2,
    };
    layout['yaxis' + suffix] = {
      domain: stacked ? down : [0, 1],
      anchor: 'x' + suffix,
      title: property.title,
      zeroline: false,
      nticks: 5,
    };
  });
  return layout;
}

// Limits of a device in percent of the design value, as rule sets print them: "from -20 % to +20 %", "at least -25 %".
function limitBand(limit, nominal) {
  if (!isNumber(nominal) || !limit) return null;
  const numbers =
    String(limit)
      .replace(/\u2212/g, '-')
      .match(/[-+]?\d+(?:\.\d+)?(?= ?%)/g)
      ?.map(Number) ?? [];
  const at = (percent) => nominal * (1 + percent / 100);
  if (/^from [^%]*% to [^%]*%$/.test(limit) && numbers.length === 2) return numbers.map(at);
  if (/^at least .*%$/.test(limit) && numbers.length === 1) return [at(numbers[0]), null];
  if (/^at most .*%$/.test(limit) && numbers.length === 1) return [null, at(numbers[0])];
  return null;
}

// Design value and limits of a followed property: of one device's assessments, else of the lot.
function designOf(name, assessments) {
  const own = assessments.find(
    (a) => (a.quantity === name || a.quantity.startsWith(name + ',')) && isNumber(a.nominal),
  );
  const lot = lotQuantities.find((quantity) => quantity.quantity === name);
  const nominal = own?.nominal ?? lot?.nominal ?? null;
  return { nominal, band: limitBand(own?.limit || lot?.limit_individual, nominal) };
}

// A tenth of the values' size at least: what hardly changes from cycle to cycle shall look so.
function steadyRange(values) {
  const [low, high] = paddedRange(values, 0.08);
  const missing = Math.max(0, 0.1 * Math.max(...values.map(Math.abs)) - (high - low));
  return [low - missing / 2, high + missing / 2];
}

// The range of panel i, with the design value and the limits where there are any.
function framePanel(layout, look, i, { nominal, band }, values) {
  const some = values.filter(isNumber);
  if (some.length === 0) return;
  const suffix = i === 0 ? '' : String(i + 1);
  const [low, high] = steadyRange([...some, nominal, ...(band ?? [])].filter(isNumber));
  layout['yaxis' + suffix].range = [low, high];
  layout.shapes ??= [];
  const whole = { xref: 'x' + suffix + ' domain', yref: 'y' + suffix, x0: 0, x1: 1, layer: 'below' };
  if (band)
    layout.shapes.push({
      ...whole,
      type: 'rect',
      y0: band[0] ?? low,
      y1: band[1] ?? high,
      fillcolor: look.colour('band'),
      line: { width: 0 },
    });
  if (isNumber(nominal))
    layout.shapes.push({
      ...whole,
      type: 'line',
      y0: nominal,
      y1: nominal,
      line: { color: look.colour('good'), width: 1.2, dash: 'dash' },
    });
}

// The value of a cycle with its ratio to cycle 3, for reading off a plot.
function followedText(property, block, cycle, place) {
  const ratio = block.stability?.[property.name]?.ratio_to_third?.[place];
  return property.text(cycle[property.key]) + (isNumber(ratio) ? ', ' + fixed(ratio, 3) + ' of cycle 3' : '');
}

function emptyPlot(look, text) {
  return {
    traces: [],
    layout: {
      xaxis: { visible: false },
      yaxis: { visible: false },
      annotations: [
        {
          xref: 'paper',
          yref: 'paper',
          x: 0.5,
          y: 0.5,
          showarrow: false,
          text: plain(text),
          font: { size: 13, color: look.colour('muted') },
        },
      ],
    },
  };
}

function drawStability(look) {
  const device = devices[chosen.tested],
    blocks = chosenBlocks(device).filter((block) => counted(block).length > 0);
  if (blocks.length === 0) return emptyPlot(look, 'no cycle that counts');
  const layout = followedPanels(true, Math.max(...blocks.flatMap(counted).map((cycle) => cycle.number)));
  const traces = FOLLOWED.flatMap((property, i) =>
    blocks.map((block) => {
      const cycles = counted(block),
        suffix = i === 0 ? '' : String(i + 1),
        place = device.blocks.indexOf(block);
      return {
        name: 'block ' + block.number,
        legendgroup: String(block.number),
        showlegend: i === 0,
        mode: 'lines+markers',
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x: cycles.map((cycle) => cycle.number),
        y: cycles.map((cycle) => cycle[property.key]),
        text: cycles.map((cycle, k) => followedText(property, block, cycle, k)),
        line: { color: look.law({ index: place }), width: 1.4 },
        marker: { color: look.law({ index: place }), symbol: SYMBOLS[place % SYMBOLS.length], size: 6 },
        hovertemplate: 'cycle %{x}: %{text}<extra>block ' + block.number + '</extra>',
      };
    }),
  );
  const held = device.assessments.filter((a) => blocks.some((block) => a.block === block.number));
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      held.length > 0 ? designOf(property.name, held) : { nominal: null, band: null },
      blocks.flatMap(counted).map((cycle) => cycle[property.key]),
    ),
  );
  return {
    traces,
    layout: { ...layout, showlegend: blocks.length > 1 && blocks.length <= 6, margin: { l: 58, r: 8, t: 6, b: 40 } },
  };
}

function stabilityCaption() {
  const device = devices[chosen.tested];
  // In a caption there is room for few: of many blocks the one that is reported.
  const blocks = chosenBlocks(device);
  const said = (blocks.length > 3 ? blocks.filter((block) => block.number === device.reported?.block) : blocks)
    .map((block) => {
      const [K, E] = [block.stability?.K_eff, block.stability?.energy];
      if (!isNumber(K?.first_to_third)) return null;
      const late =
        isNumber(K.min_2_10) && isNumber(K.max_2_10)
          ? '; cycles 2\u201310: K_eff ' + fixed(K.min_2_10, 2) + ' to ' + fixed(K.max_2_10, 2)
          : '';
      return (
        'Block ' +
        block.number +
        ': first cycle ' +
        fixed(K.first_to_third, 2) +
        ' in K_eff' +
        (isNumber(E?.first_to_third) ? ', ' + fixed(E.first_to_third, 2) + ' in energy' : '') +
        late +
        '.'
      );
    })
    .filter(Boolean);
  const held = device.assessments.some(
    (a) => FOLLOWED.some(({ name }) => a.quantity.startsWith(name)) && isNumber(a.nominal),
  );
  return (
    (said.length > 0
      ? 'Against cycle 3. ' +
        said.join(' ') +
        (blocks.length > 3 ? onScreen(' Choose a block above for the others.') : '')
      : 'No block has a third cycle to compare with.') + (held ? ' Dashed: design value; band: its limits.' : '')
  );
}

function stabilityData() {
  const columns = ['first_to_third', 'first_to_mean_1_3', 'min_2_10', 'max_2_10', 'min_1_10', 'max_1_10'];
  return {
    columns: [
      'device',
      'block',
      'property',
      'cycle',
      'value',
      'ratio to cycle 3',
      ...columns.map((c) => c + ' of the block'),
    ],
    rows: devices[chosen.tested].blocks.flatMap((block) =>
      FOLLOWED.flatMap((property) =>
        counted(block).map((cycle, k) => {
          const stability = block.stability?.[property.name];
          return [
            devices[chosen.tested].name,
            block.number,
            property.title,
            cycle.number,
            cycle[property.key],
            stability?.ratio_to_third?.[k],
            ...columns.map((c) => stability?.[c]),
          ];
        }),
      ),
    ),
  };
}

// The block of a device that the lot is compared by: the chosen one, else the one that is reported.
function comparedBlock(device) {
  const number = chosen.block === 'all' ? device.reported?.block : chosen.block;
  return device.blocks.find((block) => block.number === number) ?? null;
}

function lotStabilityCaption() {
  const shown = devices.filter((device) => comparedBlock(device));
  return (
    'One line a device, ' +
    (chosen.block === 'all' ? 'its reported block (the largest amplitude)' : 'block ' + chosen.block + ' of each') +
    '; bold: ' +
    (chosen.tested === null ? 'none' : devices[chosen.tested].name) +
    '. ' +
    count(shown.length, 'device') +
    '.' +
    (lotQuantities.some((quantity) => isNumber(quantity.nominal))
      ? ' Dashed: design value; band: limits of one device.'
      : '')
  );
}

function drawLotStability(look, width) {
  const entries = devices
    .map((device) => ({ device, block: comparedBlock(device) }))
    .filter(({ block }) => block && counted(block).length > 0);
  if (entries.length === 0) return emptyPlot(look, 'no device has this block');
  const layout = followedPanels(
    width < NARROW,
    Math.max(...entries.flatMap(({ block }) => counted(block).map((cycle) => cycle.number))),
  );
  const traces = FOLLOWED.flatMap((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1);
    // All thin lines are one trace, broken between devices: 160 of them stay quick.
    const line = (among, bold) => {
      const x = [],
        y = [],
        text = [];
      for (const { device, block } of among) {
        counted(block).forEach((cycle, k) => {
          x.push(cycle.number);
          y.push(cycle[property.key]);
          text.push('<b>' + plain(device.name) + '</b><br>' + followedText(property, block, cycle, k));
        });
        x.push(null);
        y.push(null);
        text.push('');
      }
      return {
        mode: bold ? 'lines+markers' : 'lines',
        showlegend: false,
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x,
        y,
        text,
        opacity: bold ? 1 : entries.length > 40 ? 0.5 : 0.75,
        line: { color: look.colour(bold ? 'accent' : 'measured'), width: bold ? 2.6 : 0.9 },
        marker: { color: look.colour('accent'), size: 6 },
        hovertemplate: '%{text}<extra>cycle %{x}</extra>',
      };
    };
    return [
      line(
        entries.filter(({ device }) => device.index !== chosen.tested),
        false,
      ),
      line(
        entries.filter(({ device }) => device.index === chosen.tested),
        true,
      ),
    ];
  });
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      designOf(property.name, []),
      entries.flatMap(({ block }) => counted(block).map((c) => c[property.key])),
    ),
  );
  return { traces, layout: { ...layout, margin: { l: 54, r: 8, t: 8, b: 44 } } };
}

// --- tables of cycles

const isReported = (device, block, cycle) =>
  device.reported !== null &&
  block.number === device.reported.block &&
  cycle.counts &&
  cycle.number === device.reported.number;

function cycleTableCaption() {
  const device = devices[chosen.tested];
  if (device.blocks.length === 0) return 'No cycles: ' + noCycles(device);
  return (
    device.name +
    ', from raw values. In bold the reported cycle: the third of the block of largest amplitude, or its last; grey: not counted.' +
    onScreen(' K+ and K\u2212: force over displacement per side. The CSV holds more columns.')
  );
}

function cycleTable() {
  const device = devices[chosen.tested];
  const all = device.blocks.flatMap((block) => block.cycles.map((cycle) => ({ block, cycle })));
  if (all.length === 0) return element('p', { class: 'empty' }, 'No cycles: ' + noCycles(device));
  const shown = CYCLE_COLUMNS.filter(
    (column) => !column.csvOnly && all.some(({ cycle }) => isNumber(cycle[column.key])),
  );
  const columns = [
    { title: 'Block', pinned: true, name: true },
    { title: 'Cycle', number: true },
    ...shown.map((column) => ({ title: column.title, unit: column.unit, number: true, screen: column.screen })),
  ];
  const rows = all.map(({ block, cycle }, i) => {
    const first = i === 0 || all[i - 1].block !== block;
    return {
      className:
        [first ? 'group' : '', isReported(device, block, cycle) ? 'strong' : '', cycle.counts ? '' : 'uncounted']
          .filter(Boolean)
          .join(' ') || null,
      cells: [
        element(
          'span',
          {},
          first ? blockText(block).replace(/^block /, '') : '',
          cycle.counts ? null : element('small', {}, 'not counted: ' + cycle.reason),
        ),
        cycle.counts ? String(cycle.number) : DASH,
        ...shown.map((column) => column.text(cycle[column.key])),
      ],
    };
  });
  return table(columns, rows, 'Properties of every cycle of the chosen device');
}

function cycleData(among) {
  return {
    columns: [
      'device',
      'block',
      'waveform',
      'frequency [Hz]',
      'cycle',
      'counts',
      'reason',
      'reported',
      'first sample',
      'last sample',
      ...CYCLE_COLUMNS.map(
        (column) => column.key.replace(/_(mm|kN|s|percent|kN_per_mm|kN_mm|mm_s|MPa)$/, '') + ' [' + column.unit + ']',
      ),
      ...FOLLOWED.map((property) => property.name + ' / cycle 3'),
    ],
    rows: among.flatMap((device) =>
      device.blocks.flatMap((block) =>
        block.cycles.map((cycle) => [
          device.name,
          block.number,
          block.waveform,
          block.frequency_Hz,
          cycle.counts ? cycle.number : null,
          cycle.counts ? 'yes' : 'no',
          cycle.reason,
          isReported(device, block, cycle) ? 'yes' : 'no',
          cycle.first,
          cycle.last,
          ...CYCLE_COLUMNS.map((column) => cycle[column.key]),
          ...FOLLOWED.map((property) =>
            cycle.counts ? block.stability?.[property.name]?.ratio_to_third?.[counted(block).indexOf(cycle)] : null,
          ),
        ]),
      ),
    ),
  };
}

// --- verdicts

const isVerified = () => Boolean(report.assessment?.rule_set?.verified_by);
const worstVerdict = (verdicts) =>
  ['fail', 'pass', 'information', 'not assessed'].find((verdict) => verdicts.includes(verdict)) ?? null;
// With one verdict of the limits on the mean, none where the set has no such limit.
const lotQuantities = (report.assessment?.lot?.quantities ?? []).map(
  ({ mean_limits: limits, lambda_test: test, without, ...quantity }) => ({
    ...quantity,
    without: without.join('; '),
    lambda_test_min: test?.min ?? null,
    lambda_test_min_cycle: test?.min_cycle ?? null,
    lambda_test_max: test?.max ?? null,
    lambda_test_max_cycle: test?.max_cycle ?? null,
    limit_mean: limits.map(({ limit }) => limit).join('; '),
    verdict: worstVerdict(limits.map(({ verdict }) => verdict)),
    reason: [...new Set(limits.map(({ reason }) => reason).filter(Boolean))].join('; '),
  }),
);

// Word and shape say the same, so that neither colour nor sight of the shape is needed.
const VERDICTS = {
  pass: {
    tone: 'good',
    filled: true,
    path: ROUND,
    mark: 'M3.4 6.2 L5.3 8 L8.6 4',
    symbol: 'circle',
  },
  fail: {
    tone: 'poor',
    filled: true,
    path: 'M1 1 H11 V11 H1 Z',
    mark: 'M3.6 3.6 L8.4 8.4 M8.4 3.6 L3.6 8.4',
    symbol: 'square',
  },
  information: {
    tone: 'muted',
    filled: false,
    path: 'M6 .9 L11.1 6 L6 11.1 L.9 6 Z',
    mark: 'M6 5.4 V8.2 M6 3.4 V4.2',
    symbol: 'diamond-open',
  },
  'not assessed': { tone: 'muted', filled: false, path: 'M1.5 6 H10.5', mark: '', symbol: 'line-ew-open' },
};

function verdictBadge(verdict) {
  const known = VERDICTS[verdict] ?? VERDICTS['not assessed'];
  const colour = 'var(--' + known.tone + ')';
  const shapes = [[known.path, known.filled ? colour : 'none', colour]];
  if (known.mark) shapes.push([known.mark, 'none', known.filled ? 'var(--paper)' : colour]);
  return element('span', { class: 'verdict ' + known.tone }, icon(...shapes), verdict);
}

const withUnit = (value, unit, digits = 4) =>
  significant(value, digits) + (isNumber(value) && unit && unit !== '-' ? THIN + unit : '');
const limitText = (limit) => (limit ? sentence(limit).replace(/-(?=\d)/g, MINUS) : DASH);
const deviation = (percent, decimals = 1) => (isNumber(percent) ? signed(percent, decimals) + THIN + '%' : DASH);

function assessmentTable() {
  const device = devices[chosen.tested];
  if (device.assessments.length === 0)
    return element(
      'p',
      { class: 'empty' },
      device.name + ' was not assessed' + (device.properties_refusal ? ': ' + device.properties_refusal : '.'),
    );
  const columns = [
    { title: 'Quantity', pinned: true },
    { title: 'Verdict' },
    { title: 'Block', number: true, screen: true },
    { title: 'Value', number: true },
    { title: 'Design value', number: true },
    { title: 'Deviation', number: true },
    { title: 'Limits' },
    { title: 'Formula', screen: true },
    { title: 'Clause' },
  ];
  const rows = device.assessments.map((a) => ({
    cells: [
      element('b', { class: 'strong' }, a.quantity),
      element('td', { class: 'reasoned' }, verdictBadge(a.verdict), a.reason ? element('small', {}, a.reason) : null),
      isNumber(a.block) && a.block > 0 ? String(a.block) : DASH,
      withUnit(a.value, a.unit),
      withUnit(a.nominal, a.unit),
      deviation(a.deviation_percent),
      element('td', { class: 'tight' }, limitText(a.limit)),
      a.formula,
      element('td', { class: 'note clause' }, a.clause),
    ],
  }));
  return table(columns, rows, 'Assessment of the chosen device');
}

const ASSESSMENT_COLUMNS = [
  'device',
  'quantity',
  'block',
  'clause',
  'formula',
  'value',
  'unit',
  'design value',
  'deviation [%]',
  'limits',
  'verdict',
  'reason',
];

function assessmentData(among) {
  return {
    columns: ASSESSMENT_COLUMNS,
    rows: among.flatMap((device) =>
      device.assessments.map((a) => [
        device.name,
        a.quantity,
        a.block,
        a.clause,
        a.formula,
        a.value,
        a.unit,
        a.nominal,
        a.deviation_percent,
        a.limit,
        a.verdict,
        a.reason,
      ]),
    ),
  };
}

function verdictTable() {
  const key = (a) => a.quantity + '\n' + (a.limit || '');
  const quantities = [...new Map(devices.flatMap((d) => d.assessments).map((a) => [key(a), a])).entries()];
  const columns = [
    { title: 'Device', pinned: true },
    ...quantities.map(([, a]) => ({
      title: a.quantity,
      unit: a.limit ? limitText(a.limit) : 'no limit',
      full: a.clause || null,
    })),
  ];
  const failing = (device) => device.assessments.some((a) => a.verdict === 'fail');
  const rows = [...devices.filter(failing), ...devices.filter((device) => !failing(device))].map((device) => {
    const own = new Map(device.assessments.map((a) => [key(a), a]));
    const name = element('b', { class: 'strong' }, device.name);
    if (own.size === 0)
      return {
        cells: [
          name,
          element(
            'td',
            { class: 'note text', colspan: quantities.length },
            device.status !== 'ok' ? 'refused: ' + device.message : noCycles(device),
          ),
        ],
      };
    return {
      cells: [
        name,
        ...quantities.map(([id]) => {
          const a = own.get(id);
          if (!a) return element('td', { class: 'note' }, DASH);
          const number = isNumber(a.deviation_percent)
            ? deviation(a.deviation_percent)
            : isNumber(a.value)
              ? withUnit(a.value, a.unit, 3)
              : null;
          return element(
            'td',
            { class: 'judged', title: a.reason || null },
            verdictBadge(a.verdict),
            number === null ? null : element('small', {}, number),
          );
        }),
      ],
    };
  });
  return table(columns, rows, 'Verdicts, device by device');
}

// --- the lot

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

// --- devices

const reportedCycle = (device) =>
  device.blocks.flatMap((block) => block.cycles.filter((cycle) => isReported(device, block, cycle)))[0] ?? null;

function propertiesCaption() {
  const cycles = devices.map(reportedCycle).filter(Boolean);
  if (cycles.length === 0) return 'No record has a complete cycle with enough samples.';
  const span = (key, digits) => {
    const values = cycles.map((cycle) => cycle[key]).filter(isNumber);
    if (values.length === 0) return DASH;
    const low = Math.min(...values),
      high = Math.max(...values);
    return significant(low, digits) === significant(high, digits)
      ? significant(low, digits)
      : significant(low, digits) + ' to ' + significant(high, digits);
  };
  return (
    'Third counted cycle of each block, or its last' +
    (devices.some((device) => device.blocks.length > 1) ? '; in bold the reported one' : '') +
    '.' +
    onScreen(' Every cycle is in the CSV.') +
    ' Over ' +
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

function propertiesTable() {
  const some = (key) => devices.some((device) => device[key] !== null && device[key] !== '');
  const facts = [
    { key: 'serial', column: { title: 'Serial', screen: true }, text: (d) => d.serial },
    { key: 'lot', column: { title: 'Lot', screen: true }, text: (d) => d.lot },
    { key: 'test_date', column: { title: 'Tested' }, text: (d) => d.test_date },
    {
      key: 'temperature_C',
      column: { title: 'Temp.', unit: '°C', number: true },
      text: (d) => fixed(d.temperature_C, 1),
    },
  ].filter((fact) => some(fact.key));
  const strained = devices.some((device) => countedCycles(device).some((cycle) => isNumber(cycle.strain_percent)));
  const several = devices.some((device) => device.blocks.length > 1);
  const numbers = [
    { title: 'Block', number: true },
    { title: 'Cycle', number: true },
    { title: 'Amplitude', unit: 'mm', number: true },
    ...(strained ? [{ title: 'Shear strain', unit: '%', number: true }] : []),
    { title: 'Frequency', unit: 'Hz', number: true, screen: true },
    { title: 'Effective stiffness', unit: 'kN/mm', number: true },
    { title: 'Energy', unit: 'kN mm', number: true },
    { title: 'Damping', unit: '%', number: true },
    { title: 'Scragging', unit: 'K_eff 1st/3rd', number: true, screen: true },
  ];
  const columns = [
    { title: 'Device', pinned: true },
    ...facts.map((fact) => fact.column),
    ...numbers,
    { title: 'Remark' },
  ];
  const rows = devices.flatMap((device) => {
    const remark = [
      device.status !== 'ok' ? 'refused: ' + device.message : device.reported === null ? device.properties_refusal : '',
      device.warnings.length > 0 ? count(device.warnings.length, 'warning') : '',
      device.corrections.length > 0 ? count(device.corrections.length, 'correction') : '',
    ]
      .filter(Boolean)
      .join('; ');
    const lead = (first) => [
      element('b', { class: 'strong' }, first ? device.name : ''),
      ...facts.map((fact) => (first ? fact.text(device) : '')),
    ];
    const note = (text) => element('td', { class: 'note text' }, text);
    const blocks = device.blocks.filter((block) => counted(block).length > 0);
    if (blocks.length === 0)
      return [
        {
          className: 'group',
          cells: [
            ...lead(true),
            element('td', { class: 'note', colspan: numbers.length + 1 }, remark || noCycles(device)),
          ],
        },
      ];
    return blocks.map((block, i) => {
      const cycle = counted(block)[Math.min(2, counted(block).length - 1)];
      return {
        className:
          [i === 0 ? 'group' : '', several && isReported(device, block, cycle) ? 'strong' : ''].join(' ').trim() ||
          null,
        cells: [
          ...lead(i === 0),
          String(block.number),
          String(cycle.number),
          fixed(cycle.amplitude_mm, 1),
          ...(strained ? [fixed(cycle.strain_percent, 0)] : []),
          significant(block.frequency_Hz, 2),
          significant(cycle.K_eff_kN_per_mm, 4),
          fixed(cycle.energy_kN_mm, 0),
          fixed(cycle.damping_percent, 2),
          fixed(block.stability?.K_eff?.first_to_third, 2),
          note(i === 0 ? remark : ''),
        ],
      };
    });
  });
  return table(columns, rows, 'Test properties per device and block');
}

// --- how it was made

function settingRows() {
  const text = (value) => (typeof value === 'string' ? value : JSON.stringify(value));
  if (inspection) return [['isolaw', report.isolaw]]; // nothing was searched, and properties are of raw values
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
      ...device.notes.map((text) => 'Note: ' + text),
      ...device.corrections.map((text) => 'Corrected: ' + text),
      ...device.cleaning,
    ];
    if (device.status !== 'ok') sentences.push('Refused: ' + device.message);
    const warned = device.warnings.length > 0;
    return element(
      'details',
      { class: warned ? 'steps warned' : 'steps', open: devices.length === 1 },
      element(
        'summary',
        {},
        element('b', {}, device.name),
        ' \u2013 ' + device.file + (warned ? ', ' + count(device.warnings.length, 'warning') : ''),
      ),
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
  if (place.stale && figure.build) place.body.replaceChildren(figure.build());
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

// Everything that depends on what changes is drawn again; what is out of sight waits until it is seen.
function choose(changes) {
  Object.assign(chosen, changes);
  for (const follow of followers) follow();
  for (const [figure, place] of drawn) {
    if (!figure.depends?.some((key) => key in changes)) continue;
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
  if (inspection) document.getElementById('kind').textContent = 'Test records';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    ...(inspection ? [] : [count(laws.length, 'law'), 'seed ' + report.seed]),
    'isolaw ' + report.isolaw,
  ].join(' \u00b7 ');
  document.getElementById('colophon').textContent =
    'Made by isolaw ' +
    report.isolaw +
    (inspection ? ' from the test records' : ' from the campaign\u2019s store') +
    '. This file needs no network';
  document
    .getElementById('colophon')
    .append(element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'), '.');

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
    if (figures.length === 0 || (section.laws && inspection)) continue;
    const node = element(
      'section',
      { id: section.id, 'aria-labelledby': section.id + '-title' },
      element('h2', { id: section.id + '-title' }, section.title),
    );
    if (section.id === 'decision')
      node.append(element('p', { class: 'headline' }, ...withBadges(report.findings.headline)));
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
  for (const details of document.querySelectorAll('.warnings details, .steps.warned')) details.open = true;
});
window.addEventListener('afterprint', () => {
  delete document.documentElement.dataset.printing;
  for (const details of document.querySelectorAll('details.law')) details.restore();
  redraw();
  for (const [figure, place] of drawn) if (figure.caption) place.caption.textContent = figure.caption();
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
