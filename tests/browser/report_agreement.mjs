// Compares the numbers that different views of one report show of the same thing. No view may contradict another, in
// whichever units the page shows. The report is that of `isolaw example --tests`. The force of one of its five bearings
// is clipped at the largest amplitude, and another bearing fails.
//   node report_agreement.mjs ISOLAW CHROMIUM
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';
import { compareUnits, shownInUnits } from './other_units.mjs';

const [isolaw, program] = process.argv.slice(2);
if (!program) {
  console.log('skipped: no Chromium found (install chromium)');
  process.exit(77);
}

const failures = [];
let compared = 0;

// Returns the number that a text shows, and half a unit of its last digit. Zeros at the end of a whole number may be
// rounded.
function read(text) {
  const [number] = text.replace(/\u2212/g, '-').match(/-?\d+(\.\d+)?/) ?? [];
  if (number === undefined) return null;
  const last = number.includes('.') ? -number.split('.')[1].length : number.match(/0*$/)[0].length;
  return { value: Number(number), half: 0.5 * 10 ** last };
}
// The numbers that `views` show of one thing must be the same number with more or fewer digits.
function agree(about, views) {
  const shown = Object.entries(views).map(([view, text]) => ({ view, text, ...read(text ?? '') }));
  for (const { view, text, value } of shown) if (value === undefined) failures.push(`${about}: ${view} shows no number: ${text}`);
  const [first, ...others] = shown;
  for (const other of others) {
    ++compared;
    if (!(Math.abs(first.value - other.value) <= (first.half + other.half) * 1.001))
      failures.push(`${about}: ${first.view} shows ${first.text}, ${other.view} ${other.text}`);
  }
}
function same(about, views) {
  ++compared;
  if (new Set(Object.values(views)).size > 1) failures.push(`${about}: ${JSON.stringify(views)}`);
}

// Returns the texts of the views. This function runs in the page.
async function texts() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const all = (selector) => [...document.querySelectorAll(selector)];
  const text = (node) => node?.textContent.trim() ?? null;
  const column = (table, title) => [...table.tHead.rows[0].cells].findIndex((cell) => text(cell).startsWith(title));
  const rows = (figure) => {
    const table = document.querySelector('#figure-' + figure + ' table');
    return [...table.tBodies[0].rows].map((row) => (title) => row.cells[column(table, title)]);
  };
  const value = (cell) => text(cell?.firstChild);
  const devices = {};
  const of = (name) => (devices[name] ??= { K_eff: {}, damping: {} });
  for (const cell of rows('certificate-devices')) {
    const name = text(cell('Device'));
    if (!/\d/.test(value(cell('Keff')))) continue;
    of(name).K_eff.certificate = value(cell('Keff'));
    of(name).damping.certificate = value(cell('damping'));
  }
  const select = document.getElementById('certificate-of');
  select.scrollIntoView(); // only visible figures are drawn again
  await wait(100);
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    await wait(30);
    const page = document.querySelector('.device-page table');
    const sides = (quantity) => [...page.tBodies[0].rows].filter((row) => text(row.cells[0]).startsWith(quantity + ',')).map((row) => text(row.cells[1]));
    for (const [key, quantity] of [['K_eff', 'Keff'], ['damping', 'damping']]) {
      if (!sides(quantity).every((one) => /\d/.test(one))) continue; // the block that the rules judge is faulty
      const two = sides(quantity).map((one) => Number(one.match(/[\d.]+/)[0]));
      of(option.text)[key]['page of the device'] = ((two[0] + two[1]) / 2).toFixed(sides(quantity)[0].match(/\.(\d+)/)?.[1].length ?? 0);
    }
  }
  document.querySelector('#figure-verdict-table, #devices').scrollIntoView();
  const laws = rows('laws').map((cell) => ({ name: text(cell('Law')), fits: text(cell('Fits')), another: text(cell('Another device')), parameters: text(cell('Parameters')), remark: text(cell('Remark')) }));
  const ranking = Object.fromEntries(rows('ranking').map((cell) => [text(cell('Law').querySelector('b') ?? cell('Law')), { parameters: text(cell('parameters')) }]));
  const front = Object.fromEntries(all('#figure-verdicts li').map((item) => [text(item.querySelector('b')), text(item)]));
  return {
    devices,
    laws,
    ranking,
    front,
    headline: text(document.querySelector('#figure-answer h3, #figure-answer .headline, #figure-answer p')),
    answer: text(document.querySelector('#figure-answer')),
    facts: text(document.getElementById('facts')),
    numbers: all('#figure-answer .numbers > div').map((node) => [text(node.querySelector('span')), text(node.querySelector('b'))]),
    words: { masthead: text(document.querySelector('#facts .word')), band: text(document.querySelector('#figure-verdict .word')), certificate: text(document.querySelector('#figure-certificate-head .word')) },
    lot: rows('lot').map((cell) => [text(cell('Property')), text(cell('n')), text(cell('Smallest')), text(cell('Largest'))]),
  };
}

const directory = mkdtempSync(join(tmpdir(), 'isolaw-agreement-'));
const browser = new Chromium(program);
try {
  execFileSync(isolaw, ['example', 'tests', '--tests'], { cwd: directory, stdio: 'ignore' });
  try {
    execFileSync(isolaw, ['calibrate', 'tests/lot.toml', '--laws', 'bilinear,bouc-wen', '--figures', 'none', '--out', 'O'], { cwd: directory, stdio: 'ignore' });
  } catch (error) {
    if (error.status !== 1) throw error; // 1: a bearing fails, as it should
  }
  for (const units of ['kN-mm', 'N-m', 'kip-in']) {
    const page = await browser.open(pathToFileURL(join(directory, 'O/report.html')).href + '#decision?units=' + units, { width: 1366, height: 900 });
    const shown = await page.evaluate(`(${texts})()`);
    if (page.errors.length > 0) failures.push(units + ': ' + page.errors.join('; '));
    for (const [name, properties] of Object.entries(shown.devices)) for (const [key, views] of Object.entries(properties)) agree(`${units}, ${key} of ${name}`, views);
    const devices = Object.values(shown.devices);
    for (const [property, n, least, largest] of shown.lot) {
      const key = { Keff: 'K_eff', damping: 'damping' }[property.split(' ')[0]];
      if (!key) continue;
      const values = devices.map((device) => device[key].certificate).sort((a, b) => read(a).value - read(b).value);
      agree(`${units}, smallest ${key}`, { lot: least, certificate: values[0] });
      agree(`${units}, largest ${key}`, { lot: largest, certificate: values.at(-1) });
      same(`${units}, devices with ${key}`, { lot: n, certificate: String(values.length) });
    }
    same(units + ', the verdict', shown.words);
    const [taken] = shown.laws;
    same(units + ', the law taken', { table: taken.remark, remark: 'taken' });
    if (!shown.answer.includes(taken.name)) failures.push(`${units}: the answer does not name ${taken.name}: ${shown.answer}`);
    if (/dominated/.test(shown.front[taken.name] ?? '') && !/not dominated/.test(shown.front[taken.name])) failures.push(`${units}: the law taken is ${shown.front[taken.name]}`);
    agree(units + ', error on another device', { table: taken.another, answer: shown.answer.match(/not fitted to within ([\d.]+)/)[1] });
    for (const law of shown.laws) {
      same(`${units}, parameters of ${law.name}`, { laws: law.parameters, ranking: shown.ranking[law.name].parameters });
      agree(`${units}, error of ${law.name}`, { laws: law.fits, front: String(100 * read(shown.front[law.name].match(/OF ([\d.]+)/)[1]).value) });
    }
    same(units + ', devices used', { answer: Object.fromEntries(shown.numbers)['devices used'], masthead: '5 of 5' });
    if (!shown.facts.includes('5 devices')) failures.push(`${units}: the masthead says ${shown.facts}`);
    await page.close();
  }
  const url = pathToFileURL(join(directory, 'O/report.html')).href;
  const stored = await shownInUnits(browser, url, 'kN-mm');
  for (const units of ['N-m', 'kip-in']) {
    const other = compareUnits(stored, await shownInUnits(browser, url, units), units);
    compared += other.compared;
    failures.push(...other.failures);
  }
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
console.log(`${compared} pairs of numbers compared, ${failures.length} contradictions`);
process.exit(failures.length === 0 && compared > 1000 ? 0 : 1);
