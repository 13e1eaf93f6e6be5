// Builds a lot from dropped files. It tells lot files, saved campaigns and records apart. The program itself reads and
// writes all of them.

import { argument, asBytes, asText, complaintsOf, fileOf, run } from './engine_use.js';
import { nameOfFile, plainTests, statesConditions, withProposedTests, withoutConditions } from './lot_tests.js';
import { changed, state } from './state.js';
import { text } from './text.js';
import { deviceTables, readToml, valuesOf, withKey, withSetting, writeValue } from './toml.js';

const LOT = 'lot.toml';

const recordFiles = () => [...state.files].map(([path, bytes]) => ({ path, bytes }));

export const lotFiles = () => [...recordFiles(), { path: LOT, bytes: asBytes(state.lot) }];
export const lotPath = LOT;

// lotTables() returns the tables of the lot file, or null if this page cannot parse the file; `line` is then the line
// of the fault. It parses the file again only if the text has changed.
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

// Returns all files that the lot file names: records, single channels, compression tests and a rule set.
export function namedFiles() {
  const { tables } = lotTables();
  return tables && namedIn(tables);
}

function namedIn(tables) {
  const named = new Set();
  const rules = tables.find(({ path }) => path === 'acceptance')?.keys.get('rules')?.value;
  if (typeof rules === 'string' && /\.toml$/i.test(rules)) named.add(rules);
  for (const [number, table] of tables.entries()) {
    for (const file of filesOf(table)) named.add(file);
    const vertical = table.keys.get('vertical')?.value;
    if (typeof vertical === 'string') named.add(vertical);
    for (const place of Object.values(valuesOf(tables, number, 'columns').values)) if (typeof place === 'string' && place.includes(':')) named.add(place.slice(0, place.lastIndexOf(':')));
  }
  return named;
}

function devicesIn(tables) {
  return deviceTables(tables).map((number, i) => {
    const table = tables[number];
    const file = filesOf(table)[0] ?? '';
    const name = table.keys.get('name')?.value;
    return { id: 'device-' + (i + 1), number, place: i + 1, table, file, name: typeof name === 'string' ? name : nameOfFile(file), valuesOf: (key) => valuesOf(tables, number, key) };
  });
}

// Returns the devices of the lot file as [{id, number, place, table, file, name, valuesOf}]. `number` is the index of
// the device's table among all tables. `place` is its number among the devices, from 1.
export const lotDevices = () => devicesIn(lotTables().tables ?? []);

// `isolaw init` ends its lot file with a paragraph of comments. A line `# file = ...` in it names a file that the
// program cannot read. This page removes the paragraph and makes a device of each such file, which the program then
// refuses with a reason.
const FILES_LEFT_OUT = /\n\n(?:#.*\n)*# file = .*\n(?:#.*\n)*$/;

// Returns the table of a device with this file. The page adds it for files that the program could not read, so that
// every result reports such a file until the user removes it.
const deviceOf = (file) => '\n[[device]]\nfile = ' + writeValue(file) + '\n';

async function recognise(paths, like) {
  const files = recordFiles();
  const words = ['init', ...paths.map(argument), '--out', 'isolaw-new.toml'];
  if (like !== null) {
    files.push({ path: 'isolaw-like.toml', bytes: asBytes(like) });
    words.push('--like', 'isolaw-like.toml');
  }
  const result = await run(words, files, ['isolaw-new.toml']);
  const written = fileOf(result.files, 'isolaw-new.toml');
  const recognised = written && asText(written).replace(FILES_LEFT_OUT, '\n');
  const lot = recognised ? (like === null ? withReadInDevices(recognised) : recognised) : like !== null ? like.slice(0, devicesFrom(like)) : empty();
  const named = new Set(readToml(lot).flatMap(filesOf));
  return lot.replace(/\n*$/, '\n') + paths.filter((path) => !named.has(path)).map(deviceOf).join('');
}

const empty = () => 'title = ' + writeValue(state.title || text.untitled) + '\n';

const devicesFrom = (lot) => readToml(lot).find(({ array }) => array)?.from ?? lot.length;

// If all files share their columns and units, `isolaw init` writes these only once, for the whole lot. This function
// writes them into each device instead, because files that the user adds later may have others.
function withReadInDevices(lot) {
  for (const key of ['columns', 'units', 'channel-scale']) {
    const shared = readToml(lot).find(({ path }) => path === 'read')?.keys.get(key)?.value;
    if (shared === undefined) continue;
    for (const { number, table } of devicesIn(readToml(lot)).reverse()) lot = withKey(lot, number, key, { ...shared, ...table.keys.get(key)?.value });
    lot = withSetting(lot, 'read', key, null);
  }
  return lot;
}

// Gives every device a name of its own. A repeated name is replaced by the path of the file or gets a number.
function withNamesApart(lot) {
  const taken = new Set();
  for (const { number, name, file } of devicesIn(readToml(lot))) {
    let own = name;
    if (taken.has(own)) own = file.replace(/\.[^.]*$/, '');
    for (let i = 2; taken.has(own); ++i) own = name + ' ' + i;
    if (own !== name) lot = withKey(lot, number, 'name', own);
    taken.add(own);
  }
  return lot;
}

const digestOf = async (bytes) => [...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes))].map((byte) => byte.toString(16).padStart(2, '0')).join('');

const MARKER = 'isolaw-campaign.json';
const PARTS = /^(parts|shares|lots)\/\d+-of-\d+\//; // folders of finished work of a cancelled campaign

// Returns the file that the page adds to a saved campaign. It holds the lot file and the digests of the records that
// the results were computed from.
export const markerFile = () => ({
  path: MARKER,
  bytes: asBytes(JSON.stringify({ isolaw: 'campaign', schema: 2, of: state.campaign?.of && { lot: state.campaign.of.lot, files: Object.fromEntries(state.campaign.of.digests) } }) + '\n'),
});

// Returns the present lot file and the digests of its records. They are kept with results, to notice later changes.
export const present = () => ({ lot: state.lot, digests: new Map([...(namedFiles() ?? [])].map((path) => [path, state.digests.get(path)])) });

// Returns whether the lot file or a record has changed since the results were computed.
export const outdated = () => {
  if (!state.campaign || state.lot === null) return false;
  const { lot, digests } = state.campaign.of ?? digestsOf(state.campaign.summary);
  return (lot !== null && lot !== state.lot) || [...digests].some(([path, digest]) => state.digests.get(path) !== digest);
};

// Returns the warning that the page shows beside results and when the user saves them, or '' if there is nothing to
// warn of.
export const resultsDoubt = () => (outdated() ? text.outdated : state.campaign?.summary.complete === false ? text.incomplete : '');

export const titleOfAll = () => {
  const own = lotTables().tables?.[0].keys.get('title')?.value;
  return (typeof own === 'string' && own) || state.inspection?.title || state.campaign?.summary.title || state.title;
};

// Turns a title into a file name that every file system accepts.
export const fileName = (title) =>
  title.normalize('NFKC').replace(/[^\p{L}\p{N}._-]+/gu, '-').replace(/^[-.]+|[-.]+$/g, '').slice(0, 80) || 'isolaw';

export const lotName = () => fileName(titleOfAll() || text.untitled);

// The lot file may name a record with '\\', with other capitals or in another folder. This function finds the dropped
// record that is meant and gives it the path that the lot file has.
function rename(named) {
  const lower = (path) => path.replace(/\\/g, '/').toLowerCase();
  const last = (path) => lower(path).replace(/^.*\//, '');
  for (const path of named) {
    if (state.files.has(path)) continue;
    const free = [...state.files.keys()].filter((one) => !named.has(one));
    const same = [lower, last].map((short) => free.filter((one) => short(one) === short(path))).find((found) => found.length === 1)?.[0];
    if (same === undefined) continue;
    if (/^([A-Za-z]:|[\\/])|(^|[\\/])\.\.([\\/]|$)/.test(path)) {
      // The path leads out of the lot's folder, which the program refuses. So the lot file gets the path of the dropped
      // record instead.
      const number = lotTables().tables.findIndex(({ keys }) => keys.get('file')?.value === path);
      if (number >= 0) state.lot = withKey(state.lot, number, 'file', same);
      continue;
    }
    for (const map of [state.files, state.digests]) {
      map.set(path, map.get(same));
      map.delete(same);
    }
  }
}

const isStore = ({ path }) => /(^|\/)campaign\.sqlite$/.test(path) && !PARTS.test(path);
const isToml = ({ path }) => /\.toml$/i.test(path);
// Returns whether a TOML file is a lot file, whatever its name, and not a rule set: only a lot file has devices.
const namesDevices = ({ bytes }) => /^\s*\[\[\s*device/m.test(asText(bytes));

const folderOf = ({ path }) => path.slice(0, path.lastIndexOf('/') + 1);

// Finds the lot file and the campaign's database (`store`) among dropped files. `results` are the files that the
// program can write again from the database; they are no records unless the lot file names them. `base` is the folder
// of the lot file, to which the paths in it are relative.
function sorted(files) {
  const store = files.find(isStore);
  const lots = files.filter(isToml);
  const lot = lots.find(({ path }) => /(^|\/)lot\.toml$/.test(path)) ?? (lots.length === 1 && namesDevices(lots[0]) ? lots[0] : null);
  const base = lot ? folderOf(lot) : '';
  let named = new Set();
  try {
    if (lot) named = namedIn(readToml(asText(lot.bytes)));
  } catch {
    // The lot file cannot be parsed. The program reports the fault when it reads the file.
  }
  const outputs = /^(tables|figures)\/|^(summary|run)\.json$|\.(html|tex|sqlite)$/i;
  const results = new Set(store ? files.filter((file) => file === store || (file.path.startsWith(folderOf(store)) && !PARTS.test(file.path) && outputs.test(file.path.slice(folderOf(store).length)) && !named.has(file.path.slice(base.length)))) : []);
  return { store, lot, base, results };
}

// Returns what the dropped files would replace on the page: 'results', 'everything', or '' for nothing.
export function replaces(files) {
  if (!files.some(isStore)) return '';
  const { lot, results } = sorted(files);
  return lot || files.some((file) => file.path !== MARKER && !results.has(file)) ? 'everything' : 'results';
}

// Adds dropped files to the files of the page. If a campaign's database is among them, it returns {store, of}: the
// database and the data that it was computed from. The caller must then make the report of the database.
export const addFiles = async ({ files, title, notes }) => {
  state.notes = notes;
  const { store, lot: own, base, results } = sorted(files);
  const marker = files.find(({ path }) => path === MARKER);
  if (!own && !store && state.lot !== null && !lotTables().tables) throw Object.assign(new Error(text.lotFirst), { shown: true });
  const replaced = [],
    fresh = [],
    cancelledParts = [];
  for (const file of files) {
    const { path, bytes } = file;
    if (file === own || path === MARKER || results.has(file)) continue;
    if (marker && PARTS.test(path)) {
      cancelledParts.push({ path, bytes });
      continue;
    }
    if (/\.(html|tex|sqlite)$/i.test(path)) continue;
    const relative = path.startsWith(base) ? path.slice(base.length) : path;
    if (state.files.has(relative)) replaced.push(relative);
    state.files.set(relative, bytes);
    state.digests.set(relative, await digestOf(bytes));
    fresh.push(relative);
  }
  if (marker) state.parts = cancelledParts;
  if (replaced.length > 0) state.notes.push(text.replaced(replaced));
  if (fresh.length > 0 || own) state.saved = state.saved && (marker !== undefined || state.campaign === null);
  if (!state.title) state.title = title;
  if (own) {
    const lot = asText(own.bytes).replace(/^\ufeff/, '').replace(/\r\n/g, '\n');
    Object.assign(state, { lot, inspection: null, inspectionFiles: [], problems: [] });
    rename(namedFiles() ?? new Set());
    const named = namedFiles();
    const records = fresh.filter((path) => !/\.toml$/i.test(path));
    // If none of the records that the lot file names was dropped, the lot file belongs to an earlier lot. The new
    // records are then read with the settings of this lot file.
    if (!store && named && records.length > 0 && named.size > 0 && ![...named].some((path) => state.files.has(path))) {
      // If the lot file had no title, the program would use the name of its working folder as the title.
      state.lot = withSetting(withNamesApart(await recognise(records, lot)), '', 'title', state.title || text.untitled);
      state.notes.push(text.likeLast(records.length));
    }
  } else {
    const known = namedFilesOr(new Set());
    const records = fresh.filter((path) => !known.has(path) && !/\.toml$/i.test(path));
    if (records.length > 0 && !(store && !state.lot)) await readRecords(records);
    else if (state.lot !== null) rename(namedFiles() ?? new Set());
  }
  return store ? { store: store.bytes, of: marker && markedOf(marker.bytes) } : {};
};

function markedOf(bytes) {
  try {
    const { of } = JSON.parse(asText(bytes));
    return of && { lot: String(of.lot), digests: new Map(Object.entries(of.files)) };
  } catch {
    return null;
  }
}

const namedFilesOr = (other) => (state.lot === null ? other : (namedFiles() ?? other));

// Lets the program recognise files that belong to no device yet, and adds a device for each.
export const readRecords = async (paths) => {
  const { lots } = state;
  const found = await recognise(paths, null);
  if (state.lots !== lots) return;
  if (state.lot === null) state.lot = withSetting(withNamesApart(found), '', 'title', state.title || text.untitled);
  else state.lot = withNamesApart(state.lot.replace(/\n*$/, '\n\n') + found.slice(devicesFrom(found)).replace(/\n*$/, '\n'));
  if (statesConditions(lotTables().tables ?? [])) await proposeTests();
};

// If a device's own table names its record, this record becomes a test of a device under stated conditions. The devices
// and conditions are those that the names of the files suggest.
export const proposeTests = async () => {
  const { lots } = state;
  const files = [...new Set(plainTests(lotTables().tables).map(({ file }) => file))];
  const { stdout } = await run(['test-keys', ...files.map(argument)], [], []);
  if (state.lots !== lots || !lotTables().tables) return;
  const { proposed } = JSON.parse(stdout);
  // If a device was aged, `aged` is only `true`, because the name of a file does not say for how long and at which
  // temperature.
  const values = ({ device: _, ...stated }) => Object.fromEntries(Object.entries(stated).filter(([, value]) => value !== null && value !== false));
  state.lot = withProposedTests(state.lot, new Map(files.map((file, i) => [file, { device: proposed[i].device, values: values(proposed[i]) }])));
};

// Makes every test of the lot a device of its own. What was stated about the conditions of the tests is lost.
export const forgetConditions = (lot) => withNamesApart(withoutConditions(lot, [...state.testRows.test.map(({ key }) => key), 'aged']));

let running = false,
  again = false;

// Computes cycles, properties and verdicts for the present lot file. If it is called while it runs, it runs once more
// afterwards.
export const inspect = async () => {
  if (running) {
    again = true;
    return;
  }
  running = true;
  try {
    do {
      again = false;
      const { lots } = state;
      const result = await run(['inspect', lotPath, '--out', 'isolaw-out'], lotFiles(), ['isolaw-out/*']);
      const json = fileOf(result.files, 'isolaw-out/inspection.json');
      if (again || state.lots !== lots) continue;
      const read = json ? JSON.parse(asText(json)) : null;
      state.inspection = read && { ...read, devices: read.devices ?? [read] };
      state.inspectionFiles = result.files.map(({ path, bytes }) => ({ path: path.slice('isolaw-out/'.length), bytes }));
      state.problems = json ? [] : complaintsOf(result);
      changed();
    } while (again);
  } finally {
    running = false;
  }
};

// Returns the records' digests from the summary of a campaign that the command line computed. That summary does not
// hold the lot file, so `lot` is null.
function digestsOf({ devices }) {
  const here = (file) => [...state.files.keys()].filter((path) => path === file || path.endsWith('/' + file));
  return { lot: null, digests: new Map(devices.flatMap(({ file, sha256 }) => (here(file).length === 1 ? [[here(file)[0], sha256]] : []))) };
}

// Lets this version of the program make the report of a campaign's database. `of` is the lot file and the digests of
// the records that the results were computed from, if they are known.
export const openStore = async (bytes, of) => {
  const { lots } = state;
  const result = await run(['report', 'out', '--figures', 'none'], [{ path: 'out/campaign.sqlite', bytes }], ['out/*']);
  const files = result.files.some(({ path }) => path === 'out/campaign.sqlite') ? result.files : [...result.files, { path: 'out/campaign.sqlite', bytes }];
  if (!fileOf(files, 'out/summary.json')) throw Object.assign(new Error(text.failed), { complaints: complaintsOf(result) });
  if (state.lots !== lots) return;
  const { saved } = state;
  setCampaign(files, of ?? null);
  state.saved = saved; // the user dropped this database, so it is saved already
};

export function setCampaign(files, of) {
  const summary = JSON.parse(asText(fileOf(files, 'out/summary.json')));
  state.campaign = { files, summary, of };
  if (!state.title) state.title = summary.title;
  state.saved = false;
}

// Asks the program for its laws, its rule sets and the keys of a test, so that the page needs no list of its own.
export const readCatalogue = async () => {
  const [laws, rules, tests] = await Promise.all([['laws', '--json'], ['rules', '--json'], ['test-keys']].map((words) => run(words, [], [])));
  state.laws = JSON.parse(laws.stdout).map(({ id, name, title, set, parameters, rate_independent: untimed }) => ({ id, name, title, set, parameters: parameters.length, timed: !untimed }));
  state.rules = JSON.parse(rules.stdout).map(({ id, title, verified_by: by }) => ({ id, title, verified: by !== '' }));
  state.testRows = JSON.parse(tests.stdout);
};

// Returns the files of the built-in example lot as if the user had dropped its folder.
export const exampleLot = async () => {
  const { files } = await run(['example', 'example-lot'], [], ['example-lot/*']);
  return files.map(({ path, bytes }) => ({ path, bytes, inFolder: true }));
};
