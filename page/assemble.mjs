// Joins the sources of the page into one HTML file that needs no other file.
//   node assemble.mjs --out isolaw.html --cmake cmake --engine DIR [--engine-html FILE] [--report FILE.html]...
// --engine: a folder with engine.js and the modules that it imports. Tests give tests/page/stand_in in place of
// page/engine.
// --engine-html: HTML elements that embed.mjs wrote. They hold the program as data, which engine.js reads.
// --report: sample reports. The page's security policy applies to its frames too. It allows only the page's own scripts
// and scripts with the same hashes as those of the sample reports.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cpSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url)),
  root = dirname(here),
  reports = 'src/isolaw/render/page';
const options = { cmake: ['cmake'], report: [], 'engine-html': [] };
for (let i = 2; i < process.argv.length; i += 2) (options[process.argv[i].slice(2)] ??= []).push(process.argv[i + 1]);
const one = (name) => options[name]?.at(-1);

// Returns the texts of all scripts that a browser runs. A <script> with an attribute `type` holds only data here.
const scriptsOf = (html) => [...html.matchAll(/<script(?![^>]*\btype=)[^>]*>([\s\S]*?)<\/script>/g)].map(([, script]) => script);
const hash = (script) => "'sha256-" + createHash('sha256').update(script, 'utf8').digest('base64') + "'";

// Joins into one script: the modules of the page, those of the engine, and those modules of the reports that the page
// imports.
function joined() {
  const folder = mkdtempSync(join(tmpdir(), 'isolaw-page-'));
  const copy = (from, to) => cpSync(from, join(folder, to), { recursive: true, filter: (file) => statSync(file).isDirectory() || file.endsWith('.js') });
  try {
    copy(here, 'page');
    rmSync(join(folder, 'page/engine'), { recursive: true });
    copy(one('engine'), 'page/engine');
    copy(join(root, reports, 'script'), reports + '/script');
    const entries = ['page/main.js', reports + '/script/page.js', reports + '/script/building.js'];
    const output = join(folder, 'joined');
    execFileSync(one('cmake'), ['-D', 'FOLDER=' + folder, '-D', 'ENTRY=' + entries[0], '-D', 'ENTRIES=' + entries, '-D', 'OUTPUT=' + output, '-P', join(root, 'cmake/join_modules.cmake')], { stdio: ['ignore', 'ignore', 'inherit'] });
    return readFileSync(output, 'utf8');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const asset = (name) => readFileSync(join(root, reports, 'assets', name), 'utf8');
const contents = {
  errors: asset('errors.js'),
  style: asset('page.css') + readFileSync(join(here, 'style.css'), 'utf8'),
  engine: options['engine-html'].map((file) => readFileSync(file, 'utf8')).join('\n'),
  script: joined(),
  policy: '{{policy}}',
};
const page = readFileSync(join(here, 'index.html'), 'utf8').replace(/\{\{(\w+)\}\}/g, (_, name) => contents[name]);
const frame = /<script type="text\/plain" id="isolaw-frame">([\s\S]*?)<\/script>/.exec(page)[1];
const allowed = new Set([...scriptsOf(page), frame, ...options.report.flatMap((file) => scriptsOf(readFileSync(file, 'utf8')))].map(hash));
const policy = [
  "default-src 'none'",
  "script-src 'wasm-unsafe-eval' " + [...allowed].join(' '),
  "style-src 'unsafe-inline'",
  'img-src data: blob:',
  'worker-src blob:',
  'frame-src blob:',
  "connect-src 'none'",
  "form-action 'none'",
  "base-uri 'none'",
].join('; ');
// Replaces only the first {{policy}} in the page. Scripts that contain the same text must keep it.
writeFileSync(one('out'), page.replace('{{policy}}', () => policy));
