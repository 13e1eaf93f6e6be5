// Symbols in text: a letter and its index, as the program says that a name is set. Words that can only be symbols are
// found where they stand; a parameter's name, which may be a plain word, is marked where a text is made.

import { data } from './data.js';

const MARK = '\u2063'; // takes no room where nobody sets it
const { words, parameters } = data.notation;

export const symbol = (name) => (parameters[name] ? MARK + name + MARK : name);

const escaped = Object.keys(words)
  .sort((a, b) => b.length - a.length)
  .map((word) => word.replace(/[^\w]/g, '\\$&'));
// Not within a name of a file or another word; "1.6e+04" as a power of ten.
const SET = new RegExp(
  MARK + '([^' + MARK + ']+)' + MARK + '|(?<![\\w./-])(' + escaped.join('|') + ')(?![\\w/-]|[.]\\w)|(?<=\\d)e([+-]\\d\\d)(?!\\w)',
  'g',
);

// A text as pieces: strings, and [letter, index] of what is set.
function pieces(text) {
  const made = [];
  let from = 0;
  for (const found of text.matchAll(SET)) {
    made.push(text.slice(from, found.index));
    const [, marked, word, exponent] = found;
    if (exponent) made.push({ power: String(Number(exponent)) });
    else made.push({ letter: (parameters[marked] ?? words[word])[0], index: (parameters[marked] ?? words[word])[1] });
    from = found.index + found[0].length;
  }
  made.push(text.slice(from));
  return made.filter((piece) => piece !== '');
}

function node(tag, text) {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

// As children of an element.
export function typeset(text) {
  return pieces(text).flatMap((piece) => {
    if (typeof piece === 'string') return [piece];
    if (piece.power) return ['\u00b710', node('sup', piece.power.replace('-', '\u2212'))];
    return [node('i', piece.letter), ...(piece.index ? [node('sub', piece.index)] : [])];
  });
}

// Without markup: attributes.
export const unset = (text) =>
  pieces(text)
    .map((piece) => (typeof piece === 'string' ? piece : piece.power ? 'e' + piece.power : piece.letter + piece.index))
    .join('');

// As the markup of figures, of a text that has none of its own.
export const inFigure = (text) =>
  pieces(text)
    .map((piece) => {
      if (typeof piece === 'string') return piece;
      if (piece.power) return '\u00b710<sup>' + piece.power.replace('-', '\u2212') + '</sup>';
      return '<i>' + piece.letter + '</i>' + (piece.index ? '<sub>' + piece.index + '</sub>' : '');
    })
    .join('');
