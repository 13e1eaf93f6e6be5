// The sections of the page, in the order in which the files say them; each names its figures.

const SECTIONS = [];

// entry: {id, title, controls, laws}; with laws: true it is left out where there are none. figures: [{id, title, width
// ('half', 'wide', 'narrow'), wanted, depends, caption, csv, controls, build or height and draw}].
function section(entry, figures) {
  SECTIONS.push({ ...entry, figures });
}
