// Joins page/ into one HTML file that needs no other file.
//   node assemble.mjs --out isolaw.html --cmake cmake --engine DIR [--engine-html FILE] [--report FILE.html]...
// --engine: a folder with engine.js (and its imports), which replaces page/engine.
// --engine-html: elements for the body, above the script: scripts that hold only data, which the engine reads.
// --report: reports as the program writes them. Frames inherit the page's policy, which allows the page's own scripts
// and, by their hashes, the scripts of these reports, but no others.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url)),
  root = dirname(here);
const options = { cmake: ['cmake'], report: [], 'engine-html': [] };
for (let i = 2; i < process.argv.length; i += 2) (options[process.argv[i].slice(2)] ??= []).push(process.argv[i + 1]);
const one = (name) => options[name]?.at(-1);

// The text of the scripts that a browser runs, as it is written in HTML.
const scriptsOf = (html) => [...html.matchAll(/<script(?![^>]*\btype=)[^>]*>([\s\S]*?)<\/script>/g)].map(([, script]) => script);
const hash = (script) => "'sha256-" + createHash('sha256').update(script, 'utf8').digest('base64') + "'";
// Escapes the only sequences that end or change a <script>, as render/page/html.cpp does.
const inline = (script) => script.replace(/<(?=!--|\/s)/gi, '<\\');

function joined() {
  const folder = mkdtempSync(join(tmpdir(), 'isolaw-page-'));
  try {
    for (const file of readdirSync(here)) if (file.endsWith('.js')) cpSync(join(here, file), join(folder, file));
    mkdirSync(join(folder, 'engine'));
    for (const file of readdirSync(one('engine'))) if (file.endsWith('.js')) cpSync(join(one('engine'), file), join(folder, 'engine', file));
    const output = join(folder, 'joined');
    execFileSync(one('cmake'), ['-D', 'FOLDER=' + folder, '-D', 'ENTRY=main.js', '-D', 'OUTPUT=' + output, '-P', join(root, 'cmake/join_modules.cmake')], { stdio: ['ignore', 'ignore', 'inherit'] });
    return readFileSync(output, 'utf8');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const asset = (name) => readFileSync(join(root, 'src/isolaw/render/page/assets', name), 'utf8');
const contents = {
  errors: asset('errors.js'),
  style: asset('page.css') + readFileSync(join(here, 'style.css'), 'utf8'),
  engine: options['engine-html'].map((file) => readFileSync(file, 'utf8')).join('\n'),
  script: inline(joined()),
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
// Replaces only the first place: the same text within scripts must stay as it is.
writeFileSync(one('out'), page.replace('{{policy}}', () => policy));
