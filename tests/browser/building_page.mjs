// Opens the page of a made-up building in headless Chromium. There must be no script error and no request to the
// network. Every figure must be drawn and must follow the reader's choices, the page must fit into its window, and the
// verdict must appear without scrolling and after few words. The test also checks the printed page and the rules of
// axe-core, and compares the page in other units with the page in kN and mm.
//   node building_page.mjs MAKE_BUILDING [CHROMIUM]
// ISOLAW_SCREENSHOTS=DIR saves a picture of every case. With ISOLAW_BUILDING_PAGE=FILE the test opens that page
// instead.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';
import { compareUnits, shownInUnits } from './other_units.mjs';

const [makeBuilding, program] = process.argv.slice(2);
if (!program || !existsSync(program)) {
  console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
  process.exit(77);
}

const CASES = [
  { name: 'laptop', laws: 2, width: 1366, height: 768 },
  { name: 'laptop-dark', laws: 2, width: 1366, height: 768, dark: true },
  { name: 'phone', laws: 2, width: 390, height: 844 },
  { name: 'phone-dark', laws: 1, width: 390, height: 844, dark: true },
  { name: 'one-law', laws: 1, width: 1366, height: 768 },
  { name: 'print', laws: 2, width: 681, height: 900, print: true },
];
const MOST_WORDS = 165;

// Scrolls to every figure, uses the page's controls and returns what the page then showed. This function runs in the
// page.
async function look({ print }) {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const data = JSON.parse(document.getElementById('isolaw-data').textContent);
  const words = [];
  const walker = document.createTreeWalker(document.body, 4);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (/^(SCRIPT|STYLE|OPTION)$/.test(node.parentNode.nodeName) || node.parentNode.closest('.plot, .units, noscript, .skip')) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    const box = range.getBoundingClientRect();
    if (box.width > 0 && box.top < window.innerHeight) words.push(...node.textContent.split(/\s+/).filter((word) => /\w/.test(word)));
  }
  if (print) {
    dispatchEvent(new Event('beforeprint'));
    await wait(800);
  }
  for (const figure of document.querySelectorAll('figure')) {
    figure.scrollIntoView();
    await wait(80);
  }
  await wait(200);
  const undrawn = [...document.querySelectorAll('.plot')].filter((plot) => !plot.querySelector('.main-svg')).map((plot) => plot.parentNode.id);
  const empty = [...document.querySelectorAll('figure')].filter((figure) => figure.getBoundingClientRect().height < 10).map(({ id }) => id);
  const cut = [...document.querySelectorAll('.plot')].flatMap((plot) => {
    const frame = plot.getBoundingClientRect();
    return [...plot.querySelectorAll('text')]
      .filter((text) => text.textContent && text.getBoundingClientRect().width > 0 && !text.closest('.modebar'))
      .filter((text) => text.getBoundingClientRect().left < frame.left - 2 || text.getBoundingClientRect().right > frame.right + 2)
      .map((text) => plot.parentNode.id + ': ' + text.textContent);
  });
  // The width is measured before a control is used, because a printed page has no controls.
  const wide = [document.documentElement.scrollWidth, window.innerWidth];
  const axis = () => document.querySelector('#figure-histograms .xtitle')?.textContent;
  const before = axis();
  const select = document.getElementById('quantity');
  document.getElementById('figure-histograms').scrollIntoView();
  select.value = 'drift_mm';
  select.dispatchEvent(new Event('change'));
  await wait(300);
  const after = axis();
  const followed = document.getElementById('quantity-of-variance').value;
  select.value = 'isolator_mm';
  select.dispatchEvent(new Event('change'));
  await wait(200);
  // The figure of a loop shows one bearing. The reader chooses it from a list or by a click on a bearing in the plan.
  const loopOf = () => document.querySelector('#figure-loops figcaption').textContent;
  document.getElementById('figure-loops').scrollIntoView();
  await wait(200);
  const loops = [loopOf()];
  const bearing = document.getElementById('bearing');
  bearing.value = '2';
  bearing.dispatchEvent(new Event('change'));
  await wait(200);
  loops.push(loopOf());
  document.querySelector('#figure-plan .plot').emit('plotly_click', { points: [{ customdata: 4 }] });
  await wait(200);
  loops.push(loopOf(), bearing.value);
  const count = (id, kind) => document.querySelectorAll('#figure-' + id + ' ' + kind).length;
  const text = document.body.innerText;
  window.scrollTo(0, 0);
  return {
    words: words.length, loops, undrawn, empty, cut, before, after, followed, wide,
    said: document.querySelector('#figure-verdict .headline').textContent,
    verdict: data.answer.filter(({ kind }) => kind.startsWith('building-holds')).map((one) => one.sentence).join(' '),
    laws: data.laws.length,
    histograms: count('histograms', '.bars'),
    bearings: count('plan', '.scatterlayer .point'), places: data.plan.bearings.length,
    rows: count('coverage', 'tbody tr'),
    title: document.getElementById('title').textContent, wanted: data.title,
    alive: document.querySelectorAll('img').length, motion: text.includes(data.motions[data.motions.length - 1].name),
    errors: document.body.dataset.errors,
    height: document.documentElement.scrollHeight,
  };
}

// If axe-core is installed, the page must not break its rules.
const axe = fileURLToPath(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url));
const violations = `window.axe.run(document, { resultTypes: ['violations'] }).then(({ violations: found }) =>
  found.map(({ id, nodes }) => id + ': ' + nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(' | ')))`;

const directory = mkdtempSync(join(tmpdir(), 'isolaw-building-')),
  browser = new Chromium(program),
  failures = [],
  written = new Map(),
  given = process.env.ISOLAW_BUILDING_PAGE,
  pictures = process.env.ISOLAW_SCREENSHOTS;
try {
  for (const one of CASES) {
    const expect = (holds, what) => holds || failures.push(`${one.name}: ${what}`);
    if (!given && !written.has(one.laws)) {
      const out = join(directory, String(one.laws));
      execFileSync(makeBuilding, [out, String(one.laws)], { stdio: ['ignore', 'ignore', 'inherit'] });
      written.set(one.laws, join(out, 'building.html'));
    }
    const page = await browser.open(pathToFileURL(given ?? written.get(one.laws)).href, one);
    if (one.print) await page.send('Emulation.setEmulatedMedia', { media: 'print' });
    await page.evaluate('new Promise((done) => setTimeout(done, 400))');
    const seen = await page.evaluate(`(${look})(${JSON.stringify(one)})`);
    expect(page.errors.length === 0 && seen.errors === '', 'errors: ' + page.errors.join('; ') + seen.errors);
    expect(page.requests.length === 0, 'requests: ' + page.requests.join(', '));
    expect(seen.undrawn.length === 0, 'not drawn: ' + seen.undrawn.join(', '));
    expect(seen.empty.length === 0, 'empty: ' + seen.empty.join(', '));
    expect(seen.cut.length === 0, 'text beyond its figure: ' + seen.cut.join('; '));
    expect(seen.wide[0] <= seen.wide[1], 'page of ' + seen.wide.join(' in a window of '));
    expect(one.print || seen.words <= MOST_WORDS, seen.words + ' words before the first scroll');
    expect(seen.said.replace(/\s/g, ' ') === seen.verdict, 'says "' + seen.said + '"');
    expect(seen.histograms === seen.laws, seen.histograms + ' histograms of ' + seen.laws + ' laws');
    expect(seen.bearings === seen.places + 1, seen.bearings + ' marks in plan of ' + seen.places + ' bearings and the centre');
    expect(seen.rows === 11 * seen.laws, seen.rows + ' rows of coverage');
    expect(seen.before !== seen.after && /drift/.test(seen.after) && seen.followed === 'drift_mm', 'the choice of a quantity is not followed');
    expect(/^Bearing 6 at/.test(seen.loops[0]) && /^Bearing 3 at/.test(seen.loops[1]) && /^Bearing 5 at/.test(seen.loops[2]) && seen.loops[3] === '4', 'loops of ' + seen.loops.join('; '));
    expect(seen.title === seen.wanted && seen.alive === 0 && seen.motion, 'names of the input are not text');
    if (!one.print && existsSync(axe)) {
      await page.evaluate(readFileSync(axe, 'utf8') + ';0');
      for (const violation of await page.evaluate(violations)) expect(false, violation);
    }
    if (pictures) {
      mkdirSync(pictures, { recursive: true });
      await page.send('Emulation.setDeviceMetricsOverride', { width: one.width, height: seen.height, deviceScaleFactor: 1, mobile: one.width < 500 });
      await page.evaluate('new Promise((done) => setTimeout(done, 600))');
      const { data } = await page.send('Page.captureScreenshot', { format: 'png' });
      writeFileSync(join(pictures, 'building-' + one.name + '.png'), Buffer.from(data, 'base64'));
    }
    await page.close();
  }
  const url = pathToFileURL(given ?? written.get(2)).href;
  // A link of the table of contents must keep the units that stand in the address. If the user chooses other units, the
  // page must load again with them.
  const page = await browser.open(url + '#verdict?units=kip-in', CASES[0]);
  const address = await page.evaluate("document.querySelector('#contents a:nth-child(3)').click(); new Promise((done) => setTimeout(() => done(location.hash), 100))");
  if (address !== '#spread?units=kip-in') failures.push('after a link of the contents the address is ' + address);
  await page.evaluate("document.querySelector('.units [value=N-m]').click()");
  let units = '';
  for (let i = 0; i < 100 && units !== '#spread?units=N-m N-m'; ++i) {
    await new Promise((done) => setTimeout(done, 50));
    // While the page loads, evaluate() fails and the text stays empty.
    units = await page.evaluate("location.hash + ' ' + document.querySelector('.units [aria-pressed=true]').value").catch(() => '');
  }
  if (units !== '#spread?units=N-m N-m') failures.push('after N-m was pressed the page shows ' + units);
  await page.close();
  const stored = await shownInUnits(browser, url, 'kN-mm');
  for (const units of ['N-m', 'kip-in']) {
    const { compared, failures: contradictions } = compareUnits(stored, await shownInUnits(browser, url, units), units);
    failures.push(...contradictions);
    if (compared < 200) failures.push(`only ${compared} numbers were compared in ${units}`);
  }
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
process.exit(failures.length === 0 ? 0 : 1);
