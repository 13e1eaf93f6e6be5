// The command line program in the browser, as the page calls it. Nothing of the program is implemented again in it.
//
//   const engine = await createEngine({ workers: 4 });      // workers: default navigator.hardwareConcurrency
//
//   const r = await engine.run({
//     argv: ['inspect', 'a.csv', '--out', 'out'],           // as after `isolaw` on a command line
//     files: [{ path: 'a.csv', bytes: Uint8Array }],        // laid below the working folder before it starts; copied
//     keep: ['out/*'],                                      // '*' matches any text, '/' too; default ['*']
//     onText: (stream, line) => {},                         // 'stdout' | 'stderr', without its line end
//     signal: abortController.signal,
//   });
//   r = { code, stdout, stderr, error, files }            // files: [{ path, bytes }], made or changed by the command, that
//                                                         // `keep` names; error: null, or what errors.js says
//
// Each command runs in a worker, in a new instance of the program, so that nothing is left of earlier commands. If
// there are more commands than workers, they wait. A wrong input does not reject: `code` is 2, `stderr` has the message
// as on the command line, and `error` has its complaints as objects.
// Rejects with an Error whose `name` is
//   'AbortError'   the signal; the worker is ended at once, and another takes its place
//   'MemoryError'  the command asked for more memory than the page gives it
//   'CrashError'   the worker trapped, or ended; another takes its place
// and whose `message` can be shown as it is; `error.stderr` has what the command had written.
//
//   const r = await engine.identify({
//     lotPath: 'lot.toml', files,                           // the lot file, or any inputs: argv words that follow `calibrate`
//     inputs: ['a.csv', 'b.csv'],                           //   (in place of lotPath)
//     options: ['--laws', 'paper', '--runs', '3'],          // of `isolaw calibrate`; not --out, --part, --jobs, --figures
//     workers: 2,                                           // default: all
//     parts: [{ path, bytes }],                             // optional: files of an earlier campaign or of a cancelled one
//     onProgress: ({ done, total, share, secondsLeft, phase }) => {},   // phase 'runs' | 'analyses'; share 0 to 1
//     onText, signal,
//   });
//   r = { code, stdout, stderr, error, files }              // files of the whole campaign, below 'out/': out/report.html,
//                                                           // out/summary.json, out/campaign.sqlite, out/tables/...
// Worker k of n computes `calibrate --part k/n`, then one worker joins the parts by `merge`. On 'AbortError'
// `error.parts` has the finished work, to be given back as `parts`. A saved campaign is opened by `run({ argv:
// ['report', 'out'], files: [{ path: 'out/campaign.sqlite', bytes }] })`.
//
//   await engine.version()     '0.3.0', as `isolaw --version` says it
//   await engine.selfTest()    { ok, found, expected, what }: a small objective against the stored one of the native program
//   engine.licences            [{ name, version, licence, text }] of the libraries in the program
//   engine.workers             the number of workers
//   engine.close()             ends all workers


import { identifyWith } from './identify.js';
import { makePool } from './pool.js';
import { runSelfTest } from './self_test.js';

// The parts that the build put into the document (embed.mjs), and how the document starts a worker.
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

// Tests give `from` in place of the document's parts.
export const createEngine = async ({ workers, from = ofDocument() } = {}) => {
  const { facts, packed, start, cores } = from;
  const inflated = new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip')));
  const module = await WebAssembly.compile(await inflated.arrayBuffer());
  const pool = makePool(start, Promise.resolve(module), Math.max(1, workers ?? cores ?? 2));
  // Posting copies the files, so that the caller keeps the bytes.
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
