// Holds the data that the whole page shows. changed() calls all functions that were registered by onChange().

const nothing = () => ({
  files: new Map(), // path relative to the lot file -> bytes of a record
  digests: new Map(), // path -> SHA-256 of the record, in hexadecimal
  title: '', // name of the dropped folder
  lot: null, // text of the lot file
  notes: [], // remarks on the last drop
  inspection: null, // content of inspection.json
  inspectionFiles: [],
  problems: [], // the program's complaints if there is no inspection
  campaign: null, // {files, summary, of}; `of`: {lot, digests} of the data that the results come from, or null
  parts: [], // files of finished work of a cancelled campaign
  cancelled: false, // whether the user cancelled the last identification
  saved: true,
});

export const state = {
  ...nothing(),
  laws: [], // [{id, name, title, parameters, set, timed}]; `timed`: whether the law depends on time
  rules: [], // [{id, title, verified}]
  testRows: { test: [], aged: [] }, // the keys of a test and of its table `aged`: [{key, label, unit, help, kind, words}]
  lots: 0, // number of lots so far; a result that was begun for an earlier lot is dropped
};

export const forgetAll = () => Object.assign(state, nothing(), { lots: state.lots + 1 });

const listeners = new Set();
export const onChange = (listener) => listeners.add(listener);
export const changed = () => listeners.forEach((listener) => listener());
