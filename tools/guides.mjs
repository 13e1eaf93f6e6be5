#!/usr/bin/env node
// Runs the commands of the three guides (docs/guide), compares what they print with what the guides say that they print,
// and takes the pictures of the guides and of the README.
//   node tools/guides.mjs ISOLAW [CHROMIUM] [FOLDER]
//   ISOLAW    the program, such as build/release/cli/isolaw
//   CHROMIUM  the browser that takes the pictures (default /usr/bin/chromium)
//   FOLDER    where to work; it is kept. A guide that has a folder there is not run again: only its pictures are taken.
// The check of an export needs OpenSeesPy, which tools/opensees.sh installs into build/opensees. With two cores this takes
// ten minutes. The exit code is 1 if a command prints something else than its guide says, or if a page reports an error.
//
// In a guide, a line of a code block that begins with '$ ' is a command; it goes on in the next lines if it ends with '\' or
// has a here-document. The lines below it are what it prints: '...' alone stands for any lines, at the end of a line for
// the rest of the line.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Chromium } from '../tests/browser/chromium.mjs';
import { indexed } from './indexed_png.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const [isolaw, chromium = '/usr/bin/chromium', kept] = process.argv.slice(2);
if (!isolaw) {
  console.error('use: node tools/guides.mjs ISOLAW [CHROMIUM] [FOLDER]');
  process.exit(2);
}
const work = kept ? resolve(kept) : mkdtempSync(join(tmpdir(), 'isolaw-guides-'));
const path = [dirname(resolve(isolaw)), join(root, 'build/opensees/openseespy/bin'), process.env.PATH].join(delimiter);
let failures = 0;
const fail = (text) => {
  ++failures;
  console.log('FAILED ' + text);
};

// A picture shows a page from the top of the element `from` to the bottom of the element `to`. With `print` it shows
// the page as it is printed. With `height` it is cut off at this height.
const PICTURES = [
  { file: 'report.png', page: 'readme/out/report.html', height: 895 },
  { file: 'pictures/laboratory-loops.png', page: 'laboratory/out/first/inspection.html', from: '#figure-cycles', to: '#figure-cycles' },
  { file: 'pictures/laboratory-verdict.png', page: 'laboratory/out/tests/inspection.html', to: '#figure-lot-strips', height: 640 },
  { file: 'pictures/laboratory-certificate.png', page: 'laboratory/out/contract/inspection.html', print: true, to: '#figure-certificate-signature' },
  { file: 'pictures/laboratory-device.png', page: 'laboratory/out/contract/inspection.html', print: true, from: '.device-page:first-child', to: '.device-page:first-child' },
  { file: 'pictures/engineer-first-screen.png', page: 'engineer/out/lot/report.html', height: 895 },
  { file: 'pictures/engineer-one-law.png', page: 'engineer/out/lot/report.html', from: '#figure-lot-devices', to: '#figure-lot-devices' },
  { file: 'pictures/engineer-building.png', page: 'engineer/out/building/building.html', to: '#figure-moving' },
  { file: 'pictures/researcher-front.png', page: 'researcher/out/paper/report.html', from: '#front', to: '#figure-front, #figure-verdicts' },
  { file: 'pictures/researcher-published.png', page: 'researcher/out/paper/report.html', from: '#published', to: '#figure-published-statements' },
];

function bash(command, cwd) {
  const { status, stdout, stderr } = spawnSync('bash', ['-c', command], {
    cwd, encoding: 'utf8', maxBuffer: 1 << 28, env: { ...process.env, PATH: path, LC_ALL: 'C.UTF-8' },
  });
  return { status, printed: [stdout, stderr].map((text) => text.split('\n').map((line) => line.trimEnd())) };
}

// Returns the commands of a guide, each with the lines that it prints according to the guide.
function commandsOf(markdown) {
  const commands = [];
  for (const [, block] of markdown.matchAll(/^```\n(\$ [^]*?)^```$/gm)) {
    const lines = block.trimEnd().split('\n');
    while (lines.length > 0) {
      const command = [lines.shift().slice(2)];
      while (command.at(-1).endsWith('\\')) command.push(lines.shift());
      const end = /<<'(\w+)'/.exec(command.at(-1))?.[1];
      while (end && command.at(-1) !== end) command.push(lines.shift());
      const says = [];
      while (lines.length > 0 && !lines[0].startsWith('$ ')) says.push(lines.shift().trimEnd());
      commands.push({ command: command.join('\n'), says });
    }
  }
  return commands;
}

// Returns the first line of `says` that `printed` does not have in this order, or null.
function missing(says, printed) {
  let at = 0,
    anywhere = false;
  const same = (line, said) => (said.endsWith('...') ? line?.startsWith(said.slice(0, -3)) : line === said);
  for (const said of says) {
    if (said === '...') {
      anywhere = true;
      continue;
    }
    if (anywhere) while (at < printed.length && !same(printed[at], said)) ++at;
    if (!same(printed[at], said)) return said;
    ++at;
    anywhere = false;
  }
  return null;
}

// Returns the largest exit code of a command that is still right. isolaw ends with 1 if devices or limits fail, which a
// guide may show. It ends with 2 after an error, which is right only if the guide shows the error message.
const worst = (command, says) => (!/^isolaw /.test(command) ? 0 : says.some((line) => line.startsWith('isolaw: ')) ? 2 : 1);

function runGuide(name) {
  const folder = join(work, name);
  if (existsSync(folder)) return;
  mkdirSync(folder, { recursive: true });
  for (const { command, says } of commandsOf(readFileSync(join(root, 'docs/guide', name + '.md'), 'utf8'))) {
    console.log(`${name}: ${command.split('\n')[0]}`);
    const { status, printed } = bash(command, folder);
    if (status === null || status > worst(command, says)) fail(`${name}: exit code ${status}: ${command}\n${printed[1].slice(-5).join('\n')}`);
    const lacking = printed.map((stream) => missing(says, stream));
    if (lacking.every((line) => line !== null)) fail(`${name}: ${command}\n  does not print: ${lacking[0]}`);
  }
}

// Returns the part of the page that a picture shows. This function runs in the page.
function extent(from, to) {
  const boxes = (which) => {
    const nodes = [...document.querySelectorAll(which)];
    if (nodes.length === 0) throw new Error('the page has no ' + which);
    return nodes.map((node) => node.getBoundingClientRect());
  };
  const top = from ? Math.min(...boxes(from).map((box) => box.top)) : 0,
    bottom = to ? Math.max(...boxes(to).map((box) => box.bottom)) : window.innerHeight;
  return { top: top + window.scrollY, bottom: bottom + window.scrollY };
}

async function take(browser, { file, page: html, from, to, height, print }) {
  const size = print ? { width: 760, height: 1100 } : { width: 1366, height: height ?? 900 };
  const page = await browser.open(pathToFileURL(join(work, html)).href, size);
  const resize = async (tall) => {
    await page.send('Emulation.setDeviceMetricsOverride', { width: size.width, height: tall, deviceScaleFactor: print ? 1.5 : 1, mobile: false });
    await page.evaluate('new Promise((done) => setTimeout(done, 800))');
  };
  if (print) {
    await page.evaluate("window.print = () => {}; [...document.querySelectorAll('#certificate button')].find(({ textContent }) => /print/i.test(textContent)).click()");
    await page.send('Emulation.setEmulatedMedia', { media: 'print' });
    await page.evaluate("dispatchEvent(new Event('beforeprint'))");
  }
  // The page draws a figure only when it comes into view. The window is therefore made so tall that the whole picture
  // is in view.
  const read = () => page.evaluate(`(${extent})(${JSON.stringify(from)}, ${JSON.stringify(to)})`);
  await resize(size.height);
  if (to) {
    await resize(Math.ceil((await read()).bottom) + 40);
    await resize(Math.ceil((await read()).bottom) + 40);
  }
  const { top, bottom } = await read();
  const margin = print ? 2 : 16,
    y = from ? Math.max(0, top - margin) : 0,
    end = to ? bottom + margin : size.height;
  const { data } = await page.send('Page.captureScreenshot', {
    format: 'png',
    clip: { x: 0, y, width: size.width, height: Math.round(Math.min(end - y, height ?? Infinity)), scale: 1 },
  });
  if (page.errors.length > 0) fail(`${html}: ${page.errors.join('; ')}`);
  const small = indexed(Buffer.from(data, 'base64'));
  mkdirSync(dirname(join(root, 'docs', file)), { recursive: true });
  writeFileSync(join(root, 'docs', file), small);
  console.log(`docs/${file}: ${Math.round(small.length / 1000)} kB`);
  await page.close();
}

for (const guide of ['laboratory', 'engineer', 'researcher']) runGuide(guide);
if (!existsSync(join(work, 'readme'))) {
  mkdirSync(join(work, 'readme'), { recursive: true });
  bash('isolaw example tests --tests && isolaw calibrate tests/lot.toml --figures none --out out', join(work, 'readme'));
}
const browser = new Chromium(chromium);
try {
  for (const picture of PICTURES)
    if (existsSync(join(work, picture.page))) await take(browser, picture);
    else fail(`${picture.page}: the guide's commands did not write it`);
} finally {
  await browser.close();
}
if (!kept) rmSync(work, { recursive: true, force: true });
process.exit(failures > 0 ? 1 : 0);
