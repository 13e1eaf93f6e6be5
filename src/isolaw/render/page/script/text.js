export const MINUS = '\u2212';
export const THIN = '\u202f';
export const DASH = '\u2013';

// Returns a text for a label of Plotly. Plotly interprets markup in labels, but a name from a file must remain plain
// text.
export function plain(text) {
  return String(text)
    .replace(/[\u0000-\u001f\u007f]/g, ' ')
    .replace(/&/g, '&amp;')
    .replace(/</g, '&lt;')
    .replace(/>/g, '&gt;');
}

export const short = (text, most = 14) => (text.length > most ? text.slice(0, most - 1) + '\u2026' : text);
const typeset = (text) => text.replace('-', MINUS);

export function isNumber(value) {
  return typeof value === 'number' && Number.isFinite(value);
}

export function fixed(value, decimals) {
  if (!isNumber(value)) return DASH;
  const text = value.toFixed(decimals);
  return typeset(Number(text) === 0 ? text.replace('-', '') : text); // zero has no sign
}

export function signed(value, decimals) {
  if (!isNumber(value)) return DASH;
  const text = fixed(value, decimals);
  return Number(value.toFixed(decimals)) > 0 ? '+' + text : text;
}

export function superscript(exponent) {
  return String(exponent).replace(/[-0-9]/g, (c) =>
    c === '-' ? '\u207b' : '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[c],
  );
}

export function significant(value, digits = 3) {
  if (!isNumber(value)) return DASH;
  if (value === 0) return '0';
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent >= 6 || exponent < -3)
    return typeset((value / 10 ** exponent).toFixed(digits - 1)) + '\u00b710' + superscript(exponent);
  return typeset(Number(value.toPrecision(digits)).toFixed(Math.max(0, digits - 1 - exponent)));
}

export const printed = (value, { decimals, significant: digits }) =>
  isNumber(decimals) ? fixed(value, decimals) : significant(value, digits ?? 4);

export const capitalised = (text) => text[0].toUpperCase() + text.slice(1);

// Capitalises a word at the head of a column. A symbol stays as it is.
export const atTheHead = (title) =>
  /^[a-z]{4}/.test(title) ? capitalised(title) : title.replace(/-$/, MINUS);

export const trimmed = (value, digits = 4) => typeset(String(Number(value.toPrecision(digits))));

// Writes "N/m^3" as "N/m³".
export const unitText = (unit) =>
  (unit === '' || unit === '1' ? '-' : unit).replace(/\^\(?(-?\d+(?:\.\d+)?)\)?/g, (all, power) =>
    power.includes('.') ? all : superscript(power),
  );

export const withUnit = (value, unit, digits = 4) =>
  significant(value, digits) + (isNumber(value) && unit && unit !== '-' ? THIN + unit : '');

export const shareText = (share, decimals = 1) => (isNumber(share) ? fixed(100 * share, decimals) + THIN + '%' : DASH);

export const percentText = (share) => Number((100 * share).toPrecision(3)) + THIN + '%';

// Writes an error, which is a share of the standard deviation of the measured force, as percent.
export const errorText = (error) => (!isNumber(error) ? DASH : (error < 10 ? fixed(100 * error, 1) : '> 1000') + THIN + '%');

// Decodes a curve of the data block: value k is o + s * (sum of the integers of d up to k).
export function decoded({ o, s, d }) {
  let level = 0;
  return d.map((difference) => o + s * (level += difference));
}

export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

export const spanText = (values, digits, text = fixed) => {
  const some = values.filter(isNumber);
  if (some.length === 0) return null;
  const [low, high] = [Math.min(...some), Math.max(...some)].map((value) => text(value, digits));
  return low === high ? low : low + ' to ' + high;
};

// Returns a range as text, such as "0.150 to 0.200 kN/mm". Its numbers have three significant digits, or as many as
// they need to differ, up to six. If they still look equal, only one is written.
export function rangeText([low, high], unit) {
  for (let digits = 3; digits < 7; ++digits)
    if (low === high || significant(low, digits) !== significant(high, digits))
      return (low === high ? '' : significant(low, digits) + ' to ') + withUnit(high, unitText(unit), digits);
  return withUnit(high, unitText(unit), 7);
}

export const limitText = (limit) => (limit ? sentence(limit).replace(/-(?=\d)/g, MINUS) : DASH);
export const deviation = (percent, decimals = 1) => (isNumber(percent) ? signed(percent, decimals) + THIN + '%' : DASH);

// Returns the standard deviation as text. A deviation that is too small for the printed digits must not look like zero,
// and zero itself is not printed.
export function spreadText(std, decimals) {
  if (std === 0) return '';
  const least = 10 ** -decimals;
  return ' \u00b1 ' + (std > 0 && std < least / 2 ? '<' + fixed(least, decimals) : fixed(std, decimals));
}

export const objectiveText = (statistic) =>
  statistic.mean === null
    ? DASH
    : fixed(statistic.mean, 4) + (statistic.std === null ? '' : spreadText(statistic.std, 4));

export function enumerate(names, most = 5) {
  if (names.length > most) return names.slice(0, most - 1).join(', ') + ' and ' + (names.length - most + 1) + ' more';
  return names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names[names.length - 1];
}

// Prepares a sentence written by isolaw for the page: no line break comes between a number and its percent sign, and
// negative numbers get a real minus sign in place of a hyphen.
export const sentence = (text) => text.replace(/(\d) %/g, '$1' + THIN + '%').replace(/(^|[\s(])-(?=\d)/g, '$1' + MINUS);
export const count = (number, noun) => number + ' ' + noun + (number === 1 ? '' : 's');

// Gives all numbers of a row one factor 1000^n and one number of decimals, so that their decimal points line up. The
// largest is printed with four significant digits. From 0.01 to 10,000 the factor is 1.
export function rowFormat(values) {
  const largest = Math.max(0, ...values.filter(isNumber).map(Math.abs));
  if (largest === 0) return { factor: 1, exponent: 0, decimals: 2 };
  let exponent = 3 * Math.floor(Math.log10(largest) / 3);
  if (largest < 1e4 && largest >= 1e-2) exponent = 0;
  const scaled = largest / 10 ** exponent;
  return { factor: 10 ** exponent, exponent, decimals: Math.max(0, 3 - Math.max(-2, Math.floor(Math.log10(scaled)))) };
}
