import { atTheHead, decoded, printed } from './text.js';
import { data } from './units.js';

export const report = data;
export const devices = report.devices.map((device, index) => ({ ...device, index }));

// In the data block of the page, the parameters of a fit are stored as one array for each property. This function makes
// one object for each parameter from these arrays.
function rowsOf(columns) {
  const names = Object.keys(columns);
  return columns[names[0]].map((_, i) => Object.fromEntries(names.map((name) => [name, columns[name][i]])));
}

export const laws = report.laws.map((law, index) => {
  const fits = law.devices.map((fit) => ({
    ...fit,
    parameters: rowsOf(fit.parameters),
    determination: fit.determination && rowsOf(fit.determination).map((row) => (row.identifiability ? row : null)),
  }));
  return { ...law, index, devices: fits, fitOn: new Map(fits.map((fit) => [fit.device, fit])) };
});

// Returns a row for each test of a device, with the file and its SHA-256. A device with one test has one row.
export const recordsOf = (device) => (device.tests.length > 0 ? device.tests : [device]).map(({ file, sha256 }) => ({ device, file, sha256 }));

export const usable = devices.filter((device) => device.status === 'ok');
export const drawable = usable.filter((device) => device.record.drawn > 0);
export const tested = devices.filter((device) => device.raw?.samples > 0); // devices with a raw record to show
export const inspection = laws.length === 0; // true if only records were examined and no laws fitted
export const ranking = report.findings.verdicts.map((verdict) => laws[verdict.law]);

export const lawsByObjective = report.by_objective.map((index) => laws[index]);

export const examinedLaws = lawsByObjective.filter((law) => law.devices.some((fit) => fit.determination !== null));
export const lotLaws = lawsByObjective.filter((law) => law.lot !== null);
// Returns whether the law predicts badly those blocks of the tests that it was not fitted to.
export const doesNotPredict = (law) => law.prediction_grade === 'poor' || law.prediction_grade === 'unusable';
export const predictedLaws = lawsByObjective.filter((law) => law.predicted_objective !== null);
export const predictedByFit = [...predictedLaws].sort((a, b) => a.predicted_objective - b.predicted_objective);

export function examinedPlaces(law) {
  return law.parameters
    .map((_, place) => place)
    .filter((place) => law.devices.some((fit) => fit.determination?.[place]));
}

export function firstExamined(law) {
  return law ? (examinedPlaces(law)[0] ?? 0) : 0;
}

// Returns the column headings of a kind of results, and the function cells(object), which returns the cells of one row.
// A statistic or a range takes several cells.
export function resultColumns(kind, keys = Object.keys(report.headings[kind])) {
  const cell = (value) => (typeof value === 'boolean' ? (value ? 'yes' : 'no') : value);
  const cells = (value) => (value !== null && typeof value === 'object' ? Object.values(value) : [value]).map(cell);
  return {
    columns: keys.flatMap((key) => report.headings[kind][key].map(headingText)),
    cells: (of) => keys.flatMap((key) => cells(of[key] ?? null)),
  };
}

// Returns the data of a table. An element of `rows` has the first cells of a row and, as its last item, an object. The
// results in this object become the other cells of the row.
export function resultData(kind, rows, lead = [], keys = undefined) {
  const { columns, cells } = resultColumns(kind, keys);
  return { columns: [...lead, ...columns], rows: rows.map((row) => [...row.slice(0, -1), ...cells(row.at(-1))]) };
}

export const fitData = (keys, among = laws, fitsOf = (law) => law.devices) =>
  resultData('fits', among.flatMap((law) => fitsOf(law).map((fit) => [law.id, devices[fit.device].name, fit])), ['law', 'device'], keys);

export const headingText = ({ title, unit }) => title + (unit ? ' [' + unit + ']' : '');
export const headingOf = (kind, key) => report.headings[kind][key][0];

export function numberColumn(kind, key, more = {}) {
  const heading = headingOf(kind, key);
  const { title, unit } = heading;
  return { title: atTheHead(title), unit, number: true, text: (of) => printed(of[key], heading), ...more };
}

// curve() returns the values of a curve in the data block. It decodes each curve only once and keeps the values here.
const decodedCurves = new WeakMap();

export function curve(coded) {
  if (!coded) return null;
  let values = decodedCurves.get(coded);
  if (!values) decodedCurves.set(coded, (values = decoded(coded)));
  return values;
}
