// The data of the page, and the listeners for changes.

const nothing = () => ({
  files: new Map(), // path -> bytes: records, relative to the lot file
  digests: new Map(), // path -> SHA-256 of these, in hexadecimal
  title: '', // from the folder that was dropped
  lot: null, // the text of the lot file
  notes: [], // remarks on the last drop
  inspection: null, // inspection.json
  inspectionFiles: [],
  problems: [], // the program's complaints where there is no inspection
  campaign: null, // {files, summary, of: {lot, digests} or null}: results below out/, and what they were computed from
  parts: [], // files of a campaign that was cancelled
  cancelled: false, // the last identification was
  saved: true,
});

export const state = {
  ...nothing(),
  laws: [], // {id, title, parameters, set}
  rules: [], // {id, title, verified}
  lots: 0, // counts the lots so far: work that was begun for an earlier one is dropped
};

export const forgetAll = () => Object.assign(state, nothing(), { lots: state.lots + 1 });

const listeners = new Set();
export const onChange = (listener) => listeners.add(listener);
export const changed = () => listeners.forEach((listener) => listener());
