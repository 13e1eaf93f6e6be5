// Keeps a pool of workers. Each worker runs one command at a time. If all workers are busy, commands wait in a queue.

import { asksForErrors, errorIn } from './errors.js';

const NO_MEMORY = 'the page has no more memory for this; try fewer or shorter records at once';

const named = (name, message, more) => Object.assign(new Error(message), { name, ...more });

// `start()` returns a new worker. `module` is a promise of the compiled WebAssembly program. `count` is the largest
// number of workers.
export function makePool(start, module, count) {
  const waiting = [];
  const busy = new Set();
  const idle = [];
  let closed = false;

  const open = () => {
    const worker = start();
    worker.sent = module.then((compiled) => worker.postMessage({ kind: 'compiled', module: compiled }));
    return worker;
  };

  const next = () => {
    while (!closed && waiting.length > 0 && busy.size < count) {
      const job = waiting.shift();
      const worker = idle.pop() ?? open();
      busy.add(worker);
      job.begin(worker);
    }
  };

  const free = (worker, whole) => {
    busy.delete(worker);
    if (whole && !closed) idle.push(worker);
    else worker.terminate();
    // The worker of an aborted or crashed command was ended. A new worker starts at once, so that the next command need
    // not wait for its start.
    if (!whole && !closed && idle.length + busy.size < count) idle.push(open());
    next();
  };

  function run({ argv, files = [], keep = ['*'], watch = null, onText = null, onKept = null, signal = null }) {
    return new Promise((resolve, reject) => {
      const said = { stdout: [], stderr: [] };
      const text = (stream) => (said[stream].length > 0 ? said[stream].join('\n') + '\n' : '');
      let worker = null,
        over = false;
      const end = (whole) => {
        if (over) return false;
        over = true;
        signal?.removeEventListener('abort', abort);
        if (worker) free(worker, whole);
        return true;
      };
      const fail = (name, message) => {
        if (end(false)) reject(named(name, message, { stderr: text('stderr') }));
      };
      const abort = () => {
        const at = waiting.indexOf(job);
        if (at >= 0) waiting.splice(at, 1);
        fail('AbortError', 'cancelled');
      };
      const job = {
        begin: (with_) => {
          worker = with_;
          worker.onerror = (event) => {
            event.preventDefault?.();
            fail('CrashError', 'the program stopped: ' + (event.message || 'its worker ended'));
          };
          worker.onmessageerror = () => fail('CrashError', 'the program could not be handed to its worker');
          worker.onmessage = ({ data }) => {
            if (over) return;
            if (data.kind === 'text') {
              for (const line of data.lines) said[data.stream].push(line);
              if (onText) for (const line of data.lines) onText(data.stream, line);
            } else if (data.kind === 'kept') onKept?.(data.files);
            else if (data.kind === 'failed') fail(data.name, data.name === 'MemoryError' ? NO_MEMORY : data.message);
            else if (data.kind === 'done') {
              const error = errorIn(said.stderr, data.code);
              if (error?.kind === 'memory') fail('MemoryError', NO_MEMORY);
              else if (end(true)) resolve({ code: data.code, stdout: text('stdout'), stderr: text('stderr'), error, files: data.files });
            }
          };
          worker.sent.then(
            () => worker.postMessage({ kind: 'run', argv: asksForErrors(argv), files, keep, watch }),
            (error) => fail('CrashError', 'the program cannot be started: ' + error.message),
          );
        },
      };
      if (signal?.aborted) {
        abort();
        return;
      }
      signal?.addEventListener('abort', abort);
      waiting.push(job);
      next();
    });
  }

  const close = () => {
    closed = true;
    for (const worker of [...idle.splice(0), ...busy]) worker.terminate();
  };
  if (count > 0) idle.push(open());
  return { run, close, count };
}
