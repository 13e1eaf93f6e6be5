import { element, strong } from '../dom.js';
import { devices, laws, ranking, resultColumns, usable } from '../report.js';
import { symbol } from '../symbols.js';
import { table } from '../tables.js';
import {
  DASH, THIN, count, fixed, isNumber, mean, rowFormat, signed, significant, spreadText, superscript, trimmed, unitText,
} from '../text.js';

export const parameterTablesFigure = {
  id: 'parameter-tables',
  title: 'Identified parameters',
  long: true,
  wanted: () => laws.some((law) => law.parameters.length > 0),
  caption: () =>
    'Mean over the runs, ± standard deviation, and the difference of the device from the lot\u2019s mean in percent. ▲ ▼: the best run lies at the upper or lower ' +
    'bound of its search box, so the bound, not the record, decided the value. ≈: the tests do not determine it. Δ: largest difference of a device from the lot\u2019s mean; β is its mean over the calibrated parameters.',
  csv: parameterData,
  build: parameterTables,
};

function bounds(law, place) {
  const found = law.devices.map((fit) => fit.parameters[place]).filter(Boolean);
  if (found.length === 0) return null;
  const same = found.every((p) => p.lower === found[0].lower && p.upper === found[0].upper);
  return { same, lower: found[0].lower, upper: found[0].upper };
}

const isOpen = (fit, place) => fit.determination?.[place]?.identifiability === 'undetermined';

function nameCell({ name, paper_name: other }) {
  if (!other) return symbol(name);
  const small = element('small', { class: 'paper-name' }, 'paper: ' + symbol(other));
  return element('th', { scope: 'row', class: 'pinned' }, symbol(name), small);
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
  const cell = (value, std, difference, bound, format, best, open = false) => {
    const text = [
      element(
        'span',
        { class: 'cell-mean', 'data-mark': bound === 'upper' ? '▲' : '▼' },
        open ? '≈' + THIN + significant(value / format.factor, 2) : fixed(value / format.factor, format.decimals),
      ),
      std === null || open ? null : element('span', { class: 'cell-std' }, spreadText(std / format.factor, format.decimals)),
      difference === null ? null : element('span', { class: 'cell-difference' }, signed(difference, 1) + THIN + '%'),
    ];
    const title = bound ? 'the best run, ' + significant(best, 4) + ', lies at the ' + bound + ' bound' : null;
    return element('td', { class: 'number' + (bound ? ' at-bound' : ''), title }, ...text);
  };
  const none = (fit) => element('td', { class: 'number note', title: fit?.message || null }, DASH);

  const objective = {
    cells: [
      strong('OF'),
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
    const meanOn = (device) => law.fitOn.get(device.index)?.parameters[place]?.mean;
    const format = rowFormat(usable.map(meanOn));
    const box = bounds(law, place),
      lot = mean(usable.filter((device) => !device.copy_of).map(meanOn).filter(isNumber));
    return {
      cells: [
        nameCell(parameter),
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
          return isNumber(p?.mean)
            ? cell(p.mean, parameter.free ? p.std : null, parameter.free ? p.percent_of_lot : null, p.at_bound, format, p.best, isOpen(fit, place))
            : none(fit);
        }),
      ],
    };
  });
  return table(columns, [objective, ...rows], 'Parameters of ' + law.name);
}

const DEVICES_PER_PRINTED_BLOCK = 6;
const MOST_PRINTED_DEVICES = 30;

function parameterTables() {
  return element(
    'div',
    {},
    ...ranking.map((law, place) => {
      const bound = law.parameters.filter((_, i) => law.devices.some((fit) => fit.parameters[i]?.at_bound)).length;
      const widest = law.parameters.filter((p) => p.delta !== null).sort((a, b) => b.delta - a.delta)[0];
      const body = element('div');
      const details = element(
        'details',
        { class: 'law' },
        element(
          'summary',
          {},
          element('b', {}, law.name),
          element('span', {}, law.title),
          element(
            'span',
            {},
            'OF ' + fixed(law.objective.mean, 4) + (law.beta === null ? '' : ', β ' + fixed(law.beta, 3)),
          ),
          widest
            ? element('span', {}, symbol(widest.name) + ' strays most, ' + fixed(100 * widest.delta, 0) + THIN + '%')
            : null,
          bound > 0 ? element('span', {}, count(bound, 'parameter') + ' at a bound somewhere') : null,
        ),
        body,
      );
      const fill = () => {
        if (details.open && !body.firstChild) body.append(parameterTable(law, usable));
      };
      details.ontoggle = fill;
      if (place === 0) {
        details.open = true;
        fill();
      }
      // A printed table cannot be scrolled. It has only a few devices, or only the means if the lot is large.
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

export function parameterData() {
  const { columns, cells } = resultColumns('parameters', [
    'mean', 'std', 'best', 'percent_of_lot', 'at_bound', 'lower', 'upper',
  ]);
  const relative = ({ mean, std }) => (isNumber(std) && mean !== 0 ? Math.abs(std / mean) : null);
  return {
    columns: ['law', 'parameter', 'in the paper', 'unit', 'device', ...columns, 'std/|mean| [-]'],
    rows: laws.flatMap((law) =>
      law.parameters.flatMap((parameter, i) =>
        law.devices
          .filter((fit) => fit.parameters[i])
          .map((fit) => [
            law.id, parameter.name, parameter.paper_name, parameter.unit, devices[fit.device].name, ...cells(fit.parameters[i]),
            relative(fit.parameters[i]),
          ]),
      ),
    ),
  };
}
