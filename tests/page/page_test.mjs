// Tests the page in Chromium as a user uses it: opens its file, drops files on it and reads the files that it saves.
//   node page_test.mjs PAGE.html ISOLAW [CHROMIUM] [--stand-in] [--only NAME]
// ISOLAW is the native program, with whose results the page's results are compared. With --stand-in, ISOLAW also
// answers in place of the page's engine; the page must then be assembled with stand_in/engine.js.
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { browserOr77, openPage, wait, watchMemory } from './drive.mjs';
import { answerWith } from './stand_in.mjs';

const words = process.argv.slice(2).filter((word, i, all) => !word.startsWith('--') && all[i - 1] !== '--only');
const [file, isolaw, program = '/usr/bin/chromium'] = words;
const only = process.argv.includes('--only') ? process.argv[process.argv.indexOf('--only') + 1] : null;
const standIn = process.argv.includes('--stand-in') ? (page) => answerWith(page, isolaw) : null;
const here = dirname(fileURLToPath(import.meta.url)),
  root = join(here, '../..');
const work = mkdtempSync(join(tmpdir(), 'isolaw-page-test-'));
const browser = browserOr77(program);
const failures = [];
let name = '';
const expect = (holds, what) => {
  if (!holds) {
    failures.push(name + ': ' + what);
    console.log('  FAILED ' + what);
  }
};
const equal = (found, wanted, what) => expect(JSON.stringify(found) === JSON.stringify(wanted), `${what}: ${JSON.stringify(found)}, not ${JSON.stringify(wanted)}`);

// Loads the page's own reader of zip files. Node reads only files that end in .mjs as modules, so this makes a copy.
copyFileSync(join(root, 'page/zip.js'), join(work, 'zip.mjs'));
const { readZip } = await import(pathToFileURL(join(work, 'zip.mjs')).href);

execFileSync(isolaw, ['example', join(work, 'example')], { stdio: 'ignore' });
const example = join(work, 'example');
const records = readdirSync(example).filter((one) => one.startsWith('device-')).sort();
const conditions = join(work, 'conditions'); // the example lot whose devices were tested under several conditions
execFileSync(isolaw, ['example', conditions, '--conditions'], { stdio: 'ignore' });
// The page and the command line use different instruction sets, so their results agree only to six digits.
const rounded = (value) => JSON.stringify(value, (_, one) => (typeof one === 'number' ? Number(one.toPrecision(6)) : one));

const open = (options = {}) => openPage(browser, file, { standIn, ...options });
// Ends a test. The page and its frames must have reported no error and requested nothing from a network.
async function end(page) {
  await wait(200);
  equal(page.errors, [], 'errors on the console');
  equal((await page.evaluate('document.body.dataset.errors')).trim(), '', 'errors in the page');
  equal(page.requests.filter((url) => !url.startsWith('file:')), [], 'requests');
  equal(page.requests.filter((url) => url.startsWith('file:') && !url.endsWith(encodeURI(file.split('/').pop()))), [], 'files asked for');
  await page.close();
}
const failure = (page) => page.evaluate("document.getElementById('failure').hidden ? '' : document.getElementById('failure').innerText");
const rows = (page) => page.evaluate("[...document.querySelectorAll('#devices tr.device')].map((row) => ({ name: row.querySelector('.named span').firstChild.textContent, tone: row.dataset.tone, samples: row.children[1].textContent, amplitude: row.children[2].textContent, stiffness: row.children[3].textContent, damping: row.children[4].textContent, words: row.innerText }))");
const lotText = (page) => page.evaluate("document.getElementById('lot-text').value");
const band = (page) => page.text('#read-band .word');
// Returns the id of the input field for a key of lot.toml in the form of one device.
const fieldOf = (page, row, key) => page.evaluate(`(() => { const number = document.querySelectorAll('#devices tr.device')[${row}].querySelector('[id^=reread-]').id.slice(7); return 'device-' + number + '-' + ${JSON.stringify(key)}; })()`);
const openForm = (page, row) => page.evaluate(`(() => { const it = document.querySelectorAll('#devices tr.device')[${row}].querySelector('[id^=reread-]'); if (it.getAttribute('aria-expanded') === 'false') it.click(); })()`);
const set = async (page, id, value) => {
  await page.type(id, value);
  await page.idle();
};
// This expression scrolls to the first plot of a report and is true once the plot is drawn. A report draws a plot only
// when it comes into view.
const PLOTS = "document.querySelector('.plot').scrollIntoView() || document.querySelectorAll('.plot .main-svg').length > 0";
const inFrameUntil = async (page, expression, what) => {
  for (let i = 0; i < 400; ++i) {
    const value = await page.inFrame(`(() => { try { return ${expression} } catch { return null } })()`).catch(() => null);
    if (value) return value;
    await wait(50);
  }
  throw new Error('waited 20 s in the frame for: ' + what);
};
// A browser on a telephone widens its window to the widest content, so there the content is compared with the screen.
const narrow = async (page, what) => expect((await page.evaluate('document.documentElement.scrollWidth <= (screen.width < 500 ? screen.width : innerWidth)')) === true, what + ': wider than the window');

// Identifies laws with the settings that the page shows. Returns the seconds until the report appeared.
async function identified(page, seconds) {
  await page.press('show-laws');
  const began = performance.now();
  await page.press('identify');
  await page.until("document.getElementById('progress-bar')", 'progress');
  await page.until("!document.getElementById('progress-bar')", 'the end of identification', seconds);
  await page.until("document.getElementById('report-frame') || !document.getElementById('failure').hidden", 'the report');
  equal(await failure(page), '', 'a failure');
  return (performance.now() - began) / 1000;
}

// Identifies laws with little work: one run of each law and no analyses.
async function identifyLittle(page, laws = ['bilinear'], seconds = 300) {
  await page.press('show-laws');
  if (await page.evaluate("Boolean(document.getElementById('change'))")) await page.press('change');
  await page.press('laws-some');
  await page.idle();
  for (const id of await page.evaluate("[...document.querySelectorAll('.options.laws input')].map(({ id }) => id.slice(4))")) {
    if ((await page.evaluate(`document.getElementById('law-${id}').checked`)) === laws.includes(id)) continue;
    await page.press('law-' + id);
    await page.idle();
  }
  await set(page, 'method', 'best');
  await set(page, 'runs', '1');
  await set(page, 'analysis', 'none');
  await identified(page, seconds);
}

const tests = {
  // The page is timed three times, and the shortest time is judged, because other work on the machine can only slow the
  // page.
  'first use within 3 s': async () => {
    const times = [];
    for (let i = 0; i < 3; ++i) {
      const page = await open();
      times.push(page.openedIn);
      equal(await failure(page), '', 'a failure');
      await end(page);
    }
    console.log('  ready in ' + times.map((time) => time.toFixed(2)).join(', ') + ' s');
    expect(Math.min(...times) < 3, 'ready in ' + Math.min(...times) + ' s at best');
  },

  'the ten files of the example lot, as a folder': async () => {
    const page = await open();
    await page.drop([example]);
    equal(await failure(page), '', 'a failure');
    const found = await rows(page);
    equal(found.map((row) => row.name), Array.from({ length: 10 }, (_, i) => 'D' + String(i + 1).padStart(2, '0')), 'devices');
    expect(found.every(({ samples, amplitude }) => samples === '601' && amplitude.startsWith('20')), 'samples, amplitudes');
    expect((await band(page)).startsWith('10'), await band(page));
    equal(await lotText(page), readFileSync(join(example, 'lot.toml'), 'utf8'), 'the lot file');

    // The page must show the same properties as the command line computes.
    execFileSync(isolaw, ['inspect', join(example, 'lot.toml'), '--out', join(work, 'inspected')], { stdio: 'ignore' });
    await page.press('show-properties');
    await page.until("document.getElementById('inspection-frame')", 'the inspection');
    await inFrameUntil(page, PLOTS, 'plots');
    equal(await inFrameUntil(page, "document.body.dataset.errors !== undefined && 'none' + document.body.dataset.errors", 'errors'), 'none', 'errors in the frame');
    expect((await page.inFrame('origin')) === 'null', 'the frame has an origin apart');
    // The report in the frame cannot load itself again in other units, so the page around the frame must do so.
    const units = '.units [aria-pressed=true]';
    for (const [id, words] of [['kip-in', /kip/], ['N-m', /N\/m/], ['kN-mm', /kN\/mm/]]) {
      await page.inFrame(`document.querySelector('.units [value=${id}]').click()`);
      await inFrameUntil(page, `document.querySelector('${units}')?.value === '${id}' && ${words}.test(document.body.textContent) && (${PLOTS})`, 'the report in ' + id);
    }
    await page.press('show-save');
    await page.press('save-inspection-json');
    const own = JSON.parse((await page.saved()).bytes),
      other = JSON.parse(readFileSync(join(work, 'inspected/inspection.json')));
    equal(own.devices.map(({ sha256 }) => sha256), other.devices.map(({ sha256 }) => sha256), 'hashes');
    const cycles = (one) => one.devices.map(({ blocks }) => blocks.map((block) => block.cycles.map(({ K_eff_kN_per_mm: k, damping_percent: d, energy_kN_mm: e }) => [k, d, e])));
    equal(rounded(cycles(own)), rounded(cycles(other)), 'cycles');

    // After the user has chosen a rule set and design values, the page must show a verdict.
    await page.press('show-properties');
    await page.press('choose-rules');
    expect((await page.evaluate('document.activeElement.id')) === 'rules', 'the rule set has the focus');
    await set(page, 'rules', 'ntc-2018');
    for (const [key, value] of [['K_eff', '0.62'], ['damping', '19.5'], ['disp', '208'], ['frequency', '0.5']]) await set(page, 'design-' + key, value);
    await set(page, 'lot-size', '28');
    const text = await lotText(page);
    for (const line of ["rules = 'ntc-2018'", 'design = { K_eff = 0.62, damping = 19.5, disp = 208, frequency = 0.5 }', 'lot-size = 28', '# The example lot']) expect(text.includes(line), 'lot.toml holds ' + line);
    await page.press('show-properties');
    const verdict = await page.text('.verdict-line');
    expect(/^(PASS|FAIL|INCOMPLETE)/.test(verdict), 'verdict: ' + verdict);
    await end(page);
  },

  'files without a lot file: recognised, corrected in a form that is the lot file': async () => {
    const page = await open();
    await page.drop(records.map((one) => join(example, one)));
    equal(await failure(page), '', 'a failure');
    let found = await rows(page);
    equal(found.map((row) => row.name), records.map((one) => one.replace(/\..*/, '')), 'devices');
    expect(found.every(({ tone }) => tone === 'good' || tone === 'care'), 'all are read');
    expect((await page.text('#reading-2')).includes('Spostamento [mm]'), 'columns are said: ' + (await page.text('#reading-2')));

    await openForm(page, 0);
    await set(page, await fieldOf(page, 0, 'name'), 'A <b>1</b>');
    await set(page, await fieldOf(page, 0, 'rubber-thickness-mm'), '208,5');
    await set(page, await fieldOf(page, 0, 'serial'), '1');
    expect((await lotText(page)).includes("name = 'A <b>1</b>'\nunits = { disp = 'mm', force = 'kN', load = 'kN', time = 's' }\nserial = '1'\n"), 'what was typed stands in the lot file');
    expect((await lotText(page)).includes('rubber-thickness-mm = 208.5\n'), 'a decimal comma is a number');
    found = await rows(page);
    equal(found[0].name, 'A <b>1</b>', 'the name');
    expect((await page.evaluate("document.querySelectorAll('#contents b').length && [...document.querySelectorAll('#contents b')].some((one) => one.textContent === '1')")) === false, 'markup stays text');

    // When the user chooses another unit in the form, the amplitude and the lot file must change. When the user edits
    // the lot file, the form must change.
    await set(page, await fieldOf(page, 0, 'units-disp'), 'cm');
    found = await rows(page);
    expect(found[0].amplitude.startsWith('208'), 'in cm: ' + found[0].amplitude);
    await page.evaluate("document.getElementById('lot-file').open = true");
    await set(page, 'lot-text', (await lotText(page)).replace("disp = 'cm'", "disp = 'mm'"));
    found = await rows(page);
    expect(found[0].amplitude.startsWith('208') && Math.abs(parseFloat(found[0].amplitude) - 208.1) < 0.2, 'in mm: ' + found[0].amplitude);
    equal(await page.evaluate(`document.getElementById(${JSON.stringify(await fieldOf(page, 0, 'units-disp'))}).value`), 'mm', 'the form follows the text');

    // The user writes an unknown key into the lot file. The page must report it, and the user can correct it.
    const good = await lotText(page);
    await set(page, 'lot-text', good.replace("serial = '1'", 'colums = 3'));
    expect(/unknown key 'colums'/.test(await page.text('#read-band')), 'an unknown key: ' + (await page.text('#read-band')));
    await set(page, 'lot-text', good + '\n[[device');
    expect((await page.text('#read-band')).includes('lot.toml'), 'no TOML: ' + (await page.text('#read-band')));
    await set(page, 'lot-text', good);
    expect((await band(page)).startsWith('10'), await band(page));

    // The user removes a device from the lot and adds it again.
    await page.evaluate("[...document.querySelectorAll('.form-end button')].at(-1).click()");
    await page.idle();
    equal((await rows(page)).length, 9, 'devices without it');
    await page.press('add-them');
    await page.idle();
    equal((await rows(page)).length, 10, 'devices with it again');
    await end(page);
  },

  'the values of a file as they were read, with its loop': async () => {
    const page = await open();
    await page.drop(records.map((one) => join(example, one)));
    // The page shows values of the first three devices. It shows those of another device if the user presses a button.
    const shown = () => page.evaluate("document.querySelectorAll('.reading-row').length");
    equal(await shown(), 3, 'devices with values');
    await page.press('values-4');
    equal(await shown(), 4, 'the values of one more');
    await page.press('values-1');
    equal(await shown(), 3, 'without those of the first');
    expect(/Time \[s\]/.test(await page.text('#device-1')), 'hidden values leave the names of the columns: ' + (await page.text('#device-1')));
    await page.press('values-1');
    const table = await page.evaluate("[...document.querySelectorAll('#reading-1 tr')].map((row) => [...row.children].map((cell) => cell.innerText))");
    const lines = readFileSync(join(example, records[0]), 'utf8').split('\n').slice(1, 5).map((line) => line.split(',').map(Number));
    equal(table[0].map((head) => head.split('\n')[0]), ['Sample', 'Time s', 'Displacement mm', 'Force kN', 'Vertical load kN'], 'heads');
    const read = table.slice(1, 5).map(([, ...cells]) => cells.map((cell) => Number(cell.replace('\u2212', '-'))));
    expect(read.every((cells, i) => cells.every((cell, j) => Math.abs(cell - lines[i][j]) <= 1e-4 * Math.abs(lines[i][j]))), 'the first rows of the file: ' + JSON.stringify([read, lines]));
    expect(/^\u2212208\.?\d* to 208/.test(table[5][2]), 'the range: ' + table[5]);
    const points = await page.evaluate("document.querySelector('#reading-1 svg .loop').getAttribute('d').split('L').length");
    expect(points > 100, 'points of the loop: ' + points);
    // Another unit changes the values beside the form.
    await openForm(page, 0);
    await set(page, await fieldOf(page, 0, 'units-force'), 'N');
    equal(Number(await page.evaluate("document.querySelector('#reading-1 tbody tr:nth-child(2)').children[3].innerText")), lines[1][2] / 1000, 'the force in N');
    expect(/set.*the file says kN/s.test(await page.text('#reading-1 thead')), 'the other unit is marked: ' + (await page.text('#reading-1 thead')));
    await end(page);
  },

  'a guess is marked, and the field that changes it is one click away': async () => {
    const page = await open();
    await page.drop([join(root, 'tests/warts/clock.csv'), join(root, 'tests/warts/mts-793-axial.dat')]);
    const marks = (row) => page.evaluate(`[...document.querySelectorAll('#reading-${row} .doubted')].map((one) => one.innerText.replace(/\\s+/g, ' '))`);
    equal(await marks(1), [], 'a file that says everything');
    equal(await marks(2), ['guess taken from the axis of the machine Change', 'guess taken from the axis of the machine Change'], 'displacement and force of a machine with one axis');
    await page.click('#reading-2 th:nth-child(4) .doubted button');
    equal(await page.focused(), 'device-2-columns-force', 'the field of the column');
    await page.press('values-2');
    expect((await page.text('#device-2')).includes('2\u202fguesses'), 'guesses are counted beside hidden values: ' + (await page.text('#device-2')));
    // The force of this file has the wrong sign, so isolaw refuses it until the user reverses the sign.
    const [head, ...lines] = readFileSync(join(example, records[0]), 'utf8').trimEnd().split('\n');
    const reversed = lines.map((line) => line.split(',').map((cell, column) => (column === 2 ? -Number(cell) : cell)).join(','));
    writeFileSync(join(work, 'reversed.csv'), [head, ...reversed].join('\n') + '\n');
    await page.drop([join(work, 'reversed.csv')]);
    equal((await rows(page))[2].tone, 'poor', 'the wrong sign');
    await openForm(page, 2);
    await page.press(await fieldOf(page, 2, 'flip-force'));
    await page.idle();
    equal(await marks(3), ['set sign reversed Change'], 'the sign');
    equal(await page.evaluate("[...document.querySelectorAll('button')].filter(({ textContent }) => textContent === 'Correct').length"), 0, 'buttons that read as a verdict');
    await end(page);
  },

  'a lot file that states conditions, with its records': async () => {
    const page = await open();
    await page.drop([conditions]);
    equal(await failure(page), '', 'a failure');
    equal((await rows(page)).map((row) => row.name), ['P1', 'P2', 'P3', 'P4', 'P5', 'P6'], 'devices');
    equal(await band(page), '6\u202fdevices read', 'the band');
    equal(await page.text('#view-records .hint'), '', 'no file is missing or left over');
    equal(await lotText(page), readFileSync(join(conditions, 'lot.toml'), 'utf8'), 'the lot file');

    // The table of the tests shows what the lot file states. An edit changes one value.
    const value = (id) => page.evaluate(`document.getElementById(${JSON.stringify(id)}).value`);
    const row = (file, key) => page.evaluate(`document.getElementById([...document.querySelectorAll('#tests tr.test')].find((one) => one.innerText.includes(${JSON.stringify(file)})).id + '-${key}').value`);
    equal(await page.evaluate("[document.querySelectorAll('#tests tr.test').length, document.getElementById('conditions-on').checked]"), [26, true], 'tests');
    const keys = ['device', 'order', 'temperature-C', 'rest-h', 'aged-days', 'aged-at-C'];
    equal(await Promise.all(keys.map((key) => row('P4-aged.csv', key))), ['P4', '9', '20', '24', '14', '70'], 'the aged test');
    equal(await Promise.all(['reference-temperature-C', 'reference-load-kN', 'design-temperature-C-from', 'design-temperature-C-to', 'design-rest', 'design-aged-days'].map((id) => value('conditions-' + id))), ['20', '2000', '-15', '45', 'full', '14'], 'the form');
    const before = await lotText(page);
    await set(page, 'conditions-design-temperature-C-to', '40');
    equal(await lotText(page), before.replace(/^design = .*temperature-C = \[-15, 45\].*$/m, "design = { temperature-C = [-15, 40], frequency-Hz = [0.35, 0.65], load-kN = [1000, 3000], rest = 'full', cycles = 10, aged = { days = 14, at-C = 70 } }"), 'one value is changed');
    await page.evaluate("document.getElementById('lot-file').open = true");
    await set(page, 'lot-text', before);

    // The sections of the inspection and of the report must show what the command line computes.
    const native = JSON.parse(spawnSync(isolaw, ['conditions', join(conditions, 'lot.toml'), '--json']).stdout);
    const of = ({ bounds, levels, tests: made }) => rounded([bounds, levels, made.map(({ device, test, role, effect, temperature_C: temperature }) => [device, test, role, effect, temperature])]);
    const [upper] = native.bounds.map(({ max }) => max.factor.toFixed(3));
    const shown = async () => expect((await inFrameUntil(page, "document.querySelector('#conditions').innerText", 'the section')).includes(upper), 'the upper bound ' + upper);
    await page.press('show-properties');
    await shown();
    await page.press('show-save');
    await page.press('save-inspection-json');
    equal(of(JSON.parse((await page.saved()).bytes).conditions), of(native), 'the inspection');
    await identifyLittle(page);
    await shown();
    await page.press('show-save');
    await page.press('save-summary-json');
    equal(of(JSON.parse((await page.saved()).bytes).conditions), of(native), 'the report');

    // The user saves everything as one file and drops it again.
    await page.press('save-whole');
    const { path } = await page.saved();
    const again = await open();
    await again.drop([path]);
    await again.until("document.getElementById('report-frame')", 'the report again');
    equal(await again.text('#laws-doubt'), '', 'nothing has changed');
    await end(again);
    await end(page);

    // A record of one test is missing. The page must name it and use the other tests.
    const less = await open();
    await less.drop(readdirSync(conditions).filter((one) => one !== 'P1-0C.csv' && one !== 'README.md').map((one) => join(conditions, one)));
    equal([await band(less), /P1-0C\.csv/.test(await less.text('#view-records .hint'))], ['6\u202fdevices read, 1\u202ftest refused', true], 'the missing record is named');
    await less.press('show-properties');
    expect((await inFrameUntil(less, "document.querySelector('#conditions').innerText", 'the section')).includes('P1-0C.csv'), 'and in the report');
    await end(less);
  },

  'files of tests under several conditions become a lot in a table': async () => {
    // The names of the files propose devices and temperatures. `stated` has what the user enters for each file: device,
    // order, temperature and further keys.
    const folder = join(work, 'laboratory');
    mkdirSync(folder);
    const stated = [
      ['P1--20C', 'P1_T-20C_0.5Hz_2000kN', 'P1', 2, -20],
      ['P1-20C', 'P1_T20C_0.5Hz_2000kN', 'P1', 1, 20],
      ['P1-40C', 'P1_T40C_0.5Hz_2000kN', 'P1', 3, 40],
      ['P2--20C', 'P2_T-20C_0.5Hz_2000kN', 'P2', 2, -20],
      ['P2-20C', 'P2_T20C_0.5Hz_2000kN', 'P2', 1, 20],
      ['P4-reference', 'P4_20C', 'P4', 1, 20],
      ['P4-aged', 'P4_20C_aged', 'P4', 3, 20, ', aged = { days = 14, at-C = 70 }'],
      ['P4-fast', 'fast', 'P4', 2, 20, ', load-kN = 2000'],
    ];
    for (const [from, name] of stated) copyFileSync(join(conditions, from + '.csv'), join(folder, name + '.csv'));
    // One record has no channel for the vertical load, so the table has a column for it.
    writeFileSync(join(folder, 'fast.csv'), readFileSync(join(conditions, 'P4-fast.csv'), 'utf8').replace(/^([^#\n]*),[^,\n]*$/gm, '$1'));
    const page = await open();
    await page.drop([folder]);
    equal((await rows(page)).length, 8, 'every file is a device');
    await page.press('conditions-on');
    await page.idle();
    equal(await failure(page), '', 'a failure');
    const shown = () => page.evaluate("Object.fromEntries([...document.querySelectorAll('#tests tr.test')].map((row) => [row.querySelector('th').firstChild.textContent, { id: row.id, device: row.querySelector('[id$=-device]').value, temperature: row.querySelector('[id$=-temperature-C]').value, proposed: row.querySelector('[id$=-temperature-C]').placeholder, measured: row.querySelector('small')?.textContent }]))");
    const proposed = await shown();
    for (const [, name, device, , temperature] of stated) {
      const { device: found, temperature: taken, proposed: words } = proposed[name + '.csv'];
      equal([found, taken, parseFloat(words)], name === 'fast' ? ['fast', '', null] : [device, '', temperature], name);
    }
    expect(/8.tests lack/.test(await page.text('#read-band')), 'what is missing: ' + (await page.text('#read-band')));
    expect(/was aged/.test(await page.text('#view-records')), 'the name says aged');

    // The user takes the proposed values, states the rest and moves a test to its device.
    await page.press('take-proposed');
    await page.idle();
    equal(await page.evaluate("document.getElementById('take-proposed')"), null, 'all are taken');
    const id = (name) => proposed[name + '.csv'].id;
    await set(page, id('fast') + '-device', 'P4');
    await set(page, id('fast') + '-temperature-C', '20');
    await set(page, id('fast') + '-load-kN', '2000');
    for (const [, name, , order] of stated) await set(page, id(name) + '-order', String(order));
    await set(page, id('P4_20C_aged') + '-aged-days', '14');
    await set(page, id('P4_20C_aged') + '-aged-at-C', '70');
    for (const [key, value] of [['reference-temperature-C', '20'], ['reference-frequency-Hz', '0,5'], ['reference-load-kN', '2000'], ['design-temperature-C-from', '-15'], ['design-temperature-C-to', '30'], ['design-aged-days', '14'], ['design-aged-at-C', '70'], ['rules', 'ntc-2018']]) await set(page, 'conditions-' + key, value);
    equal([await band(page), await failure(page)], ['3\u202fdevices read', ''], 'the band');
    equal((await shown())['fast.csv'].measured, '2 Hz, 2000 kN, rate', 'what was measured');

    // The command line must find the same results for a lot file written by hand with the same statements.
    const lot = ['P1', 'P2', 'P4'].map((device) => `[[device]]\nname = '${device}'\ntest = [${stated.filter((one) => one[2] === device).map(([, name, , order, temperature, more = '']) => `{ file = '${name}.csv', order = ${order}, temperature-C = ${temperature}${more} }`).join(', ')}]\n`);
    writeFileSync(join(folder, 'own.toml'), "title = 'own'\n[conditions]\nrules = 'ntc-2018'\nreference = { temperature-C = 20, frequency-Hz = 0.5, load-kN = 2000 }\ndesign = { temperature-C = [-15, 30], aged = { days = 14, at-C = 70 } }\n" + lot.join(''));
    const native = JSON.parse(spawnSync(isolaw, ['conditions', join(folder, 'own.toml'), '--json']).stdout);
    await page.press('show-save');
    await page.press('save-inspection-json');
    const found = JSON.parse((await page.saved()).bytes).conditions;
    const of = ({ bounds, levels, tests: made }) => rounded([bounds, levels, made.map(({ device, test, role, effect }) => [device, test, role, effect])]);
    equal(of(found), of(native), 'the same effects');
    expect(found.bounds.length > 0 && found.tests.some(({ effect }) => effect === 'ageing'), 'effects are found');

    // The user moves by keyboard from one field to the next. Neither the typed value nor the focus may be lost.
    await page.press('show-records');
    await page.evaluate(`document.getElementById('${id('P1_T40C_0.5Hz_2000kN')}-order').focus()`);
    await page.key('Tab');
    equal(await page.focused(), id('P1_T40C_0.5Hz_2000kN') + '-temperature-C', 'the next field');
    await page.key('a', { control: true });
    await page.write('41');
    await page.key('Tab');
    await page.idle();
    equal([await page.focused(), (await shown())['P1_T40C_0.5Hz_2000kN.csv'].temperature], [id('P1_T40C_0.5Hz_2000kN') + '-rest-h', '41'], 'after an edit');

    // The user states further keys and leaves out a test. The page leaves it to isolaw to judge the values.
    await page.press(id('fast') + '-more');
    await set(page, id('fast') + '-temperature-of', 'core');
    expect((await lotText(page)).includes("temperature-of = 'core'"), 'a further key');
    await set(page, id('fast') + '-temperature-C', '900');
    expect(/-100 to 200/.test(await page.text('#view-records')), 'a value that is not allowed: ' + (await page.text('#read-band')));
    await page.press(id('fast') + '-leave-out');
    await page.idle();
    equal([await band(page), Object.keys(await shown()).length], ['3\u202fdevices read', 7], 'without this test');

    // More files join the table. If the user switches the table off, every test must become a device of its own.
    copyFileSync(join(conditions, 'P2-40C.csv'), join(folder, 'P2_T40C.csv'));
    await page.drop([join(folder, 'P2_T40C.csv')], [300, 20]);
    const more = (await shown())['P2_T40C.csv'];
    equal([more.device, parseFloat(more.proposed)], ['P2', 40], 'one more test');
    await page.evaluate('window.confirm = () => false');
    await page.press('conditions-on');
    equal(await page.evaluate("document.getElementById('conditions-on').checked"), true, 'the user goes back');
    await page.evaluate('window.confirm = () => true');
    await page.press('conditions-on');
    await page.idle();
    equal([await band(page), /conditions|order|aged =/.test(await lotText(page)), (await rows(page)).length], ['8\u202fdevices read', false, 8], 'without conditions');
    await end(page);
  },

  'a file without time': async () => {
    const [head, ...lines] = readFileSync(join(example, records[0]), 'utf8').trimEnd().split('\n');
    const untimed = [head, ...lines].map((line) => line.split(',').slice(1).join(',')).join('\n') + '\n';
    writeFileSync(join(work, 'untimed.csv'), untimed);
    const page = await open();
    await page.drop([join(work, 'untimed.csv'), join(example, records[0])]);
    const warned = await page.evaluate("[...document.querySelectorAll('.reading')].map((one) => one.querySelector('.no-time')?.innerText ?? '')");
    const [at, beside] = warned[0] ? [0, 1] : [1, 0];
    expect(/no time/.test(warned[at]) && /Frequency and velocity/.test(warned[at]) && /Jankowski/.test(warned[at]) && !/Bilinear/.test(warned[at]), 'the warning: ' + warned[at]);
    equal(warned[beside], '', 'a file with time');
    await page.click('.no-time button');
    const field = `device-${at + 1}-dt`;
    equal(await page.focused(), field, 'the field of the time step');
    await set(page, field, '0,02');
    equal(await page.evaluate(`[...document.querySelectorAll('#reading-${at + 1} tbody tr')].slice(0, 4).map((row) => row.children[1].innerText)`), ['0.00', '0.02', '0.04', '0.06'], 'times from the time step');
    expect(/set.*time step/s.test(await page.text(`#reading-${at + 1} thead`)), 'it is marked: ' + (await page.text(`#reading-${at + 1} thead`)));
    expect(/0\.02\u202fs apart/.test(await page.text('.no-time')), 'it is said: ' + (await page.text('.no-time')));
    await end(page);
  },

  'files and a folder that are chosen': async () => {
    const page = await open();
    const choose = async (id, paths) => {
      const { root: document } = await page.send('DOM.getDocument', {});
      const { nodeId } = await page.send('DOM.querySelector', { nodeId: document.nodeId, selector: '#' + id });
      await page.send('DOM.setFileInputFiles', { nodeId, files: paths });
      await wait(50);
      await page.idle();
    };
    await choose('pick', [join(example, records[0]), join(example, records[1])]);
    equal((await rows(page)).length, 2, 'devices of files');
    // The user chooses one more file. What the user typed for the first device must stay.
    await openForm(page, 0);
    await set(page, await fieldOf(page, 0, 'serial'), 'kept');
    await choose('pick', [join(example, records[2])]);
    equal((await rows(page)).length, 3, 'devices of more files');
    expect((await lotText(page)).includes("serial = 'kept'"), 'what was typed is kept');
    await page.evaluate('window.confirm = () => true');
    await page.press('start-over');
    await choose('pick-folder', [example]);
    equal((await rows(page)).map((row) => row.name)[9], 'D10', 'devices of a folder');
    await end(page);
  },

  'a folder with one damaged file': async () => {
    const folder = join(work, 'damaged');
    mkdirSync(join(folder, 'deeper'), { recursive: true });
    for (const one of records.slice(0, 3)) copyFileSync(join(example, one), join(folder, one));
    copyFileSync(join(example, records[3]), join(folder, 'deeper', records[3]));
    writeFileSync(join(folder, 'broken.csv'), 'Time [s],Displacement [mm],Force [kN]\n0,0,0\n0.01,abc,3\n');
    writeFileSync(join(folder, 'photo.jpg'), 'none');
    const page = await open();
    await page.drop([folder]);
    equal((await rows(page)).map((row) => row.name), ['device-04', 'device-01', 'device-02', 'device-03', 'broken'], 'devices');
    const broken = (await rows(page))[4];
    expect(broken.tone === 'poor' && /broken\.csv/.test(broken.words) && /'abc'/.test(broken.words), 'what is wrong is said: ' + broken.words);
    equal(await band(page), '4\u202fdevices read, 1 not', 'the band');
    expect((await page.text('.notes')).includes('photo.jpg'), 'what was left alone: ' + (await page.text('.notes')));
    expect((await lotText(page)).includes("title = 'damaged'") && (await lotText(page)).includes("file = 'deeper/device-04.txt'"), 'the lot file');
    // A file that could not be read must appear in all results until the user removes it.
    await page.press('show-save');
    await page.press('save-inspection-json');
    const inspection = JSON.parse((await page.saved()).bytes);
    equal(inspection.devices.filter(({ status }) => status === 'refused').map(({ name: one }) => one), ['broken'], 'refused');
    expect(inspection.warnings.some(({ sentence }) => sentence.startsWith('broken was refused')), 'the warning');
    // The unreadable file must not stop the identification of the other devices.
    await identifyLittle(page);
    await inFrameUntil(page, PLOTS, 'plots');
    expect(/broken was refused/.test(await page.inFrame('document.body.textContent')), 'the report says it');
    await page.press('show-save');
    await page.press('save-whole');
    const { path } = await page.saved();
    const again = await open();
    await again.drop([path]);
    await again.press('show-records');
    equal(await band(again), '4\u202fdevices read, 1 not', 'the band, dropped again');
    equal(await again.text('#laws-doubt'), '', 'nothing was changed');
    await again.press('leave-out');
    await again.idle();
    equal((await rows(again)).length, 4, 'left out');
    equal(await band(again), '4\u202fdevices read', 'the band without it');
    await end(again);
    await end(page);
  },

  'a workbook, a MATLAB file, and files that need to be told': async () => {
    const warts = join(root, 'tests/warts');
    // The page must show the three parts of a complaint separately: the fault, the allowed values and the advice.
    const alone = await open();
    await alone.drop([join(warts, 'no-units.csv')]);
    const problems = await alone.evaluate("[...document.querySelectorAll('#devices .problem')].map((one) => [one.textContent, [...one.querySelectorAll('b')].map((b) => b.textContent.trim())])");
    expect(problems.length > 0 && problems.every(([said, [allowed, advice]]) => allowed === 'Allowed' && advice === 'Try' && !/; (allowed|try): |isolaw: /.test(said)), 'complaints in parts: ' + JSON.stringify(problems));
    await end(alone);
    const page = await open();
    const matlab = join(root, '../shared/data/mr-damper/ensaio.A.1.mat');
    const paths = [join(warts, 'date-cells.xlsx'), join(warts, 'no-units.csv'), join(warts, 'iso.json')];
    if (existsSync(matlab)) paths.push(matlab);
    else console.log('  skipped: the MATLAB file (no ' + matlab + ')');
    await page.drop(paths);
    equal((await rows(page)).map((row) => row.name), [...(existsSync(matlab) ? ['date-cells', 'iso', 'ensaio.A.1'] : ['date-cells', 'iso']), 'no-units'], 'devices');
    const row = async (called) => (await rows(page)).findIndex((one) => one.name === called);
    const untold = await row('no-units');
    equal((await rows(page))[untold].tone, 'poor', 'not read');

    await openForm(page, untold);
    for (const [key, unit] of [['units-time', 's'], ['units-disp', 'mm'], ['units-force', 'kN']]) await set(page, await fieldOf(page, untold, key), unit);
    let found = await rows(page);
    expect(found[untold].tone !== 'poor' && Number(found[untold].samples) > 100, 'no-units.csv is read: ' + JSON.stringify(found[untold]));
    if (existsSync(matlab)) {
      const mat = await row('ensaio.A.1');
      await openForm(page, mat);
      expect((await page.evaluate("[...document.querySelectorAll('datalist')].some((list) => [...list.options].some(({ value }) => value === 'forc'))")) === true, 'its variables are offered');
      for (const [key, value] of [['columns-time', 'Tout'], ['columns-disp', 'dist'], ['columns-force', 'forc'], ['units-time', 's'], ['units-disp', 'mm'], ['units-force', 'N']]) await set(page, await fieldOf(page, mat, key), value);
      found = await rows(page);
      expect(found[mat].samples === '1501', 'the MATLAB file is read: ' + JSON.stringify(found[mat]));
    }
    expect((await rows(page)).every(({ tone }) => tone !== 'poor'), 'none is unread');
    await end(page);
  },

  'the measured bearing': async () => {
    const bearing = join(root, '../shared/data/hdrb-gallardo-device/cyclic-24-49-98pct.csv');
    if (!existsSync(bearing)) {
      console.log('  skipped: no ' + bearing);
      return;
    }
    const page = await open();
    await page.drop([bearing]);
    let [row] = await rows(page);
    equal(row.samples, '19767', 'samples');
    await openForm(page, 0);
    await set(page, await fieldOf(page, 0, 'dt'), '0.0085');
    await set(page, await fieldOf(page, 0, 'rubber-thickness-mm'), '155');
    [row] = await rows(page);
    expect(row.tone === 'good' || row.tone === 'care', 'read: ' + JSON.stringify(row));
    await identifyLittle(page, ['bilinear', 'bouc-wen']);
    await page.press('show-save');
    await page.press('save-summary-json');
    const summary = JSON.parse((await page.saved()).bytes);
    equal(summary.laws.map(({ id }) => id).sort(), ['bilinear', 'bouc-wen'], 'laws');
    expect(summary.laws.every(({ objective }) => objective.mean > 0 && objective.mean < 0.5), 'objectives');
    await end(page);
  },

  // Identifies laws on a measured record with the default settings. The test prints how long this takes but does not
  // judge it.
  'the paper\u2019s laws on the measured bearing\u2019s third stage': async () => {
    const record = join(root, '../shared/data/hdrb-gallardo-device/cyclic-24-49-98pct.csv');
    if (!existsSync(record)) {
      console.log('  skipped: no ' + record);
      return;
    }
    const folder = join(work, 'bearing');
    execFileSync(join(root, 'bench/measured_lots'), [folder], { stdio: 'ignore' });
    rmSync(join(folder, 'all-stages.csv'));
    const lot = readFileSync(join(folder, 'measured-bearing.toml'), 'utf8');
    writeFileSync(join(folder, 'lot.toml'), lot.replace('laws = "all"', 'laws = "paper"').replace(/\n\[\[device\]\]\nname = "all stages"\n.*\n/, ''));
    rmSync(join(folder, 'measured-bearing.toml'));
    const page = await open();
    await page.drop([folder]);
    equal((await rows(page)).map(({ name: one, samples }) => one + ' ' + samples), ['third stage 6537'], 'devices');
    const took = await identified(page, 1800);
    const began = performance.now();
    execFileSync(isolaw, ['calibrate', join(folder, 'lot.toml'), '--out', join(work, 'bearing-native'), '--figures', 'none'], { stdio: 'ignore' });
    const natively = (performance.now() - began) / 1000;
    console.log(`  ${took.toFixed(1)} s, natively ${natively.toFixed(1)} s: ${(took / natively).toFixed(1)} times as long`);
    await inFrameUntil(page, PLOTS, 'plots');
    await page.press('show-save');
    await page.press('save-summary-json');
    const best = ({ laws }) => Object.fromEntries(laws.map(({ id, objective }) => [id, objective.best]));
    const found = best(JSON.parse((await page.saved()).bytes)),
      wanted = best(JSON.parse(readFileSync(join(work, 'bearing-native/summary.json'))));
    equal(Object.keys(found).length, 7, 'laws');
    // The page's objectives may differ from the native ones as much as native searches with different instruction sets
    // may differ from one another (docs/performance.md). The objective of abe is rough near its minimum, so its limit
    // is wider.
    for (const [law, objective] of Object.entries(wanted)) expect(Math.abs(found[law] / objective - 1) < (law === 'abe' ? 1e-3 : 1e-5), `objective of ${law}: ${found[law]}, natively ${objective}`);
    await end(page);
  },

  // A manufacturer may drop the devices of a whole year at once, and the page must hold them all. The test limits the
  // computing for each device to save time.
  'two hundred devices': async () => {
    const folder = join(work, 'many');
    mkdirSync(folder);
    const count = 200;
    const [head, ...lines] = readFileSync(join(example, 'device-01.csv'), 'utf8').trimEnd().split('\n');
    const force = head.split(',').findIndex((one) => /force/i.test(one));
    for (let i = 0; i < count; ++i) {
      const scaled = lines.map((line) => line.split(',').map((cell, column) => (column === force ? String(Number(cell) * (0.9 + 0.001 * i)) : cell)).join(','));
      writeFileSync(join(folder, `d-${String(i + 1).padStart(3, '0')}.csv`), [head, ...scaled].join('\n') + '\n');
    }
    const page = await open();
    const mostMemory = watchMemory(browser.process.pid);
    const began = performance.now();
    await page.drop([folder]);
    console.log(`  dropped and inspected in ${((performance.now() - began) / 1000).toFixed(1)} s`);
    equal((await rows(page)).length, count, 'devices');
    equal(await page.evaluate("document.querySelectorAll('.reading-row').length"), 3, 'devices with values');
    await page.press('show-laws');
    await page.press('laws-paper');
    await page.idle();
    for (const [key, value] of [['method', 'ga'], ['runs', '1'], ['analysis', 'none']]) await set(page, key, value);
    const text = await lotText(page);
    await set(page, 'lot-text', text.replace('[calibrate]\n', '[calibrate]\ngenerations = 2\n'));
    expect((await lotText(page)).includes('generations = 2\n'), 'two generations: ' + text.slice(0, 400));
    const took = await identified(page, 1800);
    console.log(`  identified in ${took.toFixed(1)} s; ${Math.round(mostMemory() / 2 ** 20)} MiB at most, of all processes of the browser`);
    await inFrameUntil(page, PLOTS, 'plots');
    await page.press('show-save');
    await page.press('save-summary-json');
    const { devices, laws } = JSON.parse((await page.saved()).bytes);
    equal([devices.length, laws.length], [count, 7], 'devices and laws');
    expect(laws.every((law) => law.devices.every(({ objective }) => objective.best > 0)), 'an objective of each');
    await page.press('save-whole');
    const whole = await page.saved(120);
    const kept = join(work, whole.name);
    copyFileSync(whole.path, kept);
    await end(page);
    const again = await open();
    await again.drop([kept]);
    await again.until("document.getElementById('report-frame')", 'the report again', 120);
    await again.press('show-records');
    equal((await rows(again)).length, count, 'devices again');
    await end(again);
  },

  'identify, export, save, drop back, continue': async () => {
    let page = await open();
    await page.drop([example]);
    // Notes every state of the table of laws while their parameters are searched.
    await page.evaluate(`window.seen = []; new MutationObserver(() => {
      const rows = [...document.querySelectorAll('#fits tr')];
      if (rows.length > 0) window.seen.push({ top: document.getElementById('fits').getBoundingClientRect().top, rows: rows.map((row) => [...row.children].map((cell) => cell.innerText)) });
    }).observe(document.getElementById('view-laws'), { childList: true, subtree: true, characterData: true }); 0`);
    await identifyLittle(page, ['bilinear', 'bouc-wen']);
    const seen = await page.evaluate('window.seen');
    expect(seen.every(({ top, rows: laws }) => laws.length === 2 && Math.abs(top - seen[0].top) < 1), 'every law has its row all the time, and the table stays in place');
    equal(seen[0].rows, [['Bilinear', '\u2013', '0 of 10'], ['Bouc-Wen', '\u2013', '0 of 10']], 'before the first run');
    const reached = seen.at(-1).rows;
    expect(reached.every(([, error]) => /^\d+\.\d\u202f%$/.test(error)) && parseFloat(reached[0][1]) <= parseFloat(reached[1][1]), 'the errors, the smallest first: ' + JSON.stringify(reached));
    await inFrameUntil(page, PLOTS, 'plots');
    equal(await inFrameUntil(page, "'none' + document.body.dataset.errors", 'errors'), 'none', 'errors in the frame');
    await page.press('to-save');

    // The user saves the report, the lot file, the tables and the summary as single files.
    await page.press('save-report-html');
    const report = await page.saved();
    expect(report.name.endsWith('-report.html') && report.bytes.includes('isolaw-data'), 'the report: ' + report.name);
    await page.press('save-lot-toml');
    const lot = await page.saved();
    equal(lot.name, 'lot.toml', 'the lot file');
    await page.press('save-tables-zip');
    const tables = await readZip((await page.saved()).bytes);
    expect(['tables/objective.csv', 'tables/parameters.csv', 'inspection/tables/cycles.csv'].every((one) => tables.some(({ path }) => path === one)), 'tables: ' + tables.map(({ path }) => path));
    await page.press('save-summary-json');
    const summary = JSON.parse((await page.saved()).bytes);

    // The command line must compute the same objectives from the lot file that the page saved.
    writeFileSync(join(example, 'page.toml'), lot.bytes);
    execFileSync(isolaw, ['calibrate', join(example, 'page.toml'), '--out', join(work, 'native'), '--figures', 'none'], { stdio: 'ignore' });
    rmSync(join(example, 'page.toml'));
    const native = JSON.parse(readFileSync(join(work, 'native/summary.json')));
    const objectives = ({ laws }) => Object.fromEntries(laws.map(({ id, objective }) => [id, objective.best]));
    if (!standIn) for (const { name: called, devices: fits } of summary.laws) {
      const error = (100 * fits.reduce((sum, { objective }) => sum + objective.best, 0) / fits.length).toFixed(1) + '\u202f%';
      expect(reached.some((row) => row[0] === called && row[1] === error), `the error of ${called}, ${error} in the report: ${JSON.stringify(reached)}`);
    }
    for (const [law, objective] of Object.entries(objectives(native))) expect(Math.abs(objectives(summary)[law] / objective - 1) < 1e-3, `objective of ${law}: ${objectives(summary)[law]}, natively ${objective}`);

    // The user exports a law. The page must save the file and say so.
    await page.press('show-save');
    await page.type('export-law', 'bouc-wen');
    await page.type('export-to', 'opensees');
    await page.type('export-device', 'D03');
    await page.press('make-export');
    const exported = await page.saved();
    expect(/uniaxialMaterial/.test(exported.bytes.toString()) && exported.name === 'bouc-wen-D03.tcl', 'export: ' + exported.name);
    await page.idle();
    expect((await page.text('#export-said')).includes('bouc-wen-D03.tcl'), 'it is said');

    // The user saves the whole campaign as one file. Both the command line and the page must be able to read this file.
    await page.press('save-whole');
    const whole = await page.saved();
    expect(whole.name.endsWith('.isolaw.zip'), whole.name);
    const unpacked = join(work, 'unpacked');
    for (const { path, bytes } of await readZip(whole.bytes)) {
      mkdirSync(dirname(join(unpacked, path)), { recursive: true });
      writeFileSync(join(unpacked, path), bytes);
    }
    for (const one of records) expect(readFileSync(join(unpacked, one)).equals(readFileSync(join(example, one))), one + ' as it was');
    const reported = spawnSync(isolaw, ['report', join(unpacked, 'out'), '--figures', 'none', '--out', join(work, 'reported')]);
    equal(reported.status, 0, 'isolaw report: ' + reported.stderr);
    const again = JSON.parse(readFileSync(join(work, 'reported/summary.json')));
    equal(objectives(again), objectives(summary), 'the same summary');
    const whole2 = join(work, whole.name);
    copyFileSync(whole.path, whole2);
    await end(page);

    page = await open();
    await page.drop([whole2]);
    equal(await failure(page), '', 'a failure');
    await page.until("document.getElementById('report-frame')", 'the report again');
    await inFrameUntil(page, PLOTS, 'plots again');
    await page.press('show-records');
    equal((await rows(page)).length, 10, 'its devices');
    // The user identifies one more law. The results of the first two laws must stay exactly the same.
    await identifyLittle(page, ['bilinear', 'bouc-wen', 'hwang-wu']);
    await page.press('show-save');
    await page.press('save-summary-json');
    const more = objectives(JSON.parse((await page.saved()).bytes));
    equal(Object.keys(more).sort(), ['bilinear', 'bouc-wen', 'hwang-wu'], 'laws');
    for (const [law, objective] of Object.entries(objectives(summary))) equal(more[law], objective, 'kept: ' + law);
    await end(page);

    // The user drops only the database of the campaign. The page must show the campaign's report and be able to save
    // it.
    page = await open();
    await page.drop([join(unpacked, 'out/campaign.sqlite')]);
    await page.until("document.getElementById('report-frame')", 'the report of a store');
    equal(await page.evaluate("[document.getElementById('identify'), document.getElementById('show-properties').disabled]"), [null, true], 'nothing to identify');
    await page.press('show-save');
    await page.press('save-report-html');
    await page.saved();
    await end(page);
  },

  // The cancelling is timed three times, and the shortest time is judged, because other work on the machine can only
  // slow the page.
  'cancel within 1 s, and go on': async () => {
    const page = await open();
    await page.drop([example]);
    await page.press('show-laws');
    await page.press('laws-all');
    await page.idle();
    await set(page, 'method', 'best');
    await set(page, 'runs', '20');
    const times = [];
    for (let i = 0; i < 3; ++i) {
      await page.press('identify');
      await page.until("document.getElementById('progress-bar')", 'progress');
      await wait(1500);
      // Measures the longest time in which the page did not react while the engine computed. The test prints this time
      // but does not judge it.
      const longest = await page.evaluate('new Promise((done) => { let last = performance.now(), most = 0, n = 0; const tick = () => { const now = performance.now(); most = Math.max(most, now - last); last = now; ++n < 100 ? setTimeout(tick, 10) : done(most); }; tick(); })');
      const took = await page.evaluate("new Promise((done) => { const start = performance.now(); document.getElementById('cancel').click(); const look = () => (document.getElementById('progress-bar') ? setTimeout(look, 5) : done(performance.now() - start)); look(); })");
      times.push(took);
      console.log(`  cancelled in ${Math.round(took)} ms; the page was away for ${Math.round(longest)} ms at most`);
      expect((await page.text('#laws-said')).length > 0, 'it is said');
      expect((await page.evaluate("document.getElementById('identify').disabled")) === false, 'it can be started again');
    }
    expect(Math.min(...times) < 1000, 'cancelled in ' + Math.min(...times) + ' ms at best');
    // After the cancelled searches a new identification must work.
    await identifyLittle(page);
    await end(page);
  },

  'hostile names and contents stay text': async () => {
    const folder = join(work, 'hostile <img src=x onerror=hacked=1>');
    mkdirSync(folder);
    const bad = '<img src=x onerror="window.hacked=1"><script>window.hacked=1<\u2044script>';
    const lines = readFileSync(join(example, records[0]), 'utf8').split('\n');
    writeFileSync(join(folder, bad.slice(0, 60) + '.csv'), lines.join('\n'));
    writeFileSync(join(folder, "';alert(1);'.csv"), [lines[0].replace('Vertical load', 'Vertical load <svg onload=window.hacked=1>'), ...lines.slice(1)].join('\n'));
    writeFileSync(join(folder, '--out=x.csv'), lines.join('\n'));
    writeFileSync(join(folder, '{{script}}$&.csv'), lines.join('\n'));
    // Browsers skip files with such names in a dropped folder, so the test drops them as single files.
    const single = [' lead.csv', 'turned\u202e.csv'].map((one) => join(work, one));
    for (const one of single) writeFileSync(one, lines.join('\n'));
    writeFileSync(join(folder, 'none.csv'), bad + ',' + bad + '\n1,2\n3,</script><script>hacked=1</script>\n');
    const page = await open();
    await page.drop([folder]);
    await page.drop(single);
    const found = await rows(page);
    expect(found.filter(({ tone }) => tone !== 'poor').length >= 5, 'devices: ' + found.length + ' ' + (await page.text('#contents')));
    await openForm(page, 0);
    await set(page, 'lot-title', bad);
    await page.evaluate("for (const details of document.querySelectorAll('details')) details.open = true");
    const markup = "document.querySelectorAll('main img, main svg:not(.sign, .sketch > svg), main script, [onerror], [onload]').length";
    equal(await page.evaluate(markup), 0, 'elements that are not the page\u2019s');
    await page.press('show-properties');
    await inFrameUntil(page, PLOTS, 'plots');
    expect((await page.inFrame("window.hacked === undefined && document.querySelectorAll('[onerror], [onload]').length === 0")) === true, 'in the frame');
    await identifyLittle(page);
    await inFrameUntil(page, PLOTS, 'plots of the report');
    expect((await page.inFrame("window.hacked === undefined && document.querySelectorAll('[onerror], [onload]').length === 0")) === true, 'in the report');
    await page.press('show-save');
    equal(await page.evaluate(markup), 0, 'elements that are not the page\u2019s, of Save');
    await page.press('save-whole');
    expect(/^[\p{L}\p{N}._-]+$/u.test((await page.saved()).name), 'the name of what is saved');
    expect((await page.evaluate('window.hacked === undefined')) === true, 'nothing ran');
    await end(page);
  },

  // Drops the inputs of the fuzz targets, many of which are damaged or hostile. They may end a worker of the engine,
  // but the page must go on working.
  'damaged and hostile files': async () => {
    const corpus = join(root, 'fuzz/corpus');
    const folder = join(work, 'corpus');
    mkdirSync(folder);
    const ends = { json: 'json', mat: 'mat', mat73: 'mat', text: 'csv', workbook: 'xlsx' };
    let count = 0;
    for (const [kind, ending] of Object.entries(ends))
      for (const one of readdirSync(join(corpus, kind))) {
        copyFileSync(join(corpus, kind, one), join(folder, `${kind}-${one.replace(/\..*/, '')}.${ending}`));
        ++count;
      }
    const page = await open();
    await page.drop([folder]);
    const all = await rows(page),
      unread = all.filter(({ tone }) => tone === 'poor').length;
    expect(all.length - unread > 5 && unread > 20 && all.length >= count, `${all.length - unread} read, ${unread} not, of ${count}`);
    expect((await page.evaluate("[...document.querySelectorAll('#devices tr[data-tone=poor]')].every((one) => one.querySelector('.problem')?.textContent.length > 10)")) === true, 'each with its reason');
    for (const [kind, called] of [['lot_file', 'lot.toml'], ['store', 'campaign.sqlite']])
      for (const one of readdirSync(join(corpus, kind))) {
        mkdirSync(join(work, 'single'), { recursive: true });
        copyFileSync(join(corpus, kind, one), join(work, 'single', called));
        await page.drop([join(work, 'single', called)]);
        expect((await page.text('#read-band')).length > 0 || (await failure(page)).length > 20, one + ' is answered');
      }
    // After all these files the page must still read sound records.
    await page.evaluate('window.confirm = () => true');
    await page.press('show-records');
    await page.press('start-over');
    await page.drop([example]);
    equal((await rows(page)).length, 10, 'devices');
    await end(page);
  },

  'the policy: no script but the page\u2019s, no connection, no eval': async () => {
    const page = await open();
    const blocked = await page.evaluate(`new Promise((done) => {
      const blocked = [];
      document.addEventListener('securitypolicyviolation', (event) => blocked.push(event.effectiveDirective));
      const script = document.createElement('script');
      script.textContent = 'window.ran = 1';
      document.body.append(script);
      const image = document.createElement('img');
      image.src = 'https://example.invalid/x';
      document.body.append(image);
      fetch('https://example.invalid/').catch(() => {});
      setTimeout('window.ran = 2');
      setTimeout(() => done(blocked), 500);
    })`);
    for (const directive of ['script-src-elem', 'img-src', 'connect-src', 'script-src']) expect(blocked.includes(directive), directive + ' is blocked: ' + blocked);
    expect((await page.evaluate('window.ran === undefined')) === true, 'nothing ran');
    await page.close();
  },

  'what cannot be taken is said, and the page stays': async () => {
    const page = await open();
    writeFileSync(join(work, 'broken.zip'), Buffer.concat([Buffer.from('PK\u0003\u0004'), Buffer.alloc(100, 7)]));
    await page.drop([join(work, 'broken.zip')]);
    expect((await failure(page)).includes('broken.zip'), 'a broken zip file: ' + (await failure(page)));
    writeFileSync(join(work, 'campaign.sqlite'), 'SQLite format 3\0' + 'x'.repeat(5000));
    await page.drop([join(work, 'campaign.sqlite')]);
    expect((await failure(page)).length > 20, 'a broken store: ' + (await failure(page)));
    await page.press('close-failure');
    equal(await failure(page), '', 'the message goes');
    writeFileSync(join(work, 'alone.csv'), 'no record at all\n');
    await page.drop([join(work, 'alone.csv')]);
    equal((await rows(page)).map(({ name: one, tone }) => one + ' ' + tone), ['alone poor'], 'no record');
    // This file has a size of 900 MB but no contents. The page must refuse it by its size, before it reads it.
    writeFileSync(join(work, 'big.csv'), '');
    truncateSync(join(work, 'big.csv'), 900e6);
    await page.drop([join(work, 'big.csv')]);
    expect(/900\sMB/.test(await failure(page)), 'too much: ' + (await failure(page)));
    // After it has refused files, the page must still read the next one.
    await page.drop([join(example, records[0])]);
    equal((await rows(page)).map(({ tone }) => tone).sort(), ['good', 'poor'], 'a device beside it');
    // The dropped folder holds nothing but a photo. The page must say that it left the photo out.
    mkdirSync(join(work, 'photos'));
    writeFileSync(join(work, 'photos/one.jpg'), 'none');
    const empty = await open();
    await empty.drop([join(work, 'photos')]);
    expect((await empty.text('.notes')).includes('one.jpg'), 'what was left alone: ' + (await empty.text('#contents')));
    await end(empty);
    await end(page);
  },

  // Types with real key events and clicks with a real pointer. Every edit makes the page draw its view again. This must
  // not move the field or button that the user is about to use.
  'one edit after the other, without waiting': async () => {
    const page = await open();
    await page.drop([join(example, records[0])]);
    await page.click('#lot-title');
    await page.key('a', { control: true });
    await page.write('Bridge 7');
    await page.key('Tab');
    equal(await page.focused(), 'all-rubber-thickness-mm', 'Tab after an edit goes to the next field');
    await page.write('150');
    await page.key('Enter');
    equal(await page.focused(), 'all-rubber-thickness-mm', 'Enter stays in the field');
    await page.key('Tab');
    await page.write('250000');
    await page.click('#lot-size');
    await page.write('28');
    // The size that the user has typed adds a table to the lot file, above the devices. This moves the button that the
    // test clicks next.
    await page.click('[id^=reread-]');
    await page.click('[id^=reread-]');
    equal(await page.evaluate("document.querySelectorAll('.form-row').length"), 0, 'opened and closed');
    await page.click('#design-K_eff');
    await page.write('0,62');
    await page.key('Tab');
    await page.write('19,5');
    await page.click('[id^=reread-]');
    await page.idle();
    const lot = await lotText(page);
    for (const line of ["title = 'Bridge 7'", 'rubber-thickness-mm = 150', 'rubber-area-mm2 = 250000', 'lot-size = 28', 'K_eff = 0.62', 'damping = 19.5']) expect(lot.includes(line), line + ' in ' + lot);
    equal(await page.text('#title'), 'Bridge 7', 'the title');
    equal(await page.evaluate("document.querySelectorAll('.form-row').length"), 1, 'the click after an edit opens the form');
    // A part of the form that the user has unfolded must stay unfolded after an edit. One click must close the form.
    await page.evaluate("[...document.querySelectorAll('.form-row details')].at(-1).open = true");
    const factor = await fieldOf(page, 0, 'force-factor');
    await page.click('#' + factor);
    await page.write('0.5');
    await page.click('#' + factor.replace('force-factor', 'skew-ms'));
    await page.write('1');
    equal(await page.evaluate("[...document.querySelectorAll('.form-row details')].at(-1).open"), true, 'still open');
    await page.click('.form-end .action');
    await page.idle();
    equal(await page.evaluate("document.querySelectorAll('.form-row').length"), 0, 'one click ends the form');
    // The form of a device must stay open when the user renames the device or deletes its name.
    await page.click('[id^=reread-]');
    await page.click('#device-1-name');
    for (const called of ['Other', '']) {
      await page.click('#device-1-name');
      await page.key('a', { control: true });
      await page.write(called || ' ');
      await page.key('Tab');
      equal(await page.focused(), 'device-1-serial', 'after the name \u201c' + called + '\u201d');
    }
    await page.click('.form-end .action');
    await page.idle();
    expect((await lotText(page)).includes('force-factor = 0.5') && (await lotText(page)).includes('skew-ms = 1'), await lotText(page));
    // While the page still computes after the first edit, the user goes on typing. No typed character may be lost.
    await page.click('#lot-title');
    await page.key('a', { control: true });
    await page.write('A');
    await page.key('Enter');
    await page.write(' long name that goes on while all is computed');
    await page.idle();
    await page.key('Tab');
    await page.idle();
    equal(await page.text('#title'), 'A long name that goes on while all is computed', 'nothing typed is lost');
    // A field accepts a decimal comma. It must not read '0x10' as a number, because isolaw does not read it as one
    // either.
    await set(page, 'design-damping', '0x10');
    await set(page, 'design-K_eff', '0,7');
    expect((await lotText(page)).includes("design = { K_eff = 0.7, damping = '0x10' }"), await lotText(page));
    await end(page);
  },

  'results of what was changed since': async () => {
    const folder = join(work, 'changing');
    mkdirSync(folder);
    copyFileSync(join(example, 'device-01.csv'), join(folder, 'one.csv'));
    const page = await open();
    const said = /were changed since/;
    await page.drop([join(folder, 'one.csv')]);
    await identifyLittle(page);
    equal(await page.text('#laws-doubt'), '', 'nothing was changed');
    // The user drops another record with the same name. The page must warn that the results belong to the earlier
    // record.
    const stronger = readFileSync(join(folder, 'one.csv'), 'utf8').replace(/^([^,\n]*,[^,\n]*,)(-?\d[^,\n]*)/gm, (_, before, force) => before + 2 * Number(force));
    writeFileSync(join(folder, 'one.csv'), stronger);
    await page.drop([join(folder, 'one.csv')], [300, 20]);
    await page.press('show-laws');
    expect(said.test(await page.text('#laws-doubt')), 'beside the report: ' + (await page.text('#view-laws .tools')));
    await page.press('show-save');
    expect(said.test(await page.text('#save-doubt')), 'above what is saved');
    equal(await page.evaluate("document.querySelectorAll('.downloads .care').length"), 3, 'beside the report, its summary and its tables');
    expect(/(No law can be recommended|Take )/.test(await page.text('#answers')), 'what the report answers stands beside the export: ' + (await page.text('#answers')));
    await page.press('make-export');
    await page.saved();
    await page.idle();
    expect(said.test(await page.text('#export-said')), 'beside an export: ' + (await page.text('#export-said')));
    await page.press('save-whole');
    const { path } = await page.saved();
    const again = await open();
    await again.drop([path]);
    expect(said.test(await again.text('#laws-doubt')), 'saved and dropped again');
    equal((await rows(again)).length, 1, 'one device');
    equal(await again.evaluate("document.body.innerText.includes('isolaw-campaign')"), false, 'the page\u2019s own file is none of the records');
    await again.press('identify');
    await again.until("!document.getElementById('progress-bar') && document.getElementById('report-frame')", 'the report', 120);
    await again.idle();
    equal(await again.text('#laws-doubt'), '', 'identified again');
    await end(again);

    // A campaign computed by the command line has no copy of its lot file. The page must compare the digests of the
    // records to notice that a record has changed.
    execFileSync(isolaw, ['calibrate', join(folder, 'one.csv'), '--laws', 'bilinear', '--runs', '1', '--analysis', 'none', '--out', join(folder, 'out'), '--figures', 'none'], { stdio: 'ignore' });
    writeFileSync(join(folder, 'lot.toml'), "title = 'T'\n[[device]]\nname = 'one'\nfile = 'one.csv'\n");
    for (const [changed, file] of [[false, stronger], [true, stronger.replace(/\n[^\n]*\n$/, '\n')]]) {
      writeFileSync(join(folder, 'one.csv'), file);
      const third = await open();
      await third.drop([folder]);
      equal(said.test(await third.text('#laws-doubt')), changed, 'of the command line, changed: ' + changed);
      await end(third);
    }

    // Dropping a campaign would replace edits that the user has not saved, so the page must ask first.
    await page.evaluate('window.asked = 0; window.confirm = () => { ++window.asked; return false; }');
    await set(page, 'lot-title', 'Not saved');
    await page.drop([path], [300, 20]);
    equal([await page.evaluate('window.asked'), await page.text('#title')], [1, 'Not saved'], 'asked, and left as it was');
    await page.evaluate('window.confirm = () => true');
    await page.drop([path], [300, 20]);
    expect((await page.text('#title')) !== 'Not saved' && said.test(await page.text('#laws-doubt')), 'replaced: ' + (await page.text('#title')));
    await end(page);
  },

  'results and records in any order; a lot that is gone': async () => {
    const lot = join(work, 'ordered');
    mkdirSync(join(lot, 'out'), { recursive: true });
    for (const one of records.slice(0, 2)) copyFileSync(join(example, one), join(lot, 'out', one));
    const device = (one, i) => `[[device]]\nname = 'd${i}'\nfile = 'out/${one}'\n`;
    writeFileSync(join(lot, 'lot.toml'), "title = 'Ordered'\n[calibrate]\nlaws = ['bilinear']\nruns = 1\nanalysis = 'none'\n" + records.slice(0, 2).map(device).join(''));
    execFileSync(isolaw, ['calibrate', join(lot, 'lot.toml'), '--out', join(work, 'ordered-out'), '--figures', 'none'], { stdio: 'ignore' });
    const store = join(work, 'ordered-out/campaign.sqlite');
    const said = /were changed since/;

    // The user drops the database first and the records afterwards. The page must compare the records with the digests
    // in the database, and the user can continue the campaign.
    const page = await open();
    await page.drop([store]);
    equal(await page.text('#laws-doubt'), '', 'nothing to compare with');
    await page.drop([lot], [300, 20]);
    await page.press('show-laws');
    equal([await page.text('#laws-doubt'), await page.evaluate("document.getElementById('identify')?.disabled")], ['', false], 'the same records, to continue');
    const name = records[0];
    writeFileSync(join(work, name), readFileSync(join(example, name), 'utf8').replace(/\n[^\n]*\n$/, '\n'));
    mkdirSync(join(work, 'newer/out'), { recursive: true });
    copyFileSync(join(work, name), join(work, 'newer/out', name));
    copyFileSync(join(lot, 'lot.toml'), join(work, 'newer/lot.toml'));
    await page.drop([join(work, 'newer')], [300, 20]);
    await page.press('show-laws');
    expect(said.test(await page.text('#laws-doubt')), 'another record: ' + (await page.text('#view-laws .tools')));
    // While the lot file has a fault, the page must refuse new records. After the user has corrected it, identification
    // is possible again.
    const text = await lotText(page);
    await set(page, 'lot-text', text + '\n[[device');
    await page.drop([join(example, records[2])], [300, 20]);
    expect((await failure(page)).includes('Correct the lot file first'), 'not taken: ' + (await failure(page)));
    await page.press('close-failure');
    await page.press('show-laws');
    await set(page, 'lot-text', text + 'serial = "7"\n');
    await page.press('show-laws');
    equal(await page.evaluate("document.getElementById('identify').disabled"), false, 'it can be identified again');

    // The records of this lot lie in the folder out, where results usually lie. The lot file names them there, so the
    // page must save them as records and find them again when the campaign is dropped.
    await page.press('identify');
    await page.until("!document.getElementById('progress-bar') && document.getElementById('report-frame')", 'the report', 120);
    await page.idle();
    await page.press('show-save');
    await page.press('make-export');
    await page.saved();
    await page.press('save-whole');
    const { path, bytes } = await page.saved();
    equal((await readZip(bytes)).map(({ path: one }) => one).filter((one) => one.startsWith('tables') || one.endsWith('.json')).sort(), ['isolaw-campaign.json', 'out/run.json', 'out/summary.json'], 'results once');
    await page.evaluate('window.asked = 0; window.confirm = () => { ++window.asked; return true; }');
    await set(page, 'lot-title', 'Edited');
    await page.drop([store], [300, 20]);
    await page.press('show-records');
    await page.evaluate('window.asked = 0');
    await page.press('start-over');
    equal(await page.evaluate('window.asked'), 1, 'an edit that is not saved is asked about');
    // The user edits the lot and starts over at once, while the page still computes the effect of the edit. This effect
    // must not appear any more.
    await page.drop([path]);
    await page.press('show-save');
    equal(await page.text('#export-said'), '', 'nothing of the earlier export');
    expect((await rows(page)).length === 2 && (await rows(page)).every(({ tone }) => tone !== 'poor'), 'its records');
    await page.evaluate("document.getElementById('lot-title').value = 'Gone'; document.getElementById('lot-title').dispatchEvent(new Event('change', { bubbles: true })); document.getElementById('start-over').click()");
    await wait(300);
    await page.idle();
    equal([await page.text('#title'), await page.evaluate("document.getElementById('show-properties').disabled")], ['From test records to calibrated laws of seismic isolators', true], 'an empty page');

    // The user drops a folder that has only results. The page must not take any of its files for a record.
    await page.drop([join(work, 'ordered-out')]);
    await page.press('show-records');
    equal(await page.text('#read-band .word'), 'Results only', 'results');
    expect(!(await page.text('#contents')).includes('Not part of the lot'), await page.text('#contents'));
    await end(page);

    // The user's own rule set is a file of the lot. The page must warn when it has changed since the results were
    // computed.
    const held = await open();
    const rules = execFileSync(isolaw, ['rules', 'template'], { encoding: 'utf8' });
    mkdirSync(join(work, 'held'));
    writeFileSync(join(work, 'held/rules.toml'), rules);
    writeFileSync(join(work, 'held/lot.toml'), "title = 'Held'\n[calibrate]\nlaws = ['bilinear']\nruns = 1\nanalysis = 'none'\n[acceptance]\nrules = 'rules.toml'\ndesign = { K_eff = 0.6 }\n[[device]]\nname = 'd'\nfile = 'd.csv'\n");
    copyFileSync(join(example, records[0]), join(work, 'held/d.csv'));
    await held.drop([join(work, 'held')]);
    await identified(held, 120);
    equal(await held.text('#laws-doubt'), '', 'as it was');
    writeFileSync(join(work, 'held/rules.toml'), rules.replace('Contract 2024-07', 'Contract 2025-01'));
    await held.drop([join(work, 'held/rules.toml')], [300, 20]);
    await held.press('show-laws');
    expect(said.test(await held.text('#laws-doubt')), 'another rule set');
    await end(held);
  },

  'a report in its frame: its menu, what is dropped on it, its print': async () => {
    const page = await open();
    await page.drop([join(example, records[0])]);
    await identifyLittle(page);
    await inFrameUntil(page, PLOTS, 'plots');
    const hash = await page.inFrame("[...document.querySelectorAll('nav a')].at(-1).getAttribute('href')");
    await page.inFrame("[...document.querySelectorAll('nav a')].at(-1).click()");
    await wait(700);
    const place = await page.inFrame(`({ top: document.querySelector(${JSON.stringify(hash)}).getBoundingClientRect().top, scrolled: scrollY, end: innerHeight + scrollY >= document.documentElement.scrollHeight - 2 })`);
    expect(place.scrolled > 200 && (place.top < 300 || place.end), hash + ' is gone to: ' + JSON.stringify(place));
    await page.inFrame('window.print = () => { window.printed = true; }');
    await page.key('p', { control: true });
    await wait(200);
    equal(await page.inFrame('window.printed === true'), true, 'Ctrl+P prints the report');
    // The user drags a file over the frame of a report. The page must get the file, not the frame.
    const other = join(example, records[1]);
    await page.drop([other], [640, 500]);
    await page.idle();
    equal((await rows(page)).length, 2, 'dropped on a report');
    equal(await page.evaluate("document.body.hasAttribute('data-dropping')"), false, 'the sheet is gone');
    await page.press('show-laws');
    for (const type of ['dragEnter', 'dragEnter', 'dragOver', 'dragCancel']) {
      await page.drag(type, [other], [640, 500]);
      await wait(200);
    }
    await page.send('Input.dispatchMouseEvent', { type: 'mouseMoved', x: 200, y: 20 });
    equal(await page.evaluate("document.body.hasAttribute('data-dropping')"), false, 'and when it is taken away again');
    await end(page);
  },

  'twice at once; names of another system; a campaign that was cancelled': async () => {
    const page = await open();
    const two = records.slice(0, 2).map((one) => join(example, one));
    for (const type of ['dragEnter', 'dragOver', 'drop', 'dragEnter', 'dragOver', 'drop']) await page.drag(type, two);
    await wait(100);
    await page.idle();
    equal((await rows(page)).map(({ tone }) => tone), ['good', 'good'], 'each once');

    // The user cancels an identification, saves everything and drops the saved file. The identification must continue
    // with the runs that were finished.
    await page.press('show-laws');
    await set(page, 'method', 'best');
    await set(page, 'analysis', 'none');
    await set(page, 'runs', '4');
    await page.press('identify');
    await page.until("Number(document.getElementById('progress-bar')?.value) > 0.4", 'some of it', 120);
    await page.key('Escape');
    await page.until("document.getElementById('laws-said')", 'cancelled');
    await page.press('show-save');
    expect((await page.text('#view-save')).includes('before you cancelled'), await page.text('#view-save'));
    await page.press('save-whole');
    const { path, bytes } = await page.saved();
    const parts = (await readZip(bytes)).filter(({ path: one }) => one.startsWith('parts/'));
    expect(parts.length > 0, 'parts are saved');
    const again = await open();
    await again.drop([path]);
    equal((await rows(again)).length, 2, 'devices');
    equal(await again.evaluate("document.body.innerText.includes('campaign.sqlite')"), false, 'parts are no records');
    await again.press('show-laws');
    await again.press('identify');
    await again.until("document.getElementById('report-frame')", 'the report', 300);
    equal(await again.text('#laws-doubt'), '', 'whole');
    // Escape must not cancel the identification while the page shows another view. When the user cancels a second
    // identification, the page must say so and still show the first report.
    await again.press('change');
    await set(again, 'runs', '5');
    await again.press('identify');
    await again.until("document.getElementById('progress-bar')", 'progress');
    await again.press('show-records');
    await again.key('Escape');
    await wait(200);
    await again.press('show-laws');
    expect(await again.evaluate("Boolean(document.getElementById('progress-bar'))"), 'Escape on another view ends nothing');
    await again.key('Escape');
    await again.until("document.getElementById('laws-said')", 'cancelled');
    await again.until("document.getElementById('report-frame')", 'the first report');
    await end(again);

    // The lot file comes from Windows: one path has a backslash, the other names a folder that does not exist and has
    // another case. The page must find both files by their names.
    const folder = join(work, 'windows');
    mkdirSync(join(folder, 'data'), { recursive: true });
    copyFileSync(join(example, records[0]), join(folder, 'data/a.csv'));
    copyFileSync(join(example, records[1]), join(folder, 'B.CSV'));
    writeFileSync(join(folder, 'lot.toml'), "title = 'W'\n[[device]]\nname = 'A'\nserial = '7'\nfile = 'data\\a.csv'\n[[device]]\nname = 'B'\nfile = 'elsewhere/b.csv'\n");
    const third = await open();
    await third.drop([folder]);
    equal((await rows(third)).map(({ name: one, tone }) => one + ' ' + tone), ['A good', 'B good'], 'found by their names');
    expect((await lotText(third)).includes("serial = '7'") && (await third.text('#title')) === 'W', await lotText(third));
    // The user drops a file with its displacement in cm after one in mm. The page must not use the unit of the first
    // file for the second.
    writeFileSync(join(work, 'in-cm.csv'), readFileSync(join(example, records[0]), 'utf8').replace('Displacement [mm]', 'Displacement [cm]'));
    await third.drop([join(work, 'in-cm.csv')]);
    const millimetres = async (one) => Number((await rows(one)).at(-1).amplitude);
    expect((await millimetres(third)) > 2000, 'in cm, as its header says: ' + (await millimetres(third)));
    const fifth = await open();
    await fifth.drop([join(example, records[1])]);
    await fifth.drop([join(work, 'in-cm.csv')]);
    expect((await millimetres(fifth)) > 2000, 'in cm, after another that is not: ' + (await millimetres(fifth)));
    await end(fifth);
    // The folder has none of the files that its lot file names, but another record. The page must read this record with
    // the settings of the lot file and take the name of the folder as the title.
    const other = join(work, 'next-month');
    mkdirSync(other);
    copyFileSync(join(example, records[0]), join(other, 'm1.csv'));
    writeFileSync(join(other, 'lot.toml'), "title = 'W'\n[[device]]\nname = 'A'\nfile = 'gone.csv'\n");
    const fourth = await open();
    await fourth.drop([other]);
    equal([(await rows(fourth)).map(({ name: one }) => one), await fourth.text('#title')], [['m1'], 'next-month'], 'read in the same way');
    await end(fourth);
    await end(third);
    await end(page);
  },

  'by keyboard alone': async () => {
    const page = await open();
    const { key, focused } = page;
    const reach = async (id, most = 200) => {
      for (let i = 0; i < most; ++i) {
        if ((await focused()) === id) return true;
        await key('Tab');
      }
      expect(false, 'no way to #' + id);
      return false;
    };
    const seen = [];
    for (let i = 0; i < 8; ++i) {
      await key('Tab');
      seen.push(await focused());
    }
    for (const id of ['skip', 'show-records', 'show-about', 'choose-files', 'choose-folder', 'example']) expect(seen.includes(id), id + ' by Tab: ' + seen);
    await reach('example');
    await key('Enter');
    await page.until("document.querySelectorAll('#devices tr.device').length === 10", 'the example lot');
    await page.idle();
    await reach('to-laws');
    await key('Enter');
    await page.until("document.getElementById('identify') && document.body.dataset.view === 'laws'", 'Laws');
    await set(page, 'method', 'best');
    await reach('identify');
    await key('Enter');
    await page.until("document.getElementById('progress-bar')", 'progress');
    await key('Escape');
    await page.until("!document.getElementById('progress-bar')", 'the end by Escape');
    equal(await focused(), 'identify', 'the focus comes back');
    // The keyboard must reach every control of each view.
    for (const view of ['records', 'laws', 'save', 'about']) {
      await page.press('show-' + view);
      expect((await page.evaluate("[...document.querySelectorAll('button, input:not([type=file]), select, textarea, summary, a[href]')].every((one) => one.tabIndex >= 0)")) === true, view + ': all can be reached');
    }
    await end(page);
  },

  'everybody can read it, on a telephone, in the dark, on paper': async () => {
    const axe = join(root, 'node_modules/axe-core/axe.min.js');
    const rules = existsSync(axe) ? readFileSync(axe, 'utf8') : null;
    if (!rules) console.log('  skipped: axe-core (npm ci in the project\u2019s root)');
    for (const [width, dark] of [[1280, false], [1280, true], [360, false], [360, true]]) {
      const page = await open({ width, dark, height: width < 500 ? 740 : 800 });
      if (rules) await page.evaluate(rules + ';0');
      const look = async (state) => {
        const where = `${state}, ${width} px${dark ? ', dark' : ''}`;
        await page.evaluate("for (const details of document.querySelectorAll('details')) details.open = true");
        await narrow(page, where);
        if (!rules) return;
        const { passes, found } = await page.evaluate("axe.run(document, { resultTypes: ['violations'], iframes: false }).then(({ violations, passes }) => ({ passes: passes.length, found: violations.map(({ id, impact, nodes }) => impact + ' ' + id + ': ' + nodes.slice(0, 2).map((node) => node.html.slice(0, 140)).join(' | ')) }))");
        expect(passes > 10, where + ': ' + passes + ' rules apply');
        equal(found, [], where);
      };
      await look('empty');
      await page.drop([example, join(root, 'tests/warts/no-units.csv')]);
      await page.drop([join(root, 'tests/warts/empty.csv'), join(root, 'tests/warts/mts-793-axial.dat'), join(root, 'tests/warts/counter.csv')]);
      for (const one of await page.evaluate("[...document.querySelectorAll('[id^=values-][aria-expanded=false]')].slice(-2).map(({ id }) => id)")) await page.press(one);
      expect((await page.evaluate("document.querySelectorAll('.reading .guess').length")) > 0 && (await page.evaluate("document.querySelectorAll('.no-time').length")) > 0, 'a guess and a file without time');
      await openForm(page, 0);
      await look('records');
      await page.press('show-properties');
      await look('properties');
      if (width < 500) {
        await inFrameUntil(page, PLOTS, 'plots');
        expect((await page.inFrame('document.documentElement.scrollWidth <= innerWidth')) === true, 'the report is as narrow as its frame');
      }
      await page.press('show-laws');
      await page.press('laws-some');
      await page.idle();
      await look('laws');
      await page.press('identify');
      await page.until("document.getElementById('fits')", 'progress');
      await look('running');
      await page.press('cancel');
      await page.until("!document.getElementById('fits')", 'the end');
      await identifyLittle(page, ['bilinear']);
      await look('report');
      await page.press('show-save');
      await look('save');
      await page.press('show-about');
      await page.press('self-test');
      await page.until("document.querySelector('#self-test-said .good, #self-test-said .poor')", 'the self-test');
      expect((await page.evaluate("Boolean(document.querySelector('#self-test-said .good'))")) === true, 'the self-test: ' + (await page.text('#self-test-said')));
      expect((await page.text('#version')).length > 2, 'the version');
      if (!standIn) for (const library of ['Eigen', 'SQLite', 'Plotly']) expect((await page.text('#licences')).includes(library), 'licences: ' + library);
      await look('about');
      await page.press('show-records');
      await page.drop([conditions], [300, 20]);
      await page.press('test-1-more');
      await look('tests under several conditions');
      await page.send('Emulation.setEmulatedMedia', { media: 'print' });
      expect((await page.evaluate("getComputedStyle(document.querySelector('.drop')).display === 'none' && getComputedStyle(document.getElementById('devices')).display !== 'none'")) === true, 'on paper');
      await end(page);
    }
  },
};

try {
  for (const [title, test] of Object.entries(tests)) {
    if (only && !title.includes(only)) continue;
    name = title;
    console.log(title);
    try {
      await test();
    } catch (error) {
      expect(false, error.stack ?? error);
    }
  }
} finally {
  await browser.close().catch(() => {});
  rmSync(work, { recursive: true, force: true });
}
console.log(failures.length === 0 ? 'all hold' : failures.length + ' do not hold');
process.exit(failures.length === 0 ? 0 : 1);
