// The decision

const FRONT_HEIGHT = 390;

section({ id: 'decision', title: 'The decision', laws: true }, [
  {
    id: 'front',
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
  { id: 'verdicts', width: 'narrow', title: '', build: verdictList },
  {
    id: 'ranking',
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
]);

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
