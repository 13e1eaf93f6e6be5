import { lotLaws } from '../report.js';
import { symbol } from '../symbols.js';
import { table } from '../tables.js';
import { DASH, capitalised, fixed, isNumber, rowFormat, significant, superscript, unitText } from '../text.js';
import { ofLot } from './of_lot.js';

export const lotParametersFigure = {
  id: 'lot-parameters',
  width: 'half',
  title: 'The lot\u2019s parameters',
  depends: ['lotLaw'],
  wanted: () => lotLaws.length > 0,
  caption: lotParametersCaption,
  csv: lotParametersData,
  build: lotParametersTable,
};

function inPopulation(law, name) {
  const place = law.population?.parameters.indexOf(name) ?? -1;
  return { median: law.population?.medians[place] ?? null, scatter: law.population?.relative_std[place] ?? null };
}

function lotParametersCaption() {
  const law = ofLot();
  return (
    law.name +
    ': parameters of the one law for all devices, median of the devices\u2019 own parameters, and their standard deviation between devices without the uncertainty of the fits.' +
    (law.population?.note ? ' ' + capitalised(law.population.note) + '.' : '')
  );
}

const atBound = (law, name) => law.lot.at_bound.some(({ parameter }) => parameter === name);

// A scatter of zero means that the devices differ by no more than the uncertainty of their fits.
const scatterText = (scatter) => (scatter > 0 ? fixed(100 * scatter, 1) : 'not resolvable');

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
    const apart = Math.max(...sizes) > 100 * Math.min(...sizes); // the values differ too much for a common power of ten
    const format = apart ? { factor: 1, exponent: 0 } : rowFormat(values);
    const text = (value) => (apart ? significant(value) : fixed(value / format.factor, format.decimals));
    return {
      cells: [
        symbol(parameter.name) + (atBound(law, parameter.name) ? ', at bound' : ''),
        (format.exponent !== 0 ? '10' + superscript(format.exponent) + ' ' : '') + unitText(parameter.unit),
        ...values.map((value) => (isNumber(value) ? text(value) : DASH)),
        parameter.free ? (isNumber(scatter) ? scatterText(scatter) : DASH) : 'fixed',
      ],
    };
  });
  return table(columns, rows, 'Parameters of the lot\u2019s law ' + law.name);
}

function lotParametersData() {
  return {
    columns: ['law', 'parameter', 'unit', "lot's law", 'least worst law', 'median', 'scatter [%]'],
    rows: lotLaws.flatMap((law) =>
      law.parameters.map((parameter, place) => {
        const { median, scatter } = inPopulation(law, parameter.name);
        return [
          law.id, parameter.name, parameter.unit, law.lot.parameters[place], law.lot.least_worst_parameters[place],
          median, isNumber(scatter) ? 100 * scatter : null,
        ];
      }),
    ),
  };
}
