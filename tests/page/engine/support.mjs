// All tests of the page's engine use this module. They run under Node, and their arguments are the page and the native
// program: PAGE ISOLAW.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { engineOf } from '../../../page/engine/in_node.mjs';

export const [page, isolaw] = process.argv.slice(2);
export const work = mkdtempSync(join(tmpdir(), 'isolaw-engine-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

export const engineWith = (options) => engineOf(page, options);
export const engine = await engineWith({ workers: 2 });

// Runs the native program and returns its outputs. `env` may hold ISOLAW_SIMD to choose an instruction set.
export const native = (words, env = {}) => {
  const { status, stdout, stderr } = spawnSync(isolaw, words, { cwd: work, encoding: 'utf8', env: { ...process.env, ...env }, maxBuffer: 1 << 28 });
  return { code: status, stdout, stderr };
};

export const filesIn = (folder, below = '') =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((one) => one.isFile())
    .map((one) => join(one.parentPath ?? one.path, one.name))
    .map((path) => ({ path: join(below, relative(folder, path)), bytes: readFileSync(path) }));
export const lay = (files, folder = work) => {
  for (const { path, bytes } of files) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), bytes);
  }
};
export const textOf = (files, path) => new TextDecoder().decode(files.find((file) => file.path === path)?.bytes ?? new Uint8Array());

// The bytes of the test of a measured bearing, or null if the folder of measured data beside the checkout lacks it.
const record = fileURLToPath(new URL('../../../../shared/data/hdrb-gallardo-device/cyclic-24-49-98pct.csv', import.meta.url));
export const bearing = existsSync(record) ? readFileSync(record) : null;
