// Commands in the page's engine must give the same answers as in the native program. A command that fails must not
// affect other commands.
//   node commands_test.mjs PAGE ISOLAW
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { OF_GA, usualRuns } from '../../../page/usual.js';
import { engine, engineWith, filesIn, lay, native, textOf, work } from './support.mjs';

after(() => engine.close());

const corpus = fileURLToPath(new URL('../../../fuzz/corpus/', import.meta.url));
assert.equal(native(['example', 'example']).code, 0);
const example = filesIn(join(work, 'example'), 'example');
const at = (name) => example.filter(({ path }) => path.endsWith(name));

// Compares two outputs. Words must be equal. Numbers may differ in their last digits, because the engine has another
// mathematical library.
const number = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
const same = (said, own, name) => {
  assert.equal(said.code, own.code, name + ': ' + said.stderr);
  assert.equal(said.stderr, own.stderr, name);
  // Where the native program writes a failure as JSON, the engine returns it as an object and writes nothing.
  if (said.error) assert.equal(said.stdout, '', name);
  const stdout = said.error && own.stdout ? JSON.stringify({ error: said.error, exit: said.code }) + '\n' : said.stdout;
  assert.equal(stdout.replace(number, '#'), own.stdout.replace(number, '#'), name);
  const wanted = own.stdout.match(number) ?? [];
  for (const [i, found] of (stdout.match(number) ?? []).entries())
    assert.ok(found === wanted[i] || Math.abs(found - wanted[i]) <= 1e-7 * Math.abs(wanted[i]) + 1e-9, `${name}: ${found}, natively ${wanted[i]}`);
};

test('the version, with the build that computes; the compiler differs', async () => {
  const [program, compiler, build] = (await engine.version()).split('\n'),
    own = native(['--version']).stdout.trim().split('\n');
  assert.deepEqual([program.replace(/ \(.*/, ''), build], [own[0].replace(/ \(.*/, ''), own[2]]);
  assert.match(compiler, /^emscripten's clang\+\+ [0-9.]+, portable$/);
});

test('what the page knows of settings is so', async () => {
  const help = (await engine.run({ argv: ['calibrate', '--help'] })).stdout;
  assert.match(help, new RegExp(`--runs INT .*\\(default ${usualRuns('best')}; with --method ga ${usualRuns('ga')}\\)`));
  const ofGa = [...help.matchAll(/--([\w-]+) \w+\s+with --method ga: /g)].map(([, name]) => name);
  assert.deepEqual(ofGa.sort(), [...OF_GA].sort());
});

test('wrong words are an answer, not a rejection', async () => {
  const said = await engine.run({ argv: ['calibrate', 'nowhere.csv'] });
  assert.equal(said.code, 2);
  assert.match(said.stderr, /nowhere\.csv: no such file/);
  // The engine returns the complaints as objects too. Its message must be the same as the native program's and consist
  // of these complaints.
  const own = native(['calibrate', 'nowhere.csv']);
  assert.equal(said.stderr, own.stderr);
  assert.equal(said.error.kind, 'input');
  const text = ({ where, found, allowed, advice }) =>
    `isolaw: ${where}: ${found}` + (allowed && '; allowed: ' + allowed) + (advice && '; try: ' + advice) + '\n';
  assert.equal(said.stderr, said.error.complaints.map(text).join(''));
  assert.equal((await engine.run({ argv: ['laws'] })).error, null);
});

test('inspection says the same, number by number', async () => {
  const argv = ['inspect', 'example/lot.toml', '--json'];
  const said = await engine.run({ argv, files: example });
  assert.equal(said.code, 0, said.stderr);
  same(said, native(argv), 'the example lot');
});

// The inputs of the fuzz targets are sound and broken records: text, workbooks, MATLAB files and JSON. The engine and
// the native program must say the same of each record.
for (const kind of ['text', 'workbook', 'mat', 'json'])
  test(`files of others: ${kind}`, async () => {
    const extension = { text: '.csv', workbook: '.xlsx', mat: '.mat', json: '.json' }[kind];
    for (const name of readdirSync(join(corpus, kind))) {
      const path = 'fuzzed-' + name + (name.endsWith(extension) ? '' : extension);
      const files = [{ path, bytes: readFileSync(join(corpus, kind, name)) }];
      lay(files);
      const argv = ['inspect', path, '--json'];
      const [said, own] = [await engine.run({ argv, files }), native(argv)];
      same(said, own, name);
    }
  });

test('files of others: one for each wart of records', async () => {
  const folder = fileURLToPath(new URL('../../warts/', import.meta.url));
  for (const name of readdirSync(folder).filter((one) => !/warts\.json|make\.py/.test(one))) {
    const files = [{ path: name, bytes: readFileSync(join(folder, name)) }];
    lay(files);
    const argv = ['inspect', name, '--json'];
    const [said, own] = [await engine.run({ argv, files }), native(argv)];
    same(said, own, name);
  }
});

test('a file of MATLAB 7.3 says how to save it', async () => {
  const said = await engine.run({ argv: ['inspect', 'a.mat'], files: [{ path: 'a.mat', bytes: readFileSync(join(corpus, 'mat73/sound.mat')) }] });
  assert.equal(said.code, 2);
  assert.match(said.stderr, /MATLAB 7\.3.*save\(\.\.\., '-v7'\)/s);
});

test('only what a command made comes back, and of that what is asked for', async () => {
  const { files } = await engine.run({ argv: ['inspect', 'example/device-01.csv', '--out', 'out'], files: at('device-01.csv'), keep: ['out/*.html'] });
  assert.ok(files.length > 0 && files.every(({ path }) => /^out\/.*\.html$/.test(path)), files.map(({ path }) => path).join(' '));
});

const long = { argv: ['calibrate', 'example/device-01.csv', '--laws', 'abe', '--runs', '50', '--out', 'out'], files: at('device-01.csv') };

test('a command is cancelled at once, and the next one runs', async () => {
  const stop = new AbortController();
  const ended = engine.run({ ...long, signal: stop.signal }).catch((error) => error);
  await new Promise((done) => setTimeout(done, 1000));
  const began = Date.now();
  stop.abort();
  assert.equal((await ended).name, 'AbortError');
  assert.ok(Date.now() - began < 1000);
  assert.equal((await engine.run({ argv: ['laws'] })).code, 0);
});

test('what stops a worker is an error, and the next command runs', async () => {
  const error = await engine.run({ argv: ['--version'], files: [{ path: 'a/b', bytes: null }] }).catch((found) => found);
  assert.equal(error.name, 'CrashError');
  assert.equal((await engine.run({ argv: ['--version'] })).code, 0);
});

// Imitates a browser that is short of memory: WebAssembly's memory cannot grow beyond 48 MiB.
const poor = `
const grow = WebAssembly.Memory.prototype.grow;
WebAssembly.Memory.prototype.grow = function (pages) {
  if (this.buffer.byteLength + 65536 * pages > 48 << 20) throw new RangeError('WebAssembly.Memory.grow(): no more');
  return grow.call(this, pages);
};
`;

test('the end of memory is an error that says what to try, and the next command runs', async () => {
  const small = await engineWith({ workers: 1, before: poor });
  const rows = Array.from({ length: 300_000 }, (_, i) => `${i / 100},${100 * Math.sin(i / 50)},${60 * Math.sin(i / 50 + 0.2)}`).join('\n');
  const bytes = new TextEncoder().encode('time [s],displacement [mm],force [kN]\n' + rows + '\n');
  const error = await small.run({ argv: ['inspect', 'long.csv'], files: [{ path: 'long.csv', bytes }] }).catch((found) => found);
  assert.equal(error.name, 'MemoryError');
  assert.match(error.message, /no more memory.*try fewer or shorter records/);
  assert.equal((await small.run({ argv: ['--version'] })).code, 0);
  small.close();
  assert.equal((await engine.run({ argv: ['inspect', 'long.csv'], files: [{ path: 'long.csv', bytes }], keep: [] })).code, 0);
});

test('a campaign that was cancelled goes on from what was finished', async () => {
  const options = ['--laws', 'bilinear,vaiana', '--runs', '3', '--replicates', '40'];
  const inputs = ['example/device-01.csv', 'example/device-02.csv'],
    files = [...at('device-01.csv'), ...at('device-02.csv')];
  const stop = new AbortController();
  const told = [];
  const cancelled = await engine
    .identify({ inputs, files, options, signal: stop.signal, onProgress: (p) => (told.push(p), p.phase === 'analyses' && stop.abort()) })
    .catch((error) => error);
  assert.equal(cancelled.name, 'AbortError');
  assert.ok(cancelled.parts.some(({ path }) => path.startsWith('parts/')));
  const again = await engine.identify({ inputs, files, options, parts: cancelled.parts });
  assert.equal(again.code, 0, again.stderr);
  // The workers computed all analyses in parts, including those of the laws that are fitted to the whole lot. The last
  // merge therefore only copied 10 analyses and computed none.
  assert.match(again.stderr, / and 10 analyses copied/);
  // A campaign that was computed in parts must give the same bytes as one that a single command computes.
  const one = await engine.run({ argv: ['calibrate', ...inputs, ...options, '--out', 'out', '--figures', 'none'], files });
  assert.equal(textOf(again.files, 'out/summary.json'), textOf(one.files, 'out/summary.json'));
  assert.ok(told.every(({ share }, i) => share >= 0 && share <= 1 && (i === 0 || share >= told[i - 1].share)));
});
