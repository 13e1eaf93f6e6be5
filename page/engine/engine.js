// Runs the command line program in the browser, for the page. All computing is done by the program itself, compiled to
// WebAssembly.
//
//   const engine = await createEngine({ workers: 4 });      // workers: default navigator.hardwareConcurrency
//
//   const r = await engine.run({
//     argv: ['inspect', 'a.csv', '--out', 'out'],           // as after `isolaw` on a command line
//     files: [{ path: 'a.csv', bytes: Uint8Array }],        // copied into the working folder before the command starts
//     keep: ['out/*'],                                      // '*' matches any text, '/' too; default ['*']
//     onText: (stream, line) => {},                         // 'stdout' | 'stderr', without its line end
//     signal: abortController.signal,
//   });
//   r = { code, stdout, stderr, error, files }              // files: [{ path, bytes }], files that the command made
//                                                           // or changed and `keep` names; error: see errors.js
//
// Each command runs in a worker, in a new instance of the program, so that it starts with fresh memory and files. If
// there are more commands than workers, the rest waits. If the input of a command is wrong, run() still resolves:
// `code` is 2, `stderr` has the message that the command line prints, and `error` has the same complaints as objects.
// run() rejects with an Error whose `name` is
//   'AbortError'   the signal was raised; the worker is ended at once, and another one takes its place
//   'MemoryError'  the command asked for more memory than the page gives it
//   'CrashError'   the worker crashed or ended; another one takes its place
// The page can show `error.message` as it is. `error.stderr` has the text that the command had written.
//
//   const r = await engine.identify({
//     lotPath: 'lot.toml', files,                           // the lot file and all files
//     inputs: ['a.csv', 'b.csv'],                           // in place of lotPath: the words that follow `calibrate`
//     options: ['--laws', 'paper', '--runs', '3'],          // of `isolaw calibrate`; not --out, --part, --jobs, --figures
//     workers: 2,                                           // default: all
//     parts: [{ path, bytes }],                             // optional: files of an earlier or a cancelled campaign
//     onProgress: ({ done, total, share, secondsLeft, phase, laws }) => {},   // phase 'runs' | 'analyses'; share 0 to 1
//                                                           // laws: [{ id, runs, devices, error }]: finished runs of
//                                                           // the law, devices with a fit, and the mean of their
//                                                           // least objectives or null
//     onText, signal,
//   });
//   r = { code, stdout, stderr, error, files }              // files of the whole campaign, below 'out/': out/report.html,
//                                                           // out/summary.json, out/campaign.sqlite, out/tables/...
// identify() cuts the campaign into parts, the workers compute them by `calibrate --part K/N`, and one worker joins
// them by `merge`. If it is cancelled, `error.parts` of the AbortError has the files of finished work. A later
// identify() continues from them if it gets them as `parts`. A saved campaign is opened by `run({ argv: ['report',
// 'out'], files: [{ path: 'out/campaign.sqlite', bytes }] })`.
//
//   await engine.version()     for example '0.3.0', the version that `isolaw --version` prints
//   await engine.selfTest()    { ok, found, expected, what }: compares objectives with those of the native program
//   engine.licences            [{ name, version, licence, text }] of the libraries in the program
//   engine.workers             the number of workers
//   engine.close()             ends all workers


import { identifyWith } from './identify.js';
import { makePool } from './pool.js';
import { runSelfTest } from './self_test.js';

// Returns the program and the licences of its libraries, which embed.mjs put into the document, and a function that
// starts a worker.
function ofDocument() {
  const text = (id) => document.getElementById(id).textContent;
  const script = URL.createObjectURL(new Blob([text('isolaw-worker')], { type: 'text/javascript' }));
  return {
    facts: JSON.parse(text('isolaw-facts')),
    packed: Uint8Array.from(atob(text('isolaw-program')), (sign) => sign.charCodeAt(0)),
    start: () => new Worker(script, { name: 'isolaw' }),
    cores: navigator.hardwareConcurrency,
  };
}

// `from` tells where the program comes from and how a worker starts. By default both come from the HTML document;
// in_node.mjs gives another `from` for use under Node.
export const createEngine = async ({ workers, from = ofDocument() } = {}) => {
  const { facts, packed, start, cores } = from;
  const inflated = new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip')));
  const module = await WebAssembly.compile(await inflated.arrayBuffer());
  const pool = makePool(start, Promise.resolve(module), Math.max(1, workers ?? cores ?? 2));
  // postMessage() copies the files for the worker, so the caller's bytes stay valid.
  const run = (what) => pool.run(what);
  return {
    run,
    identify: identifyWith(pool),
    version: async () => (await run({ argv: ['--version'] })).stdout.trim(),
    selfTest: () => runSelfTest(run),
    licences: facts.licences,
    workers: pool.count,
    close: pool.close,
  };
};
