// Text and numbers

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
