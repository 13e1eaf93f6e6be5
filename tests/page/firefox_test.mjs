// Tests the page in Firefox: opens its file, chooses records, looks at their properties, identifies laws and saves
// everything.
//   node firefox_test.mjs PAGE.html ISOLAW [FIREFOX]
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Firefox } from './firefox.mjs';

const [file, isolaw, program = '/usr/bin/firefox-esr'] = process.argv.slice(2);
if (!existsSync(program)) {
  console.log('skipped: no Firefox found (install firefox-esr)');
  process.exit(77);
}
const work = mkdtempSync(join(tmpdir(), 'isolaw-firefox-test-')),
  downloads = join(work, 'downloads'),
  example = join(work, 'example');
mkdirSync(downloads);
execFileSync(isolaw, ['example', example], { stdio: 'ignore' });
const records = readdirSync(example).filter((one) => one.startsWith('device-')).sort().map((one) => join(example, one));
copyFileSync(fileURLToPath(new URL('../../page/zip.js', import.meta.url)), join(work, 'zip.mjs'));
const { readZip } = await import(pathToFileURL(join(work, 'zip.mjs')).href);

const failures = [];
const expect = (holds, what) => {
  if (!holds) {
    failures.push(what);
    console.log('  FAILED ' + what);
  }
};
const browser = await Firefox.start(program, downloads);
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const press = (id) => browser.evaluate(`document.getElementById(${JSON.stringify(id)}).click()`);
const idle = () => browser.until("(document.body.dataset.busy ?? '0') === '0'", 'the page to be idle');
const type = async (id, value) => {
  await browser.evaluate(`(() => { const it = document.getElementById(${JSON.stringify(id)}); it.value = ${JSON.stringify(value)}; it.dispatchEvent(new Event('change', { bubbles: true })); })()`);
  await idle();
};
const saved = async (ending) => {
  for (let i = 0; i < 600; ++i) {
    const name = readdirSync(downloads).find((one) => one.endsWith(ending));
    if (name && !existsSync(join(downloads, name + '.part')) && readFileSync(join(downloads, name)).length > 0) return join(downloads, name);
    await wait(100);
  }
  throw new Error('nothing was saved that ends in ' + ending);
};
try {
  // The page is timed three times, and the shortest time is judged, because other work on the machine can only slow the
  // page.
  const times = [];
  for (let i = 0; i < 3; ++i) {
    const start = Date.now();
    await browser.send('browsingContext.navigate', { context: browser.context, url: pathToFileURL(file).href, wait: 'complete' });
    await browser.until("document.body.dataset.ready === ''", 'the page to be ready', 60);
    times.push((Date.now() - start) / 1000);
  }
  console.log('ready in ' + times.map((time) => time.toFixed(2)).join(', ') + ' s');
  expect(Math.min(...times) < 3, 'ready in ' + times);

  await browser.setFiles('#pick', records);
  await browser.until("document.querySelectorAll('#devices tr.device').length === 10", 'ten devices');
  await idle();
  expect((await browser.evaluate("document.querySelector('#read-band .word').textContent")).startsWith('10'), 'all are read');
  await press('show-properties');
  await browser.until("document.querySelectorAll('.plot .main-svg').length > 0 && 'none' + document.body.dataset.errors === 'none'", 'the inspection drawn in its frame', 60, () => browser.frame());
  await press('show-laws');
  await press('laws-some');
  await idle();
  for (const id of await browser.evaluate("[...document.querySelectorAll('.options.laws input:checked')].map(({ id }) => id)"))
    if (id !== 'law-bilinear') {
      await press(id);
      await idle();
    }
  await type('runs', '1');
  await type('analysis', 'none');
  await press('identify');
  await browser.until("document.getElementById('report-frame') || !document.getElementById('failure').hidden", 'the report', 300);
  expect((await browser.evaluate("document.getElementById('failure').hidden")) === true, 'no failure: ' + (await browser.evaluate("document.getElementById('failure').textContent")));
  await browser.until("document.querySelectorAll('.plot .main-svg').length > 0 && 'none' + document.body.dataset.errors === 'none'", 'the report drawn in its frame', 60, () => browser.frame());
  await press('show-save');
  await press('save-summary-json');
  const summary = JSON.parse(readFileSync(await saved('summary.json'), 'utf8'));
  expect(summary.laws.length === 1 && summary.laws[0].objective.mean > 0, 'the summary');
  await press('save-whole');
  const whole = await saved('.isolaw.zip');
  expect((await readZip(new Uint8Array(readFileSync(whole)))).some(({ path }) => path === 'out/campaign.sqlite'), 'the campaign as one file');

  // The page is opened again, and the user chooses the saved campaign. The page must show its report.
  await browser.send('browsingContext.navigate', { context: browser.context, url: 'about:blank', wait: 'complete' }).catch(() => {});
  await browser.send('browsingContext.handleUserPrompt', { context: browser.context, accept: true }).catch(() => {});
  await browser.send('browsingContext.navigate', { context: browser.context, url: pathToFileURL(file).href, wait: 'complete' });
  await browser.until("document.body.dataset.ready === ''", 'the page anew', 60);
  await browser.setFiles('#pick', [whole]);
  await browser.until("document.getElementById('report-frame')", 'the report again');
  await browser.until("document.querySelectorAll('.plot .main-svg').length > 0", 'the report drawn again', 60, () => browser.frame());

  // The user starts a long identification and then cancels it.
  await press('change');
  await press('laws-all');
  await idle();
  await type('runs', '20');
  await press('identify');
  await browser.until("document.getElementById('progress-bar')", 'progress');
  await wait(1500);
  const took = await browser.evaluate("new Promise((done) => { const start = performance.now(); document.getElementById('cancel').click(); const look = () => (document.getElementById('progress-bar') ? setTimeout(look, 5) : done(performance.now() - start)); look(); })");
  console.log('cancelled in ' + Math.round(took) + ' ms');

  expect(browser.errors.length === 0, 'errors on the console: ' + browser.errors);
  const asked = browser.requests.filter((url) => !/^(blob|data|about):/.test(url) && url !== pathToFileURL(file).href);
  expect(asked.length === 0, 'requests: ' + asked);
  expect((await browser.evaluate('document.body.dataset.errors')) === '', 'errors in the page');
} catch (error) {
  expect(false, error.stack + '\n' + browser.errors.join('\n') + '\n' + (await browser.evaluate('document.body.innerText').catch(() => '')).slice(0, 2000));
} finally {
  await browser.close();
  rmSync(work, { recursive: true, force: true });
}
console.log(failures.length === 0 ? 'all hold' : failures.length + ' do not hold');
process.exit(failures.length === 0 ? 0 : 1);
