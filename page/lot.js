// From files to a lot: what is a lot file, a saved campaign, a record; the program reads and writes all of it.

import { argument, asBytes, asText, fileOf, messageOf, run } from './engine_use.js';
import { changed, state } from './state.js';
import { text } from './text.js';
import { deviceTables, readToml, withSetting, writeValue } from './toml.js';

const LOT = 'lot.toml';

const recordFiles = () => [...state.files].map(([path, bytes]) => ({ path, bytes }));

// The records and the lot file, as a command gets them.
export const lotFiles = () => [...recordFiles(), { path: LOT, bytes: asBytes(state.lot) }];
export const lotPath = LOT;

// The tables of the lot file; null where this page does not understand it. Kept for the text it was read from.
const NONE = { tables: null, line: 0 };
let readOf = null,
  read = NONE;
export function lotTables() {
  if (readOf !== state.lot) {
    readOf = state.lot;
    if (state.lot === null) return (read = NONE);
    try {
      read = { tables: readToml(state.lot), line: 0 };
    } catch (error) {
      read = { tables: null, line: error.line ?? 0 };
    }
  }
  return read;
}

const filesOf = (table) => [table.keys.get('file')?.value, table.keys.get('files')?.value].flat().filter((file) => typeof file === 'string');

// All files that the lot file names, those of channels and compression tests too.
export function namedFiles() {
  const { tables } = lotTables();
  if (!tables) return null;
  const named = new Set();
  for (const table of tables) {
    for (const file of filesOf(table)) named.add(file);
    const vertical = table.keys.get('vertical')?.value;
    if (typeof vertical === 'string') named.add(vertical);
    const columns = table.keys.get('columns')?.value;
    const places = typeof columns === 'string' ? columns.split(',').map((one) => one.slice(one.indexOf('=') + 1)) : Object.values(columns ?? {});
    for (const place of places) if (typeof place === 'string' && place.includes(':')) named.add(place.slice(0, place.lastIndexOf(':')));
  }
  return named;
}

// [{number, name, file}] of the devices of the lot file.
export function lotDevices() {
  const { tables } = lotTables();
  if (!tables) return [];
  return deviceTables(tables).map((number) => {
    const table = tables[number];
    const file = filesOf(table)[0] ?? '';
    const name = table.keys.get('name')?.value;
    return { number, table, file, name: typeof name === 'string' ? name : file.replace(/^.*\//, '').replace(/\.[^.]*$/, '') };
  });
}

// What `isolaw init` says of files it cannot read stands below its devices; here it stands beside the files.
const NOT_READ = /\n*^# Not read, and no device here:\n(?:#.*\n?)*/m;

async function recognise(paths, like) {
  const files = recordFiles();
  const words = ['init', ...paths.map(argument), '--out', 'isolaw-new.toml'];
  if (like !== null) {
    files.push({ path: 'isolaw-like.toml', bytes: asBytes(like) });
    words.push('--like', 'isolaw-like.toml');
  }
  const result = await run(words, files, ['isolaw-new.toml']);
  const written = fileOf(result.files, 'isolaw-new.toml');
  const unread = [];
  // Each file that the lot file does not name was not read; why stands in the messages.
  const lot = written ? asText(written) : '';
  const block = NOT_READ.exec(lot)?.[0] ?? '';
  const body = lot.replace(NOT_READ, '\n');
  const named = new Set();
  if (body) for (const table of readToml(body)) for (const file of filesOf(table)) named.add(file);
  const said = messageOf(result.stderr).split('\n');
  for (const path of paths) {
    if (named.has(path)) continue;
    const own = said.filter((line) => line.startsWith(argument(path)) || line.startsWith('./' + path));
    const inBlock = block.split('\n').find((line) => line.includes(writeValue(path)));
    unread.push({ file: path, message: own.join('\n') || inBlock?.replace(/^.*?'\s+#\s*/, '') || (result.code === 2 ? said.join('\n') : '') });
  }
  return { lot: body, unread, refused: written ? '' : messageOf(result.stderr) };
}

const empty = (title) => 'title = ' + writeValue(title || text.untitled) + '\n';

const devicesOf = (lot) => {
  const first = readToml(lot).find(({ array }) => array);
  return first ? lot.slice(first.from) : '';
};

// New files beside what is there. Returns what the page should do next: 'inspect', 'report' or nothing.
export const addFiles = async ({ files, title, notes }) => {
  state.notes = notes;
  const store = files.find(({ path }) => /(^|\/)campaign\.sqlite$/.test(path));
  const lots = files.filter(({ path }) => /\.toml$/i.test(path));
  const own = lots.find(({ path }) => /(^|\/)lot\.toml$/.test(path)) ?? (lots.length === 1 ? lots[0] : null);
  // Names in a lot file are relative to it.
  const base = own ? own.path.slice(0, own.path.lastIndexOf('/') + 1) : '';
  const storeFolder = store ? store.path.slice(0, store.path.lastIndexOf('/') + 1) : null;
  const replaced = [],
    fresh = [];
  for (const { path, bytes } of files) {
    if (path === own?.path || (store && path === store.path)) continue;
    if (storeFolder && storeFolder !== base && path.startsWith(storeFolder)) continue; // results, which are made again
    if (/\.(html|tex|sqlite)$/i.test(path)) continue;
    const relative = path.startsWith(base) ? path.slice(base.length) : path;
    if (state.files.has(relative)) replaced.push(relative);
    state.files.set(relative, bytes);
    fresh.push(relative);
  }
  if (replaced.length > 0) state.notes.push(text.replaced(replaced));
  if (!state.title) state.title = title;
  if (own) {
    const lot = asText(own.bytes).replace(/^\ufeff/, '').replace(/\r\n/g, '\n');
    Object.assign(state, { lot, inspection: null, inspectionFiles: [], problem: '' });
    const named = namedFiles();
    const records = fresh.filter((path) => !/\.toml$/i.test(path));
    // Next month's records with this month's lot file.
    if (!store && named && records.length > 0 && named.size > 0 && ![...named].some((path) => state.files.has(path))) {
      const found = await recognise(records, lot);
      if (found.lot) {
        state.lot = found.lot;
        state.unread = found.unread;
        state.notes.push(text.likeLast(records.length));
      }
    }
  } else {
    const known = namedFilesOr(new Set());
    const records = fresh.filter((path) => !known.has(path) && !/\.toml$/i.test(path));
    if (records.length > 0 && !(store && !state.lot)) await readRecords(records);
  }
  return store ? { store: store.bytes } : {};
};

const namedFilesOr = (other) => (state.lot === null ? other : (namedFiles() ?? other));

// Files of no device yet become devices, as the program recognises them.
export const readRecords = async (paths) => {
  const found = await recognise(paths, null);
  state.unread = [...state.unread.filter(({ file }) => !paths.includes(file)), ...found.unread];
  if (state.lot === null) {
    state.lot = found.lot || empty(state.title);
    // Else the program would call it after the folder it runs in.
    state.lot = withSetting(state.lot, '', 'title', state.title || text.untitled);
  } else if (found.lot) state.lot = state.lot.replace(/\n*$/, '\n\n') + devicesOf(found.lot).replace(/\n*$/, '\n');
};

// A device that the reader says how to read.
export function addDevice(file) {
  state.unread = state.unread.filter((one) => one.file !== file);
  const name = file.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  state.lot = state.lot.replace(/\n*$/, '\n\n') + '[[device]]\nname = ' + writeValue(name) + '\nfile = ' + writeValue(file) + '\n';
}

let running = false,
  again = false;

// Cycles, properties and verdicts of what the lot file says now; called while one runs, it follows it.
export const inspect = async () => {
  if (running) {
    again = true;
    return;
  }
  running = true;
  try {
    do {
      again = false;
      const result = await run(['inspect', lotPath, '--out', 'isolaw-out'], lotFiles(), ['isolaw-out/*']);
      const json = fileOf(result.files, 'isolaw-out/inspection.json');
      if (again) continue;
      const read = json ? JSON.parse(asText(json)) : null;
      state.inspection = read && { ...read, devices: read.devices ?? [read] };
      state.inspectionFiles = result.files.map(({ path, bytes }) => ({ path: path.slice('isolaw-out/'.length), bytes }));
      state.problem = json ? '' : messageOf(result.stderr);
      changed();
    } while (again);
  } finally {
    running = false;
  }
};

// The report of a store made again: what is shown is this program's.
export const openStore = async (bytes) => {
  const result = await run(['report', 'out', '--figures', 'none'], [{ path: 'out/campaign.sqlite', bytes }], ['out/*']);
  const files = result.files.some(({ path }) => path === 'out/campaign.sqlite') ? result.files : [...result.files, { path: 'out/campaign.sqlite', bytes }];
  if (!fileOf(files, 'out/summary.json')) throw Object.assign(new Error(text.failed), { stderr: result.stderr });
  setCampaign(files);
  state.saved = true; // as it was dropped
};

export function setCampaign(files) {
  const summary = JSON.parse(asText(fileOf(files, 'out/summary.json')));
  state.campaign = { files, summary, lot: state.lot };
  if (!state.title) state.title = summary.title;
  state.saved = false;
}

// What the laws and rule sets are called: from the program, so that they are listed once.
export const readCatalogue = async () => {
  const [laws, rules] = await Promise.all([run(['laws'], [], []), run(['rules'], [], [])]);
  state.laws = [...laws.stdout.matchAll(/^(\S+) +(\S+) +(\d+) parameters? +(.*)$/gm)].map(([, id, set, parameters, title]) => ({ id, set, parameters: Number(parameters), title }));
  state.rules = [...rules.stdout.matchAll(/^(\S+) +(.*)$/gm)].map(([, id, title]) => ({ id, title })).filter(({ id }) => id !== 'template');
};

// The built-in lot, as if its folder had been dropped.
export const exampleLot = async () => {
  const { files } = await run(['example', 'example-lot'], [], ['example-lot/*']);
  return files.map(({ path, bytes }) => ({ path, bytes, inFolder: true }));
};
