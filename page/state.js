// The data of the page, and the functions to call when they change.

const nothing = () => ({
  files: new Map(), // path, relative to the lot file -> bytes of a record
  digests: new Map(), // path -> SHA-256 of the record, in hexadecimal
  title: '', // name of the folder that was dropped
  lot: null, // the text of the lot file
  notes: [], // remarks on the last drop
  inspection: null, // content of inspection.json
  inspectionFiles: [],
  problems: [], // the program's complaints if there is no inspection
  campaign: null, // {files, summary, of: {lot, digests} or null}: results below out/, and the lot that they belong to
  parts: [], // files of a campaign that was cancelled
  cancelled: false, // whether the last identification was cancelled
  saved: true,
});

export const state = {
  ...nothing(),
  laws: [], // {id, title, parameters, set}
  rules: [], // {id, title, verified}
  lots: 0, // counts the lots so far: results of work for an earlier lot are dropped
};

export const forgetAll = () => Object.assign(state, nothing(), { lots: state.lots + 1 });

const listeners = new Set();
export const onChange = (listener) => listeners.add(listener);
export const changed = () => listeners.forEach((listener) => listener());
