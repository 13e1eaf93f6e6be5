import { choiceButtons, chosen } from '../choice.js';
import { labelPlaces } from '../labels.js';
import { isInadequate, nameOf, predictionNote } from '../laws.js';
import { NARROW, paddedRange, textWidth } from '../plotting.js';
import { laws, ranking, report, resultColumns } from '../report.js';
import { enumerate, plain } from '../text.js';
import { VIEWS, isPlaced } from '../views.js';

const FRONT_HEIGHT = 360,
  LABEL_SIZE = 13;

export const frontFigure = {
  id: 'front',
  width: 'wide',
  title: '',
  wanted: () => VIEWS.length > 0,
  depends: ['view'],
  controls: VIEWS.length > 1 ? viewControl : null,
  caption: frontCaption,
  csv: frontData,
  height: () => FRONT_HEIGHT,
  draw: drawFront,
};

function frontData() {
  const name = resultColumns('laws', ['id']),
    grade = resultColumns('laws', ['prediction_grade']);
  return {
    columns: [
      ...name.columns,
      ...VIEWS.flatMap((view) => [...view.names.map((name) => name + ' [-]'), 'on front ' + view.column]),
      ...grade.columns,
    ],
    rows: ranking.map((law) => [
      ...name.cells(law),
      ...VIEWS.flatMap((view) => [view.robust(law), view.accurate(law), view.onFront(law) ? 'yes' : 'no']),
      ...grade.cells(law),
    ]),
  };
}

const stands = (view, law) => report.stands[view.id].includes(law.id);

const shownView = () => VIEWS.find((view) => view.id === chosen.view);

function viewControl() {
  return [choiceButtons('view', VIEWS.map(({ id, title }) => [id, title]), { 'aria-label': 'View' })];
}

function frontCaption() {
  const view = shownView();
  const placed = laws.filter((law) => isPlaced(view, law));
  const crossed = placed.filter(isInadequate).map((law) => law.name);
  const dominated = ranking
    .filter((law) => placed.includes(law) && !stands(view, law) && !isInadequate(law))
    .map((law) => law.name);
  const missing = ranking.filter((law) => !placed.includes(law));
  const leftOut = view.id !== 'converged' ? [] : placed.filter((law) => law.left_out_of_beta.length > 0);
  const reduced = view.id !== 'converged' ? [] : placed.filter((law) => law.reduced).map((law) => law.name);
  return (
    'Each point is a law: ' + view.says +
    (crossed.length > 0 ? ' No law that describes the devices' : ' No law') +
    ' lies both below and left of a filled green point' +
    (dominated.length > 0
      ? '; ' + enumerate(dominated) + (dominated.length === 1 ? ' is' : ' are') + ' beaten in both respects.'
      : '.') +
    (crossed.length > 0
      ? ' A cross marks a law that does not describe the devices: ' + enumerate(crossed) +
        '.'
      : '') +
    (leftOut.length > 0
      ? ' Left out of β: ' + leftOut.map((law) => enumerate(law.left_out_of_beta) + ' of ' + law.name).join('; ') + '.'
      : '') +
    (reduced.length > 0 ? ' Shown without the redundant parameter: ' + enumerate(reduced) + '.' : '') +
    (missing.length > 0
      ? ' Not shown: ' +
        missing.map((law) => law.name + (view.whyNot(law) ? ' (' + view.whyNot(law) + ')' : '')).join('; ') + '.'
      : '') +
    (publishedPoints(view).length > 0
      ? ' Open circles: the laws of the published study by their numbers, its front dashed (Table A.5, its own devices).'
      : '') +
    predictionNote(placed)
  );
}

// Returns the points of the published study, one for each law. The study has numbers only for the view of the means
// over the runs.
function publishedPoints(view) {
  if (view.id !== 'runs' || report.published === null) return [];
  return report.published.laws.filter(({ number }, i, all) => all.findIndex((one) => one.number === number) === i);
}

function ghosts(look, view) {
  const points = publishedPoints(view);
  if (points.length === 0) return [];
  const front = points.filter((law) => law.published_on_front).sort((a, b) => a.published_beta - b.published_beta);
  const at = (some) => ({ x: some.map((law) => law.published_beta), y: some.map((law) => law.published_objective) });
  return [
    {
      ...at(front), mode: 'lines', hoverinfo: 'skip', showlegend: false, opacity: 0.7,
      line: { shape: 'hv', width: 1, dash: 'dash', color: look.colour('measured') },
    },
    {
      ...at(points), name: 'published', mode: 'markers+text', cliponaxis: false,
      text: points.map((law) => String(law.number)),
      textposition: 'middle center',
      textfont: { size: 10, color: look.colour('muted') },
      marker: {
        size: 16, symbol: 'circle-open', color: look.colour('measured'),
        line: { width: 1.2, color: look.colour('measured') },
      },
      customdata: points.map((law) => plain(nameOf(law.law))),
      hovertemplate: '<b>law %{text}, %{customdata}</b>, published<br>mean OF %{y:.4f}<br>beta %{x:.3f}<extra></extra>',
    },
  ];
}

const FRONT_MARGIN = { l: 62, r: 14, b: 46 };

function drawFront(look, width) {
  const view = shownView();
  const shown = laws.filter((law) => isPlaced(view, law));
  const adequate = shown.filter((law) => !isInadequate(law)),
    crossed = shown.filter(isInadequate);
  const margin = { ...FRONT_MARGIN, t: width < NARROW ? 50 : 30 }; // room for the key
  const edge = shown.filter((law) => stands(view, law)).sort((a, b) => view.robust(a) - view.robust(b));
  const printed = publishedPoints(view);
  const xRange = paddedRange([...shown.map(view.robust), ...printed.map((law) => law.published_beta)], 0.13),
    yRange = paddedRange([...shown.map(view.accurate), ...printed.map((law) => law.published_objective)], 0.13);
  const wide = width - margin.l - margin.r,
    high = FRONT_HEIGHT - margin.t - margin.b;
  const at = (x, y) => ({
    x: ((x - xRange[0]) / (xRange[1] - xRange[0])) * wide,
    y: (1 - (y - yRange[0]) / (yRange[1] - yRange[0])) * high,
  });
  const points = shown.map((law) => ({
    ...at(view.robust(law), view.accurate(law)), width: textWidth(look, law.name, LABEL_SIZE),
  }));
  const places = labelPlaces(
    points,
    edge.map((law) => shown.indexOf(law)),
    wide,
    high,
    printed.map((law) => at(law.published_beta, law.published_objective)),
  );
  const marks = (some, name, symbol, colour) => ({
    name,
    x: some.map(view.robust),
    y: some.map(view.accurate),
    mode: 'markers',
    cliponaxis: false,
    text: some.map((law) => plain(law.name)),
    marker: {
      size: symbol === 'circle' ? 12 : 11, symbol, color: look.colour(colour), line: { width: 2, color: look.colour(colour) },
    },
    hovertemplate:
      '<b>%{text}</b><br>' + view.names[1] + ' %{y:.4f}<br>' + view.names[0] + ' %{x:.3f}<extra></extra>',
  });
  const label = (law, i) => {
    const { x, y, adjacent } = places[i];
    return {
      x: view.robust(law), y: view.accurate(law), ax: x - points[i].x, ay: y - points[i].y, xanchor: 'center', yanchor: 'middle',
      text: plain(law.name), borderpad: 0, showarrow: true, arrowhead: 0, arrowwidth: 0.8, standoff: 8,
      arrowcolor: adjacent ? 'rgba(0,0,0,0)' : look.colour('muted'),
      font: { size: LABEL_SIZE, color: look.colour(edge.includes(law) ? 'ink' : 'muted') },
    };
  };
  return {
    traces: [
      {
        x: edge.map(view.robust), y: edge.map(view.accurate), mode: 'lines', hoverinfo: 'skip', showlegend: false,
        opacity: 0.55, line: { shape: 'hv', width: 1.2, dash: 'dot', color: look.colour('good') },
      },
      marks(edge, 'not dominated', 'circle', 'good'),
      marks(adequate.filter((law) => !edge.includes(law)), 'dominated', 'diamond-open', 'poor'),
      ...(crossed.length > 0 ? [marks(crossed, 'not adequate', 'x-thin', 'poor')] : []),
      ...ghosts(look, view),
    ],
    layout: {
      showlegend: true,
      margin,
      annotations: shown.map(label),
      xaxis: { title: view.axes[0], range: xRange, zeroline: false, automargin: false, nticks: width < NARROW ? 5 : 8 },
      yaxis: { title: view.axes[1], range: yRange, zeroline: false, automargin: false },
    },
  };
}
