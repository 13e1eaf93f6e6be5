// Changes which tests the devices of a lot file have: makes records tests of devices, moves a test to another device,
// and makes each test a device of its own again. All functions take and return the text of a lot file.

import { deviceTables, readToml, withKey, withoutTable, writeValue } from './toml.js';

// Facts about a device. All other keys of a device say how its records are read, so a test can have them too.
const FACTS = ['serial', 'lot', 'test-date', 'rubber-thickness-mm', 'rubber-area-mm2', 'vertical', 'K_v', 'compound', 'size', 'temperature-C'];
// Facts that also hold for other devices of the same type.
const FACTS_OF_TYPE = ['lot', 'rubber-thickness-mm', 'rubber-area-mm2', 'compound', 'size'];

export const statesConditions = (tables) => tables.some(({ path }) => path === 'conditions');

const filesOf = ({ keys }) => [keys.get('file')?.value, keys.get('files')?.value].flat().filter((file) => typeof file === 'string');
export const nameOfFile = (path) => path.replace(/^.*\//, '').replace(/\.[^.]*$/, '').trim();
const nameOf = (table) => table.keys.get('name')?.value ?? nameOfFile(filesOf(table)[0] ?? '');

// Returns the tests of all devices as [{number, owner, table, file, name, device}]. `number` and `owner` are the
// indices of the tables of the test and of its device. They are equal if the device's own table names the record.
export function testsIn(tables) {
  let owner = 0;
  return tables.flatMap((table, number) => {
    if (table.path === 'device') owner = number;
    const [file] = filesOf(table);
    if (file === undefined || !['device', 'device.test'].includes(table.path)) return [];
    return [{ number, owner, table, file, name: nameOf(table), device: nameOf(tables[owner]) }];
  });
}

export const plainTests = (tables) => testsIn(tables).filter(({ number, owner }) => number === owner);

// Cuts a lot file into {before, devices: [{head, tests}]}, all of them texts. `before` is what stands above the
// devices, and `head` what belongs to a device but to none of its tests.
function cut(lot) {
  const tables = readToml(lot);
  const devices = [];
  const starts = tables.flatMap(({ path, array, from }) => (array && ['device', 'device.test'].includes(path) ? [{ path, from }] : []));
  for (const [i, { path, from }] of starts.entries()) {
    const piece = lot.slice(from, starts[i + 1]?.from ?? lot.length);
    if (path === 'device') devices.push({ head: piece, tests: [] });
    else devices.at(-1)?.tests.push(piece);
  }
  return { before: lot.slice(0, starts[0]?.from ?? lot.length), devices };
}

const joined = ({ before, devices }) =>
  before + devices.map(({ head, tests }) => [head, ...tests].map((piece) => piece.replace(/\n*$/, '\n\n')).join('')).join('').replace(/\n+$/, '\n');

// A piece that cut() returns is a TOML text that consists of one table, with nothing above its heading.
const keysOf = (piece) => readToml(piece)[1].keys;
const valueOf = (piece, key) => keysOf(piece).get(key)?.value;
const withValue = (piece, key, value) => withKey(piece, 1, key, value);
const nameIn = (piece) => nameOf(readToml(piece)[1]);
const sameValue = (one, other) => JSON.stringify(one) === JSON.stringify(other);
const readingKeys = (head) => [...keysOf(head).keys()].filter((key) => !['name', 'file', 'files', ...FACTS].includes(key));

// If a device has tables of its own, such as [device.columns], its tests cannot move to another device.
const isSimple = ({ head, tests }) => readToml(head).length === 2 && tests.every((test) => readToml(test).slice(2).every(({ path }) => path.startsWith('device.test.')));
export const canMoveTests = (lot) => cut(lot).devices.every(isSimple);

// For each device whose own table names its record, makes this record a test: a table [[device.test]] of the device.
function withPlainTests(lot) {
  const parts = cut(lot);
  for (const device of parts.devices) {
    const { head, tests } = device;
    if (!isSimple(device) || tests.length > 0) continue;
    const name = nameIn(head);
    let test = '[[device.test]]\n';
    for (const key of ['name', 'file', 'files', 'sheet', 'test', 'temperature-C']) {
      const value = key === 'name' ? name : valueOf(head, key);
      if (value === undefined) continue;
      test = withValue(test, key, value);
      device.head = withValue(device.head, key, key === 'name' ? name : null);
    }
    tests.push(test);
  }
  return joined(parts);
}

// Moves a test into the device with this name. `number` is the index of the table of the test. If no device has the
// name, the test gets a device of its own. How the records are read does not change.
export function withTestOf(lot, number, name) {
  const parts = cut(lot);
  const tables = readToml(lot);
  const { owner } = testsIn(tables).find((test) => test.number === number);
  const from = parts.devices[deviceTables(tables).indexOf(owner)];
  const at = tables.slice(owner, number).filter(({ path, array }) => path === 'device.test' && array).length;
  const to = parts.devices.find(({ head }) => nameIn(head) === name);
  if (to === from) return lot;
  if (!to && from.tests.length === 1) return withKey(lot, owner, 'name', name);
  let [test] = from.tests.splice(at, 1);
  if (!to) {
    let { head } = from;
    for (const key of FACTS) if (!FACTS_OF_TYPE.includes(key)) head = withValue(head, key, null);
    parts.devices.splice(parts.devices.indexOf(from) + 1, 0, { head: withValue(head, 'name', name), tests: [test] });
    return joined(parts);
  }
  for (const key of new Set([...readingKeys(from.head), ...readingKeys(to.head)])) {
    const [own, other] = [valueOf(from.head, key), valueOf(to.head, key)];
    if (sameValue(own, other)) continue;
    // If a test has a group of keys such as `columns`, these keys are added to the group of the same name in its
    // device.
    const stated = (piece, value) => {
      const present = valueOf(piece, key);
      if (value === undefined || (present !== undefined && typeof present !== 'object')) return piece;
      return withValue(piece, key, present === undefined ? value : { ...value, ...present });
    };
    test = stated(test, own);
    to.tests = to.tests.map((one) => stated(one, other));
    to.head = withValue(to.head, key, null);
  }
  // If the last test leaves a device, the device is removed. Its facts that the new device does not state are kept as
  // comments.
  if (from.tests.length === 0) {
    for (const key of FACTS) {
      const fact = valueOf(from.head, key);
      if (fact !== undefined && !sameValue(fact, valueOf(to.head, key))) test = test.replace(/\n*$/, '\n') + '# ' + key + ' = ' + writeValue(fact) + '\n';
    }
    parts.devices.splice(parts.devices.indexOf(from), 1);
  }
  to.tests.push(test);
  return joined(parts);
}

// If a device's own table names its record, this record becomes a test of the device that the program proposes.
// `proposed` maps a file to what its name suggests: {device, values}. The values are written as comments, which the
// user confirms one by one.
export function withProposedTests(lot, proposed) {
  const plain = plainTests(readToml(lot));
  let next = withPlainTests(lot);
  if (!statesConditions(readToml(next))) {
    const [first] = deviceTables(readToml(next));
    const at = readToml(next)[first].from;
    next = next.slice(0, at) + '[conditions]\n\n' + next.slice(at);
  }
  for (const { file, name } of plain) {
    const { number, owner, table } = testsIn(readToml(next)).find((test) => test.file === file && test.name === name);
    if (number === owner || !proposed.has(file)) continue;
    const { device, values } = proposed.get(file);
    const comments = Object.entries(values).filter(([key]) => !table.keys.has(key)).map(([key, value]) => '# ' + key + ' = ' + writeValue(value) + '\n');
    next = next.slice(0, table.to).replace(/\n*$/, '\n') + comments.join('') + next.slice(table.to);
    if (canMoveTests(next)) next = withTestOf(next, number, device);
  }
  return next;
}

// Returns {key: value} with the values that the name of the file suggests for the keys `wanted` and for `aged`. Leaves
// out keys that the test already states.
export function proposalsOf({ table: { keys, comments } }, wanted) {
  const found = {};
  for (const key of [...wanted, 'aged']) {
    const words = comments.get(key)?.words;
    if (!words || keys.has(key)) continue;
    try {
      found[key] = readToml(key + ' = ' + words)[0].keys.get(key).value;
    } catch {
      // The comment is no TOML value, so it proposes nothing.
    }
  }
  return found;
}

// Makes each test a device of its own. Removes the table [conditions] and the keys in `keys`, which state conditions.
export function withoutConditions(lot, keys) {
  const parts = cut(lot);
  const devices = parts.devices.flatMap(({ head, tests }) => {
    if (tests.length === 0) return [{ head, tests }];
    return tests.map((test) => {
      let own = test.replace(/^\s*\[\[\s*device\s*\.\s*test\s*\]\]/, '[[device]]').replace(/^\[device\.test\./gm, '[device.');
      own = withValue(own, 'name', nameIn(test));
      for (const key of keys) if (key !== 'temperature-C') own = withValue(own, key, null);
      for (const key of [...readingKeys(head), ...FACTS]) if (!keysOf(own).has(key) && keysOf(head).has(key)) own = withValue(own, key, valueOf(head, key));
      return { head: own, tests: [] };
    });
  });
  let next = joined({ before: parts.before, devices });
  for (let at = 0; at >= 0; ) {
    at = readToml(next).findIndex(({ path }) => /^conditions(\.|$)/.test(path));
    if (at >= 0) next = withoutTable(next, at);
  }
  return next;
}
