// Tests modules of the page without a browser. Forms must change one value of a lot file and keep the rest, zip files
// must be read and written, and no module may turn text into HTML.
//   node modules_test.mjs
import assert from 'node:assert/strict';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { test } from 'node:test';
import { errorIn } from '../../page/engine/errors.js';
import { isProgress, makeProgress } from '../../page/engine/progress.js';

const source = fileURLToPath(new URL('../../page/', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'isolaw-modules-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
// The page's modules end in .js, because the build joins them. Node takes only files that end in .mjs for modules, so
// this function loads a copy with that ending. The modules that it imports must be loaded before.
const load = (name) => {
  writeFileSync(join(folder, name + '.mjs'), readFileSync(join(source, name + '.js'), 'utf8').replace(/(from '\.\/\w+)\.js'/g, "$1.mjs'"));
  return import(pathToFileURL(join(folder, name + '.mjs')).href);
};
const { readToml, writeValue, settingsOf, valuesOf, withKey, withSetting, withoutTable, deviceTables } = await load('toml');
const { canMoveTests, proposalsOf, statesConditions, testsIn, withProposedTests, withTestOf, withoutConditions } = await load('lot_tests');
const { TooLarge, readZip, writeZip, looksLikeZip } = await load('zip');

const LOT = `# above
title = "Lot \\"7\\"" # said

[calibrate] # settings
laws = ["bilinear",
  "vaiana", # two of them
]
runs = 1_000

[[device]]
name = 'D\u00fcse'
file = 'a#b.csv'
columns = { disp = 'x, y', force = 3 }
# serial = ""
test-date = 2024-07-03

[device.vertical]
file = 'v.csv'

[[device]]
files = ["b.csv", 'c.csv']
`;

test('keys of a lot file are read as TOML means them', () => {
  const tables = readToml(LOT);
  const value = (number, key) => tables[number].keys.get(key).value;
  assert.equal(value(0, 'title'), 'Lot "7"');
  assert.deepEqual(value(1, 'laws'), ['bilinear', 'vaiana']);
  assert.equal(value(1, 'runs'), 1000);
  const [first, second] = deviceTables(tables);
  assert.equal(value(first, 'file'), 'a#b.csv');
  assert.deepEqual({ ...value(first, 'columns') }, { disp: 'x, y', force: 3 });
  assert.equal(value(first, 'test-date'), '2024-07-03');
  assert.deepEqual(value(second, 'files'), ['b.csv', 'c.csv']);
});

test('a value is changed and nothing else', () => {
  const [first, second] = deviceTables(readToml(LOT));
  assert.equal(withKey(LOT, first, 'name', "it's"), LOT.replace("'D\u00fcse'", '"it\'s"'));
  assert.equal(withKey(LOT, first, 'serial', 'S-1'), LOT.replace('# serial = ""', "serial = 'S-1'"));
  assert.equal(withKey(LOT, first, 'test-date', null), LOT.replace('test-date = 2024-07-03\n', ''));
  assert.equal(withKey(LOT, second, 'dt', 0.01), LOT + 'dt = 0.01\n');
  assert.equal(withKey(LOT.trimEnd(), second, 'dt', 0.01), LOT + 'dt = 0.01\n');
  assert.equal(withKey(LOT, first, 'absent', null), LOT);
  assert.equal(withSetting(LOT, 'calibrate', 'laws', 'paper'), LOT.replace(/\["bilinear"[^\]]*\]/, "'paper'"));
  assert.match(withSetting(LOT, 'acceptance', 'rules', 'ntc-2018'), /1_000\n\n\[acceptance\]\nrules = 'ntc-2018'\n\n\[\[device\]\]/);
  assert.equal(withSetting(LOT, 'acceptance', 'rules', null), LOT);
  assert.match(withSetting('[[device]]\nfile = 1\n', '', 'title', 'T'), /^title = 'T'\n\[\[device\]\]/);
});

test('a table of values, in the forms that it has', () => {
  const head = "[[device]]\nfile = 'a.csv'\n";
  const forms = [
    [head + "columns = { disp = 2, force = 'F' }\n", head + "columns = { disp = 2, force = 4 }\n"],
    [head + "columns.disp = 2\ncolumns.force = 'F'\n", head + 'columns.disp = 2\ncolumns.force = 4\n'],
    [head + "[device.columns]\ndisp = 2\nforce = 'F'\n", head + '[device.columns]\ndisp = 2\nforce = 4\n'],
    [head + "[device.units]\ndisp = 'mm'\n[device.columns]\ndisp = 2\nforce = 'F'\n", head + "[device.units]\ndisp = 'mm'\n[device.columns]\ndisp = 2\nforce = 4\n"],
    [head + "columns = 'disp=2, force=F'\n", head + "columns = { disp = 2, force = 4 }\n"],
  ];
  for (const [before, after] of forms) {
    const { values, write } = valuesOf(readToml(before), 1, 'columns');
    assert.deepEqual({ disp: Number(values.disp), force: values.force }, { disp: 2, force: 'F' }, before);
    assert.equal(write(before, 'force', 4), after);
    assert.doesNotThrow(() => readToml(write(before, 'force', null)));
    assert.equal(valuesOf(readToml(write(before, 'force', null)), 1, 'columns').values.force, undefined);
  }
  const { values, write } = valuesOf(readToml(head), 1, 'columns');
  assert.deepEqual(values, {});
  assert.equal(write(head, 'time', 1), head + 'columns = { time = 1 }\n');

  const design = (lot) => settingsOf(readToml(lot), 'acceptance', 'design');
  for (const [before, after] of [
    ['', '[acceptance]\ndesign = { K_eff = 0.7 }\n\n'],
    ['[acceptance]\nlot-size = 8\n', '[acceptance]\nlot-size = 8\ndesign = { K_eff = 0.7 }\n'],
    ["[acceptance]\ndesign = 'K_eff=0.62, disp=208'\n", '[acceptance]\ndesign = { K_eff = 0.7, disp = 208 }\n'],
    ['[acceptance]\ndesign.K_eff = 0.62\n', '[acceptance]\ndesign.K_eff = 0.7\n'],
    ['[acceptance.design]\nK_eff = 0.62\n', '[acceptance.design]\nK_eff = 0.7\n'],
    ['[acceptance]\nlot-size = 8\n[calibrate]\nruns = 1\n[acceptance.design]\nK_eff = 0.62\n', '[acceptance]\nlot-size = 8\n[calibrate]\nruns = 1\n[acceptance.design]\nK_eff = 0.7\n'],
  ]) {
    const { values: found, write: set } = design(before);
    assert.equal(found.K_eff, before.includes('K_eff') ? 0.62 : undefined, before);
    assert.equal(set(before, 'K_eff', 0.7), after);
  }
});

test('a device goes with the tables below it', () => {
  const without = withoutTable(LOT, deviceTables(readToml(LOT))[0]);
  assert.equal(without, LOT.slice(0, LOT.indexOf('[[device]]')) + "[[device]]\nfiles = [\"b.csv\", 'c.csv']\n");
});

// A lot file with three records. The second record has another time step and another serial number.
const RECORDS = `title = 'T'

[calibrate]
runs = 3

[[device]]
name = 'P1_T20C'
file = 'P1_T20C.csv'
columns = { disp = 1, force = 2 }
serial = 'S1'
rubber-thickness-mm = 208
# test-date = ""

[[device]]
name = 'P1_T-20C'
file = 'P1_T-20C.csv'
columns = { disp = 1, force = 2 }
dt = 0.01 # as the laboratory says
serial = 'S9'
temperature-C = -19.5

[[device]]
name = 'P2_T20C'
file = 'P2_T20C.csv'
columns = { disp = 1, force = 3 }
sheet = 'A'
test = 2
dt = 0.02
rubber-thickness-mm = 208
`;
const PROPOSED = new Map([
  ['P1_T20C.csv', { device: 'P1', values: { 'temperature-C': 20 } }],
  ['P1_T-20C.csv', { device: 'P1', values: { 'temperature-C': -20, aged: true } }],
  ['P2_T20C.csv', { device: 'P2', values: { 'temperature-C': 20 } }],
]);
// Returns for each file the keys by which its record is read: those of the device, overridden by those of the test.
const reading = (lot) => {
  const tables = readToml(lot);
  const keys = (table) => Object.fromEntries([...table.keys].filter(([key]) => ['columns', 'dt', 'sheet', 'test'].includes(key)).map(([key, { value }]) => [key, JSON.stringify(value)]));
  return Object.fromEntries(testsIn(tables).map(({ file, owner, table }) => [file, { ...keys(tables[owner]), ...keys(table) }]));
};
const where = (lot) => Object.fromEntries(testsIn(readToml(lot)).map(({ file, device }) => [file, device]));

test('records become tests of the proposed devices and are read as before', () => {
  const lot = withProposedTests(RECORDS, PROPOSED);
  assert.ok(statesConditions(readToml(lot)));
  assert.deepEqual(where(lot), { 'P1_T20C.csv': 'P1', 'P1_T-20C.csv': 'P1', 'P2_T20C.csv': 'P2' });
  assert.deepEqual(reading(lot), reading(RECORDS));
  assert.ok(readToml(lot).every(({ path, keys }) => path !== 'device' || !keys.has('test')), 'TOML allows no key `test` beside [[device.test]]');
  const tests = testsIn(readToml(lot));
  // A temperature that the lot file states stays a key. A temperature that only the name of the record proposes is a
  // comment until a person confirms it.
  assert.deepEqual(tests.map((one) => [one.name, one.table.keys.get('temperature-C')?.value, proposalsOf(one, ['temperature-C'])]), [['P1_T20C', undefined, { 'temperature-C': 20 }], ['P1_T-20C', -19.5, { aged: true }], ['P2_T20C', undefined, { 'temperature-C': 20 }]]);
  assert.match(withKey(lot, tests[0].number, 'temperature-C', 21), /P1_T20C\.csv'\ntemperature-C = 21\n/);
  // The serial number of the second record differs from that of its new device. The number of the record is kept as a
  // comment, and the rest of the file stays as it was.
  const [device] = deviceTables(readToml(lot));
  assert.deepEqual([readToml(lot)[device].keys.get('serial').value, readToml(lot)[device].keys.get('rubber-thickness-mm').value, lot.includes("# serial = 'S9'")], ['S1', 208, true]);
  assert.ok(lot.startsWith("title = 'T'\n\n[calibrate]\nruns = 3\n") && lot.includes('# test-date = ""'));
});

test('a test moves to another device and is read as before', () => {
  const lot = withProposedTests(RECORDS, PROPOSED);
  const moved = (from, file, name) => withTestOf(from, testsIn(readToml(from)).find((one) => one.file === file).number, name);
  for (const [file, name] of [['P1_T-20C.csv', 'P2'], ['P1_T20C.csv', 'P2'], ['P2_T20C.csv', 'P1'], ['P1_T20C.csv', 'P3'], ['P2_T20C.csv', 'P4']]) {
    const next = moved(lot, file, name);
    assert.deepEqual(where(next), { ...where(lot), [file]: name });
    assert.deepEqual(reading(next), reading(RECORDS), file + ' to ' + name);
    assert.equal(deviceTables(readToml(next)).length, new Set(Object.values(where(next))).size, 'no device without a test');
    assert.deepEqual(reading(moved(next, file, where(lot)[file])), reading(RECORDS));
  }
  // If a test becomes a device of its own, this device keeps the sizes of its type, but not the serial number of the
  // device that the test came from.
  const apart = readToml(moved(lot, 'P1_T20C.csv', 'P3'));
  const { owner } = testsIn(apart).find(({ device }) => device === 'P3');
  assert.deepEqual([apart[owner].keys.get('rubber-thickness-mm').value, apart[owner].keys.has('serial')], [208, false]);
  // Tables of a test move with it.
  const second = testsIn(readToml(lot))[1].table;
  const nested = lot.slice(0, second.to) + '[device.test.units]\ndisp = "mm"\n\n[[device.test]]\nname = "third"\nfile = "third.csv"\n\n' + lot.slice(second.to);
  assert.ok(canMoveTests(nested));
  const third = moved(nested, 'third.csv', 'P2');
  assert.deepEqual(where(third), { ...where(lot), 'third.csv': 'P2' });
  const units = readToml(moved(nested, 'P1_T-20C.csv', 'P2'));
  assert.equal(units[units.findIndex(({ path }) => path === 'device.test.units') - 1].keys.get('file').value, 'P1_T-20C.csv');
  assert.ok(!canMoveTests(lot.replace('[[device.test]]', '[device.columns]\ndisp = 1\n\n[[device.test]]')));
});

test('every test becomes a device of its own again', () => {
  let lot = withProposedTests(RECORDS, PROPOSED);
  for (const [i, { number }] of testsIn(readToml(lot)).entries()) lot = withKey(lot, number, 'order', i + 1);
  const back = withoutConditions(lot, ['order', 'temperature-C', 'aged']);
  assert.ok(!statesConditions(readToml(back)) && !/order|device\.test/.test(back));
  assert.deepEqual(where(back), where(RECORDS));
  assert.deepEqual(reading(back), reading(RECORDS));
});

test('what is typed stays a value', () => {
  for (const typed of ["'", '"', '\n[evil]', '<img src=x>', '\u0007', '\\', "a' = 1 #", '\u007f']) {
    const [first] = deviceTables(readToml(LOT));
    const text = withKey(LOT, first, 'name', typed);
    assert.equal(readToml(text)[first].keys.get('name').value, typed);
    assert.equal(readToml(text).length, readToml(LOT).length);
    assert.equal(readToml('x = ' + writeValue({ [typed]: [typed] }))[0].keys.get('x').value[typed][0], typed);
  }
});

test('what is no TOML is refused with its line', () => {
  for (const [text, line] of [['a = 1\nb', 2], ['[a\n', 1], ['a = "x\n', 1], ['a = 1\na = 2', 2], ['\n\na = [1', 3]]) assert.throws(() => readToml(text), (error) => error.line === line, text);
});

test('a failure of the program is an object, and no text is taken for one', () => {
  const error = { kind: 'input', complaints: [{ where: 'a.csv', found: 'x; allowed: y; try: z', allowed: '', advice: '', names: [] }] };
  const lines = ['isolaw: a.csv: x; allowed: y; try: z', JSON.stringify({ error, exit: 2 })];
  assert.deepEqual(errorIn(lines, 2), error);
  assert.equal(lines.length, 1);
  for (const [said, code] of [[[], 3], [['none of 2 records can be used'], 2], [['null'], 2], [['[1]'], 2], [['{"error": 1'], 1], [[JSON.stringify({ error, exit: 2 })], 0]]) {
    const before = [...said];
    assert.equal(errorIn(said, code), null);
    assert.deepEqual(said, before);
  }
});

test('the error of a law is the mean over the devices of the least objective of their runs', () => {
  let told = null;
  const progress = makeProgress([{ name: 'runs', weight: 1, tasks: 2 }], 2, (all) => (told = all));
  progress.begin(0, 0);
  progress.begin(0, 1);
  const lines = [[0, 'run bilinear 0.2 0'], [1, 'run bilinear 0.3 0'], [1, 'run bouc-wen nan 0'], [0, 'run bilinear 0.4 1'], [0, 'progress 0.5 10.0 2 4 runs']];
  for (const [task, line] of lines) {
    assert.ok(isProgress(line), line);
    progress.read(0, task, line);
  }
  progress.stop();
  const [bilinear, boucWen] = told.laws;
  assert.deepEqual([bilinear.id, bilinear.runs, bilinear.devices, bilinear.error.toFixed(6)], ['bilinear', 3, 2, '0.300000']);
  assert.deepEqual(boucWen, { id: 'bouc-wen', runs: 1, devices: 0, error: null });
  assert.ok(!isProgress('run of a law'));
});

const bytes = (text) => new TextEncoder().encode(text);

test('a zip file holds what was put into it', async () => {
  const files = [
    { path: 'lot.toml', bytes: bytes('title = 1\n') },
    { path: 'records/\u00e4 <b>.csv', bytes: bytes('1,2,3\n'.repeat(5000)) },
    { path: 'empty', bytes: new Uint8Array(0) },
    { path: 'noise', bytes: Uint8Array.from({ length: 3000 }, (_, i) => (i * i * 2654435761) >>> 7) },
  ];
  const zip = await writeZip(files);
  assert.ok(looksLikeZip(zip) && zip.length < 8000);
  assert.deepEqual(await readZip(zip), files);
  assert.deepEqual(await writeZip(files), zip);
});

test('a damaged zip file is refused, or gives what was put into it', async () => {
  const whole = bytes('abc'.repeat(100));
  const zip = await writeZip([{ path: 'a', bytes: whole }]);
  let refused = 0;
  for (let at = 0; at < zip.length; ++at) {
    const damaged = zip.slice();
    damaged[at] ^= 0xff;
    const files = await readZip(damaged).catch(() => null);
    if (files === null) ++refused;
    else for (const file of files) assert.deepEqual(file.bytes, whole, 'byte ' + at);
  }
  assert.ok(refused > 25, refused + ' of ' + zip.length);
  await assert.rejects(readZip(zip.slice(0, 40)));
  await assert.rejects(readZip(bytes('PK\u0003\u0004 this is none')));
});

test('a zip file that unpacks to too much is refused', async () => {
  const zip = await writeZip([{ path: 'bomb', bytes: new Uint8Array(70 * 1024 * 1024) }]);
  assert.ok(zip.length < 200000);
  await assert.rejects(readZip(zip), TooLarge);
  // Both headers of this zip file understate the size of its content. The page must refuse the file when the content
  // turns out to be large.
  const lying = zip.slice(), view = new DataView(lying.buffer), central = view.getUint32(lying.length - 6, true);
  for (const at of [22, central + 24]) {
    assert.equal(view.getUint32(at, true), 70 * 1024 * 1024);
    view.setUint32(at, 10, true);
  }
  await assert.rejects(readZip(lying), TooLarge);
});

test('no way from text to markup or to code, in any module', () => {
  const files = readdirSync(source).filter((name) => name.endsWith('.js'));
  assert.ok(files.length > 12);
  for (const name of files) {
    const text = readFileSync(join(source, name), 'utf8').replace(/^\s*\/\/.*$/gm, '');
    for (const forbidden of [/innerHTML|outerHTML|insertAdjacent|createContextualFragment|DOMParser|srcdoc|document\.write/, /\beval\b|new Function|setTimeout\(['"`]/, /\bfetch\b|XMLHttpRequest|WebSocket|EventSource|sendBeacon|importScripts/, /localStorage|sessionStorage|indexedDB|document\.cookie/])
      assert.doesNotMatch(text, forbidden, name);
  }
});

test('all words stand in text.js, and all of them are used', () => {
  const text = readFileSync(join(source, 'text.js'), 'utf8');
  const used = readdirSync(source).filter((name) => name.endsWith('.js') && name !== 'text.js')
    .map((name) => readFileSync(join(source, name), 'utf8'))
    .filter((module) => module.includes("from './text.js'"))
    .join('\n');
  const keys = [...text.matchAll(/^ {2}(\w+):/gm)].map(([, key]) => key);
  assert.ok(keys.length > 100);
  for (const key of keys) assert.match(used, new RegExp('\\btext\\.' + key + '\\b'), key);
  for (const [, key] of used.matchAll(/\btext\.(\w+)/g)) assert.ok(keys.includes(key) || key === 'js', 'text.' + key);
});
