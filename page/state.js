// What the page holds, and who is told when it changes.

export const state = {
  files: new Map(), // path -> bytes: records, relative to the lot file
  title: '', // of what was dropped
  lot: null, // the text of the lot file
  unread: [], // {file, message}: no devices, because they could not be read
  notes: [], // what is to be said of the last drop
  inspection: null, // inspection.json
  inspectionFiles: [],
  problem: '', // why there is none
  campaign: null, // {files, summary, lot}: of `calibrate`, below out/
  parts: null, // of one that was cancelled
  laws: [], // {id, title, parameters, set}
  rules: [], // {id, title}
  saved: true,
};

const listeners = new Set();
export const onChange = (listener) => listeners.add(listener);
export const changed = () => listeners.forEach((listener) => listener());
