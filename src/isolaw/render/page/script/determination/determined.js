import { chosen } from '../choice.js';
import { lawChooser } from '../choosers.js';
import { button, element, onScreen } from '../dom.js';
import { ROUND, icon } from '../icons.js';
import {
  devices, examinedLaws, examinedPlaces, laws, report, resultData, usable,
} from '../report.js';
import { symbol } from '../symbols.js';
import { table } from '../tables.js';
import { DASH, count, enumerate, percentText, rangeText, unitText } from '../text.js';
import { cellBeside, chooseCell, markChosenCell } from './cells.js';
import { examination } from './examination.js';

export const determinedFigure = {
  id: 'determined',
  width: 'wide',
  title: 'Parameters by device',
  long: true,
  depends: ['examined'],
  wanted: () => examinedLaws.length > 0,
  controls: () => [lawChooser('examined', examinedLaws)],
  caption: determinedCaption,
  csv: determinedData,
  build: determinedTable,
};

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

function determinedCaption() {
  const law = laws[chosen.examined];
  const fits = law.devices.filter((fit) => fit.determination);
  const blind = examinedPlaces(law)
    .map((place) => ({
      name: symbol(law.parameters[place].name),
      times: fits.filter((fit) => fit.determination[place]?.identifiability === 'undetermined').length,
    }))
    .filter(({ times }) => times > 0);
  const missing = usable.filter((device) => !law.fitOn.get(device.index)?.determination).map((device) => device.name);
  return (
    (blind.length === 0
      ? 'The tests determine every parameter of ' + law.name + ' that does not lie at its bound.'
      : 'The tests do not determine ' +
        enumerate(
          blind.map(({ name, times }) =>
            times === fits.length ? name : name + ' (' + times + ' of ' + count(fits.length, 'device') + ')',
          ),
          7,
        ) +
        ': other values give loops that look the same. Do not compare these values between devices.') +
    (missing.length > 0 ? ' Not examined: ' + enumerate(missing) + '.' : '') +
    onScreen(' Choose a cell by mouse or arrow keys to see its profile.')
  );
}

function determinedData() {
  const rows = examinedLaws.flatMap((law) =>
    law.devices.flatMap((fit) =>
      examinedPlaces(law)
        .filter((place) => fit.determination?.[place])
        .map((place) => [law.id, devices[fit.device].name, law.parameters[place].name, law.parameters[place].unit, fit.determination[place]]),
    ),
  );
  return resultData('determination', rows, ['law', 'device', 'parameter', 'unit']);
}

function determinedTable() {
  const law = laws[chosen.examined];
  const places = examinedPlaces(law);
  const fits = law.devices.filter((fit) => fit.determination);
  const columns = [
    { title: 'Device', pinned: true, name: true },
    ...places.map((place) => {
      const { name, unit } = law.parameters[place];
      return { title: element('span', {}, symbol(name)), full: symbol(name) + ' [' + unitText(unit) + ']', mark: true };
    }),
  ];
  const cell = (fit, place) => {
    const one = examination(law, fit.device, place);
    if (!one) return element('td', { class: 'mark note' }, DASH);
    const text =
      symbol(one.parameter.name) +
      ' on ' + devices[fit.device].name + ': ' + one.verdict + ', ' + rangeText(one.open, one.parameter.unit);
    const attributes = { class: DETERMINATIONS[one.verdict].tone, tabindex: '-1', title: text, 'aria-label': text, 'data-device': fit.device, 'data-parameter': place };
    const mark = button(determinationMark(one.verdict), (event) => chooseCell(event.currentTarget), attributes);
    return element('td', { class: 'mark', 'data-sort': one.verdict }, mark);
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
              foot: true,
              cells: [
                element(
                  'span',
                  { class: 'note', title: 'devices whose test does not determine the parameter' },
                  'open, of ' + fits.length,
                ),
                ...shares.map((share) => element('td', { class: 'mark note' }, share)),
              ],
            },
          ]
        : []),
    ],
    'Whether the tests determine the parameters of ' + law.name,
  );
  body.classList.add('marks');
  body.classList.toggle('upright', places.length > 12);
  body.addEventListener('keydown', (event) => {
    const next = cellBeside(event.target.closest('td button'), event.key);
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
    'weakly determined': 'to ±' + percentText(far) + ', or its range ends at the search box',
    undetermined: 'a wider range, or the whole search box',
    'at its bound': 'the search box, not the test, decides the value',
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
