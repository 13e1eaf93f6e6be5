// What the tests determine

section({ id: 'determination', title: 'What the tests determine', laws: true }, [
  {
    id: 'determined',
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
    width: 'wide',
    title: 'What changes together, and the intervals',
    depends: ['examined', 'device'],
    wanted: () => examinedLaws.length > 0 && chosen.device !== null,
    build: tradeOffs,
  },
]);

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
  return {
    law,
    fit,
    parameter: law.parameters[place],
    verdict: row.identifiability,
    optimum: row.optimum,
    open: [row.open_lower, row.open_upper],
    ends: [row.open_below, row.open_above],
    linear: [row.linear_lower, row.linear_upper],
    bootstrap: [row.bootstrap_lower, row.bootstrap_upper],
    values: row.profile_value,
    objectives: row.profile_objective,
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
      times: fits.filter((fit) => fit.determination[place]?.identifiability === 'undetermined').length,
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
    const verdicts = fits.map((fit) => fit.determination[place]?.identifiability).filter(Boolean);
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

function drawProfile(look) {
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
