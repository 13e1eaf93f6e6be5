// What the page holds, and who is told when it changes.

const nothing = () => ({
  files: new Map(), // path -> bytes: records, relative to the lot file
  digests: new Map(), // path -> SHA-256 of these, in hexadecimal
  title: '', // of what was dropped
  lot: null, // the text of the lot file
  notes: [], // what is to be said of the last drop
  inspection: null, // inspection.json
  inspectionFiles: [],
  problems: [], // why there is none: the program's complaints
  campaign: null, // {files, summary, of: {lot, digests} or null}: of `calibrate`, below out/; what it was computed of
  parts: [], // files of one that was cancelled
  cancelled: false, // the last identification was
  saved: true,
});

export const state = {
  ...nothing(),
  laws: [], // {id, title, parameters, set}
  rules: [], // {id, title, verified}
  lots: 0, // that stood here before: what was begun for one of them is not this one's
};

export const forgetAll = () => Object.assign(state, nothing(), { lots: state.lots + 1 });

const listeners = new Set();
export const onChange = (listener) => listeners.add(listener);
export const changed = () => listeners.forEach((listener) => listener());
