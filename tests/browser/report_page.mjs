// Opens the made-up lot's report in headless Chromium and fails on what a reader would stumble over: script errors,
// figures that are not drawn, a page wider than its window, a request to the network, markup of the input coming alive.
//   node report_page.mjs MAKE_PAGE [CHROMIUM]
// ISOLAW_SCREENSHOTS=DIR keeps a picture of every case, page by page, and its PDF.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';

const [makePage, program] = process.argv.slice(2);
if (!program || !existsSync(program)) {
  console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
  process.exit(77);
}

const CASES = [
  { name: 'laptop', devices: 3, laws: 3, width: 1366, height: 768 },
  { name: 'dark', devices: 10, laws: 7, width: 1366, height: 768, dark: true },
  { name: 'phone', devices: 10, laws: 7, width: 390, height: 844 },
  { name: 'one-device', devices: 1, laws: 7, width: 1366, height: 768 },
  { name: 'large-lot', devices: 160, laws: 7, width: 1366, height: 768 },
];
const FIRST_SCREEN_MS = 2000;

// Runs in the page. Scrolls through it as a reader does and tries the controls; says what it saw.
async function look() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (condition) => {
    for (let i = 0; i < 100 && !condition(); ++i) await wait(30);
  };
  const isDrawn = (plot) => plot.querySelector('svg.main-svg .trace') !== null;
  const plots = [...document.querySelectorAll('.plot')];
  const drawnAtFirst = plots.filter(isDrawn).length;
  for (const plot of plots) {
    plot.scrollIntoView();
    await until(() => isDrawn(plot));
  }
  const drawn = plots.filter(isDrawn).length;
  const fitting = plots.filter(
    (plot) => plot.querySelector('svg.main-svg')?.getBoundingClientRect().width === plot.clientWidth,
  ).length;
  const titles = () =>
    plots.map((plot) => plot.querySelector('.main-svg')?.textContent ?? '').join('|') +
    document.querySelector('#figure-loop figcaption')?.textContent;
  const before = titles();
  for (const details of document.querySelectorAll('details')) details.open = true;
  for (const select of document.querySelectorAll('select')) {
    select.selectedIndex = select.options.length - 1;
    select.dispatchEvent(new Event('change'));
  }
  for (const box of document.querySelectorAll('input[type=checkbox]')) box.click();
  await wait(300);
  for (const button of document.querySelectorAll('button.csv')) button.click();
  await wait(100);
  // Only tables and the contents may be wider than the page, inside their own scroller.
  const width = document.documentElement.clientWidth;
  const wide = [...document.querySelectorAll('body *')].filter(
    (node) => !node.closest('.scroll, nav, .skip, svg') && node.getBoundingClientRect().right > width + 1,
  );
  return {
    plots: plots.length,
    drawnAtFirst,
    drawn,
    fitting,
    controlsDoSomething: titles() !== before,
    errors: document.body.dataset.errors,
    uncaptioned: [...document.querySelectorAll('figcaption')].filter((caption) => caption.textContent.trim() === '')
      .length,
    tables: document.querySelectorAll('table').length,
    wide: wide.slice(0, 3).map((node) => node.tagName + ' ' + node.className),
    scrolls: document.documentElement.scrollWidth > width,
    images: document.querySelectorAll('img').length,
    nastyName: document.body.innerText.includes('<img src=x onerror=alert(1)>'),
    unlabelled: [...document.querySelectorAll('select, input')].filter((control) => control.labels.length === 0).length,
    paper: getComputedStyle(document.body).backgroundColor,
  };
}

const failures = [];
function expect(holds, name, what) {
  if (!holds) failures.push(`${name}: ${what}`);
}

async function photograph(page, { name, width, height }, directory) {
  await page.evaluate('scrollTo(0, 0)');
  const length = Math.min(await page.evaluate('document.documentElement.scrollHeight'), 20000);
  for (let top = 0, part = 1; top < length; top += 2 * height, ++part) {
    await page.evaluate(`scrollTo(0, ${top}); new Promise((done) => setTimeout(done, 300))`);
    const { data } = await page.send('Page.captureScreenshot', {
      captureBeyondViewport: true,
      clip: { x: 0, y: top, width, height: Math.min(2 * height, length - top), scale: 1 },
    });
    writeFileSync(join(directory, `${name}-${String(part).padStart(2, '0')}.png`), Buffer.from(data, 'base64'));
  }
}

async function check(browser, directory, one) {
  const { name, devices, laws, dark } = one;
  const out = join(directory, name);
  execFileSync(makePage, [out, String(devices), String(laws)], { stdio: ['ignore', 'ignore', 'inherit'] });
  const page = await browser.open(pathToFileURL(join(out, 'report.html')).href, one);
  await page
    .send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: join(out, 'downloads') })
    .catch(() => {});
  const firstScreen = await page.evaluate(`new Promise((done) => {
    const look = () => document.querySelector('.plot svg.main-svg .trace') ? done(performance.now()) : setTimeout(look, 20);
    look();
  })`);
  const pictures = process.env.ISOLAW_SCREENSHOTS;
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await photograph(page, one, pictures);
  }
  const seen = await page.evaluate(`(${look})()`);
  console.log(name, JSON.stringify({ firstScreen: Math.round(firstScreen), ...seen }));

  expect(page.errors.length === 0 && seen.errors === '', name, 'errors: ' + [...page.errors, seen.errors].join('; '));
  expect(page.requests.length === 0, name, 'requested ' + page.requests.join(', '));
  expect(seen.plots === 5 && seen.drawn === 5, name, `${seen.drawn} of ${seen.plots} figures drawn, 5 expected`);
  expect(seen.fitting === seen.plots, name, `${seen.plots - seen.fitting} figures do not fill their place`);
  expect(seen.controlsDoSomething, name, 'choosing another device and other laws changed nothing');
  expect(seen.uncaptioned === 0, name, 'a caption is empty');
  expect(!seen.scrolls && seen.wide.length === 0, name, 'wider than the window: ' + seen.wide.join(', '));
  expect(seen.images === 0 && seen.nastyName, name, 'a name from the input is not shown as text');
  expect(seen.unlabelled === 0, name, 'a control has no label');
  expect(seen.paper === (dark ? 'rgb(20, 25, 29)' : 'rgb(255, 255, 255)'), name, 'paper is ' + seen.paper);

  // Printed: light whatever the screen, nothing cut off at the right edge of the paper.
  await page.send('Emulation.setDeviceMetricsOverride', {
    width: 681,
    height: 960,
    deviceScaleFactor: 1,
    mobile: false,
  }); // 180 mm
  await page.send('Emulation.setEmulatedMedia', { media: 'print' });
  const cut = await page.evaluate(`(async () => {
    dispatchEvent(new Event('beforeprint'));
    await new Promise((done) => setTimeout(done, 500));
    return [...document.querySelectorAll('main *')].filter((node) => !node.closest('svg') && node.getClientRects().length > 0
      && node.getBoundingClientRect().right > 684).slice(0, 3).map((node) => node.tagName + ' ' + node.className + ' ' + node.textContent.slice(0, 30));
  })()`);
  expect(cut.length === 0, name, 'cut off on paper: ' + cut.join(', '));
  if (pictures) {
    await photograph(page, { name: name + '-print', width: 681, height: 960 }, pictures);
    const { data } = await page.send('Page.printToPDF', { preferCSSPageSize: true, printBackground: true });
    writeFileSync(join(pictures, name + '.pdf'), Buffer.from(data, 'base64'));
  }
  await page.evaluate("dispatchEvent(new Event('afterprint'))");
  await page.close();
  return firstScreen;
}

const directory = mkdtempSync(join(tmpdir(), 'isolaw-browser-'));
const browser = new Chromium(program);
try {
  for (const one of CASES) {
    const firstScreen = await check(browser, directory, one);
    if (firstScreen > FIRST_SCREEN_MS)
      console.log(`note: ${one.name} took ${Math.round(firstScreen)} ms to its first figure`); // never a failure: machines differ
  }
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
if (failures.length === 0) console.log('the report opens, draws, fits and prints in every case');
process.exit(failures.length === 0 ? 0 : 1);
