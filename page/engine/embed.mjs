// Writes the compiled program as HTML elements for the body of the page. They are <script> elements that hold data, so
// that browsers do not run them.
//   node embed.mjs --script isolaw.js --program isolaw.wasm --libraries DIR --out FILE
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const options = {};
for (let i = 2; i < process.argv.length; i += 2) options[process.argv[i].slice(2)] = process.argv[i + 1];

// Escapes `<!--` and `</script` as cmake/join_modules.cmake does, so that they do not end the <script> element.
const inline = (script) => script.replace(/<(?=!--|\/sc)/gi, '<\\');
const versions = new Map(
  readFileSync(join(options.libraries, 'versions'), 'utf8')
    .trim()
    .split('\n')
    .map((line) => line.split(' ')),
);
const called = { bearssl: 'BearSSL', 'libboost1.74-dev': 'Boost', 'libcli11-dev': 'CLI11', 'libeigen3-dev': 'Eigen', 'libfmt-dev': '{fmt}', 'librandom123-dev': 'Random123', 'libtomlplusplus-dev': 'toml++', 'nlohmann-json3-dev': 'JSON for Modern C++', emscripten: 'Emscripten (musl, libc++)', expat: 'Expat', sqlite3: 'SQLite' };
const packages = readdirSync(join(options.libraries, 'licences'));
const licences = packages.map((name) => {
  const text = readFileSync(join(options.libraries, 'licences', name), 'utf8');
  // A copyright file may state several licences. `licence` is the name of the first one; `text` has all of them.
  const licence = /^License: *(\S[^\n]*)/m.exec(text)?.[1].trim() ?? '';
  return { name: called[name] ?? name, version: versions.get(name) ?? '', licence, text };
});
// Plotly draws the figures of reports. It comes from npm, and the folder of libraries does not have it.
const plotly = join(here, '../../node_modules/plotly.js-basic-dist-min');
const { version, license } = JSON.parse(readFileSync(join(plotly, 'package.json'), 'utf8'));
licences.push({ name: 'Plotly', version, licence: license, text: readFileSync(join(plotly, 'LICENSE'), 'utf8') });
const facts = JSON.stringify({ licences }).replaceAll('<', '\\u003c');
const element = (id, type, text) => `<script type="${type}" id="${id}">${text}</script>\n`;
writeFileSync(
  options.out,
  element('isolaw-facts', 'application/json', facts) +
    element('isolaw-worker', 'text/plain', inline(readFileSync(options.script, 'utf8') + '\n' + readFileSync(join(here, 'worker.cjs'), 'utf8'))) +
    element('isolaw-program', 'text/plain', gzipSync(readFileSync(options.program), { level: 9 }).toString('base64')),
);
