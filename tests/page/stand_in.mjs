// Runs the native program in place of the page's engine. In the page, stand_in/engine.js sends the calls of the engine
// to this module over the DevTools protocol.
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { asksForErrors, errorIn } from '../../page/engine/errors.js';

const all = (folder) => readdirSync(folder, { recursive: true, withFileTypes: true }).filter((one) => one.isFile()).map((one) => join(one.parentPath ?? one.path, one.name));

export async function answerWith(page, program) {
  const children = new Map();
  const answer = (id, what) => page.evaluate(`window.isolawAnswer(${id}, ${JSON.stringify(what)})`).catch(() => {});
  page.onBinding = async (payload) => {
    const { id, what, files, parts, argv, keep, lotPath, options } = JSON.parse(payload);
    if (what === 'abort') {
      children.get(id)?.kill('SIGINT');
      children.get(id).aborted = true;
      return;
    }
    const folder = mkdtempSync(join(tmpdir(), 'isolaw-stand-in-'));
    for (const { path, bytes } of [...files, ...parts]) {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      writeFileSync(join(folder, path), Buffer.from(bytes, 'base64'));
    }
    const before = new Set(all(folder));
    const words = what === 'run' ? argv : ['calibrate', lotPath, ...options, '--out', 'out', '--figures', 'none'];
    const child = spawn(program, asksForErrors(words), { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
    children.set(id, child);
    let stdout = '',
      stderr = '';
    child.stdout.setEncoding('utf8').on('data', (text) => (stdout += text));
    child.stderr.setEncoding('utf8').on('data', (text) => (stderr += text));
    let done = 0;
    const tick = what === 'identify' && setInterval(() => answer(id, { progress: { done: ++done, total: 40, share: Math.min(0.99, done / 40), secondsLeft: Math.max(1, 20 - done / 2), phase: done < 20 ? 'runs' : 'analyses', laws: [{ id: 'bouc-wen', runs: 1000, devices: 1, error: 0.05 }, { id: 'bilinear', runs: 1000, devices: 1, error: 0.1 }] } }), 500);
    child.on('close', (code) => {
      clearInterval(tick);
      children.delete(id);
      const changed = all(folder)
        .filter((file) => !before.has(file) || what === 'identify')
        .map((file) => ({ path: relative(folder, file), bytes: readFileSync(file).toString('base64') }))
        .filter(({ path }) => (what === 'run' ? (keep ?? ['*']).some((one) => new RegExp('^' + one.replace(/[.+]/g, '\\$&').replace(/\*/g, '.*') + '$', 's').test(path)) : path.startsWith('out/')));
      rmSync(folder, { recursive: true });
      if (child.aborted) answer(id, { failure: { name: 'AbortError', message: 'cancelled', parts: changed.filter(({ path }) => path.endsWith('.sqlite')) } });
      else {
        const lines = stderr.split('\n').slice(0, -1);
        const error = errorIn(lines, code);
        answer(id, { code, stdout, stderr: lines.map((line) => line + '\n').join(''), error, files: changed });
      }
    });
  };
  await page.send('Runtime.addBinding', { name: 'isolawCall' });
}
