// Typesets symbols in text as letter and index; data.notation has both for each name. Words that can only be symbols
// are recognised in any text. Other names of parameters may be plain words, so symbol() marks them.

import { data } from './units.js';

const MARK = '\u2063'; // an invisible character; text without typesetting may keep it
const { words, parameters } = data.notation;

export const symbol = (name) => (parameters[name] ? MARK + name + MARK : name);

const escaped = Object.keys(words)
  .sort((a, b) => b.length - a.length)
  .map((word) => word.replace(/[^\w]/g, '\\$&'));
// Finds symbols, but not inside a file name or another word. It also finds the exponent of a number such as "1.6e+04",
// which becomes a power of ten.
const SET = new RegExp(
  MARK + '([^' + MARK + ']+)' + MARK + '|(?<![\\w./-])(' + escaped.join('|') + ')(?![\\w/-]|[.]\\w)|(?<=\\d)e([+-]\\d\\d)(?!\\w)',
  'g',
);

function pieces(text) {
  const all = [];
  let from = 0;
  for (const found of text.matchAll(SET)) {
    all.push(text.slice(from, found.index));
    const [, marked, word, exponent] = found;
    if (exponent) all.push({ power: String(Number(exponent)) });
    else all.push({ letter: (parameters[marked] ?? words[word])[0], index: (parameters[marked] ?? words[word])[1] });
    from = found.index + found[0].length;
  }
  all.push(text.slice(from));
  return all.filter((piece) => piece !== '');
}

function node(tag, text) {
  const child = document.createElement(tag);
  child.textContent = text;
  return child;
}

export function typeset(text) {
  return pieces(text).flatMap((piece) => {
    if (typeof piece === 'string') return [piece];
    if (piece.power) return ['\u00b710', node('sup', piece.power.replace('-', '\u2212'))];
    return [node('i', piece.letter), ...(piece.index ? [node('sub', piece.index)] : [])];
  });
}
export const unset = (text) =>
  pieces(text)
    .map((piece) => (typeof piece === 'string' ? piece : piece.power ? 'e' + piece.power : piece.letter + piece.index))
    .join('');

// Returns the text with its symbols in Plotly's markup. The text itself must not contain markup.
export const inFigure = (text) =>
  pieces(text)
    .map((piece) => {
      if (typeof piece === 'string') return piece;
      if (piece.power) return '\u00b710<sup>' + piece.power.replace('-', '\u2212') + '</sup>';
      return '<i>' + piece.letter + '</i>' + (piece.index ? '<sub>' + piece.index + '</sub>' : '');
    })
    .join('');
