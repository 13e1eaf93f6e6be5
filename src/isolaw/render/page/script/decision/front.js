import { choose, chosen, onChoice } from '../choice.js';
import { element } from '../dom.js';
import { labelPlaces } from '../labels.js';
import { isInadequate, predictionNote } from '../laws.js';
import { paddedRange } from '../plotting.js';
import { laws, ranking, resultColumns } from '../report.js';
import { enumerate, plain } from '../text.js';
import { drawErrors, errorsCaption } from './errors.js';
import { VIEWS, isPlaced } from '../views.js';

const FRONT_HEIGHT = 360;
const ofRobustness = () => chosen.purpose === 'robustness';

export const frontFigure = {
  id: 'front',
  width: 'wide',
  title: 'The laws compared',
  depends: ['view', 'purpose'],
  controls: VIEWS.length > 1 ? viewControl : null,
  caption: () => (ofRobustness() ? frontCaption() : errorsCaption()),
  csv: frontData,
  height: () => FRONT_HEIGHT,
  draw: (look, width) => (ofRobustness() ? drawFront(look, width) : drawErrors(look)),
};

function frontData() {
  const name = resultColumns('laws', ['id']),
    grade = resultColumns('laws', ['prediction_grade']);
  return {
    columns: [
      ...name.columns,
      ...VIEWS.flatMap((view) => [...view.columns, 'on front ' + view.title.replace('\u2019', "'")]),
      ...grade.columns,
    ],
    rows: ranking.map((law) => [
      ...name.cells(law),
      ...VIEWS.flatMap((view) => [view.robust(law), view.accurate(law), view.onFront(law) ? 'yes' : 'no']),
      ...grade.cells(law),
    ]),
  };
}

// As the list judges: on the front among the laws that describe the devices, also where others beat it.
function stands(view, law) {
  if (isInadequate(law) || view.onFront(law)) return !isInadequate(law);
  const placed = laws.filter((one) => isPlaced(view, one));
  const beats = (other) =>
    view.robust(other) <= view.robust(law) && view.accurate(other) <= view.accurate(law) &&
    (view.robust(other) < view.robust(law) || view.accurate(other) < view.accurate(law));
  return placed.some(isInadequate) && !placed.some((one) => !isInadequate(one) && beats(one));
}

const shownView = () => VIEWS.find((view) => view.id === chosen.view);

function viewControl() {
  const buttons = VIEWS.map((view) => {
    const button = element('button', { type: 'button', value: view.id }, view.title);
    button.addEventListener('click', () => choose({ view: view.id }));
    return button;
  });
  const group = element('div', { class: 'choice', role: 'group', 'aria-label': 'View' }, ...buttons);
  const follow = () => {
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.value === chosen.view));
    group.hidden = !ofRobustness();
  };
  onChoice(follow);
  follow();
  return [group];
}

function frontCaption() {
  const view = shownView();
  const placed = laws.filter((law) => isPlaced(view, law));
  const crossed = placed.filter(isInadequate).map((law) => law.id);
  const dominated = ranking
    .filter((law) => placed.includes(law) && !stands(view, law) && !isInadequate(law))
    .map((law) => law.id);
  const missing = ranking.filter((law) => !placed.includes(law));
  const leftOut = view.id !== 'converged' ? [] : placed.filter((law) => law.left_out_of_beta.length > 0);
  const reduced = view.id !== 'converged' ? [] : placed.filter((law) => law.reduced).map((law) => law.id);
  return (
    'Each point is a law; ' + view.says +
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
      ? ' Left out of β: ' + leftOut.map((law) => enumerate(law.left_out_of_beta) + ' of ' + law.id).join('; ') + '.'
      : '') +
    (reduced.length > 0 ? ' Of the form without the redundant parameter: ' + enumerate(reduced) + '.' : '') +
    (missing.length > 0
      ? ' Not shown: ' +
        missing.map((law) => law.id + (view.whyNot(law) ? ' (' + view.whyNot(law) + ')' : '')).join('; ') + '.'
      : '') +
    predictionNote(placed)
  );
}

function drawFront(look, width) {
  const view = shownView();
  const shown = laws.filter((law) => isPlaced(view, law));
  const adequate = shown.filter((law) => !isInadequate(law)),
    crossed = shown.filter(isInadequate);
  const height = FRONT_HEIGHT;
  const edge = shown.filter((law) => stands(view, law)).sort((a, b) => view.robust(a) - view.robust(b));
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
  const points = (some, name, symbol, colour) => {
    const onFront = symbol === 'circle';
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
        size: onFront ? 12 : 11, symbol, color: look.colour(colour), line: { width: 2, color: look.colour(colour) },
      },
      hovertemplate:
        '<b>%{text}</b><br>' + view.columns[1].replace(' [-]', '') +
        ' %{y:.4f}<br>' + view.columns[0].replace(' [-]', '') + ' %{x:.3f}<extra></extra>',
    };
  };
  return {
    traces: [
      {
        x: edge.map(view.robust), y: edge.map(view.accurate), mode: 'lines', hoverinfo: 'skip', showlegend: false,
        opacity: 0.55, line: { shape: 'hv', width: 1.2, dash: 'dot', color: look.colour('good') },
      },
      points(edge, 'not dominated', 'circle', 'good'),
      points(adequate.filter((law) => !edge.includes(law)), 'dominated', 'diamond-open', 'poor'),
      ...(crossed.length > 0 ? [points(crossed, 'not adequate', 'x-thin', 'poor')] : []),
    ],
    layout: {
      showlegend: true,
      xaxis: { title: view.axes[0], range: xRange, zeroline: false },
      yaxis: { title: view.axes[1], range: yRange, zeroline: false },
    },
  };
}
