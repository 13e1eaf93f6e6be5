// Opens the page that `isolaw inspect` writes for the example of `isolaw conditions`, and compares its section on the
// conditions with the closed formulas of the example. A lot without conditions has no such section. Then it opens the
// report of a campaign for the bound laws, and the page of a lot whose devices do not agree with one another.
//   node conditions_page.mjs ISOLAW [CHROMIUM]
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expectAccessible, hasAxe } from './axe.mjs';
import { Chromium } from './chromium.mjs';

const [isolaw, program] = process.argv.slice(2);
if (!program || !existsSync(program)) {
  console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
  process.exit(77);
}

// Returns what the section on the conditions shows. This function runs in the page.
async function look() {
  const figure = (id) => document.getElementById('figure-conditions-' + id);
  const drawn = async (id) => {
    figure(id).scrollIntoView();
    for (let k = 0; k < 100 && !figure(id).querySelector('.main-svg'); ++k) await new Promise((done) => setTimeout(done, 100));
    return figure(id).querySelector('.plot').data;
  };
  const points = ({ x, y, line, mode }) => ({ x, y, mode, dash: line?.dash ?? null });
  const answer = figure('answer');
  const seen = {
    headline: answer.querySelector('.headline').textContent,
    bounds: [...answer.querySelectorAll('tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent)),
    said: answer.textContent,
    first: document.getElementById('conditions-device').value,
    loops: (await drawn('loops')).map(({ name }) => name),
    table: [...figure('factor-table').querySelectorAll('tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent)),
    bars: (await drawn('factors')).map(({ x, y, xaxis }) => ({ x, y, xaxis })),
    panels: (await drawn('panels')).filter(({ xaxis }) => xaxis === 'x').map(points),
    load: (await drawn('panels')).filter(({ xaxis }) => xaxis === 'x3').map(points),
    history: (await drawn('history')).map(({ x, y, xaxis }) => ({ x, y, xaxis })),
    levels: [...figure('matrix').querySelectorAll('dd')].map((row) => [...row.querySelectorAll('li')].map((one) => [...one.children].map((part) => part.textContent).join(': '))),
    wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  };
  const chooser = document.getElementById('conditions-device');
  chooser.scrollIntoView();
  await new Promise((done) => setTimeout(done, 300));
  chooser.value = 'P4';
  chooser.dispatchEvent(new Event('change'));
  await new Promise((done) => setTimeout(done, 300));
  seen.ofP4 = (await drawn('loops')).map(({ name }) => name);
  figure('panels').scrollIntoView();
  await new Promise((done) => setTimeout(done, 300));
  figure('panels').querySelector('.choice button:nth-child(2)').click();
  await new Promise((done) => setTimeout(done, 300));
  const energy = (await drawn('panels')).filter(({ xaxis }) => xaxis === 'x').map(points);
  seen.energyCold = energy.filter(({ mode, dash }) => mode === 'lines' && dash !== 'dot')[1].y[0];
  return seen;
}

// Returns the loops of the bound laws, each with its K_eff and its energy. This function runs in the page.
async function lookAtBoundLaws() {
  const figure = document.getElementById('figure-bound-laws');
  figure.scrollIntoView();
  for (let k = 0; k < 100 && !figure.querySelector('.main-svg'); ++k) await new Promise((done) => setTimeout(done, 100));
  const loops = figure.querySelector('.plot').data.map(({ name, x, y }) => {
    const [first, last] = [x.indexOf(Math.max(...x)), x.indexOf(Math.min(...x))];
    const energy = x.slice(1).reduce((sum, value, i) => sum + 0.5 * (y[i + 1] + y[i]) * (value - x[i]), 0);
    return [name, { K_eff: (y[first] - y[last]) / (x[first] - x[last]), energy }];
  });
  return { ...Object.fromEntries(loops), caption: figure.querySelector('figcaption').textContent };
}

// Returns the axis of the first panel, and the marks of the intervals that the ends of this axis cut off. This function
// runs in the page.
async function lookAtPanels() {
  const figure = document.getElementById('figure-conditions-panels');
  figure.scrollIntoView();
  for (let k = 0; k < 100 && !figure.querySelector('.main-svg'); ++k) await new Promise((done) => setTimeout(done, 100));
  const { data, layout } = figure.querySelector('.plot');
  const cut = data.filter(({ xaxis, marker }) => xaxis === 'x' && /triangle/.test(marker?.symbol?.[0]));
  return { range: layout.yaxis.range, cut: cut.flatMap(({ x, marker }) => x.map((at, i) => `${at}: ${marker.symbol[i]}`)), caption: figure.querySelector('figcaption').textContent };
}

const failures = [];
const directory = mkdtempSync(join(tmpdir(), 'isolaw-browser-')),
  browser = new Chromium(program);
try {
  const run = (...words) => {
    try {
      execFileSync(isolaw, words, { stdio: ['ignore', 'ignore', 'inherit'] });
    } catch (error) {
      if (error.status !== 1) throw error; // 1: a limit is not kept
    }
  };
  const open = (out, size, file = 'inspection.html') => browser.open(pathToFileURL(join(out, file)).href, size);
  const lot = join(directory, 'example'),
    out = join(directory, 'out');
  run('example', lot, '--conditions');
  run('inspect', join(lot, 'lot.toml'), '--out', out);
  for (const width of [1366, 390]) {
    const expect = (holds, what) => {
      if (!holds) failures.push(`at ${width}: ${what}`);
    };
    const near = (value, wanted, what, relative = 1e-5) =>
      expect(Math.abs(value - wanted) <= relative * Math.abs(wanted), `${what}: ${value}, wanted ${wanted}`);
    const page = await open(out, { width, height: 900 });
    const seen = await page.evaluate(`(${look})()`);
    expect(/0\.705.*1\.869/.test(seen.headline), seen.headline);
    expect(/0\.705.*extrapolated.*53\s%/.test(seen.bounds[0][1]) && /1\.869.*interpolated/.test(seen.bounds[0][2]), 'bounds ' + seen.bounds[0]);
    expect(!/NOT COVERED|ASSUMED/.test(seen.said), seen.said);
    expect(/P6 acceptance/.test(seen.said) && /NOT PERMITTED/.test(seen.said) && /\+27\.6\s%.*P2/.test(seen.said), seen.said);
    const [temperature] = seen.table;
    expect(/^1\.269interpolated on\s3\sdevices$/.test(temperature[1]) && /^0\.848extrapolated on\s3\sdevices$/.test(temperature[2]), 'table ' + temperature);
    expect(seen.table.length === 7 && /^1\.859/.test(seen.table[6][3]), 'table ' + seen.table[6]);
    expect(seen.first === 'P1' && seen.loops.length === 4 && seen.loops.at(-1) === 'reference', `loops of ${seen.first}: ${seen.loops}`);
    expect(seen.ofP4.length === 9 && seen.ofP4.some((name) => /4000\s?kN/.test(name)) && seen.ofP4.some((name) => /14 days/.test(name)), 'loops of P4: ' + seen.ofP4);
    const bars = seen.bars.filter(({ xaxis }) => xaxis === 'x');
    near(Math.exp(bars[0].x[0]), 1.269113038, 'largest factor of the temperature');
    near(Math.exp(bars[1].x[0]), 0.848178179, 'smallest factor of the temperature');
    near(Math.exp(bars[0].x.at(-1)), 1.869155861, 'all together');
    const lines = (traces) => traces.filter(({ mode }) => mode === 'lines');
    const [devices, mean, dotted, dashed] = lines(seen.panels);
    // The smooth curve is exp(b (T - 20)). A least-squares fit to the factors of the closed form gives b.
    expect(dashed.dash === 'dash' && dashed.x[0] === -20, `smooth curve from ${dashed.x[0]}`);
    near(Math.exp(dashed.y[0]), Math.exp(-0.0067696479 * -40), 'smooth curve at -20 C');
    near(Math.exp(devices.y[0]), 0.920443205 / 0.699623055, 'P1 at -20 C');
    near(Math.exp(mean.y[0]), 1.313436434, 'mean at -20 C');
    expect(mean.x[0] === -20 && dotted.dash === 'dot' && dotted.x[0] === 40 && dotted.x[1] === 45, `temperatures ${mean.x}; extrapolated ${dotted.x}`);
    near(Math.exp(dotted.y[1]), 0.848178179, 'at 45 C');
    if (width === 1366) {
      // Between 1000 kN and the reference, the logarithm of the factor is a straight line over the square of the load.
      const load = lines(seen.load)[1],
        middle = load.x.indexOf(1500);
      near(Math.exp(load.y[middle]), 1.04715551 ** ((4 - 2.25) / 3), 'at 1500 kN');
    }
    // In the example the temperature multiplies all forces by one factor, so energy changes by the same factor as
    // K_eff.
    near(Math.exp(seen.energyCold), (1.480158436 * 1.313436434) / 1.310375321, 'energy at -20 C', 4e-4);
    const [recovery] = seen.history.filter(({ xaxis }) => xaxis === 'x2');
    [10.9861229, 38.918203, 58.2008293].forEach((share, i) => near(recovery.y[i], share, `recovery after ${recovery.x[i]} h`));
    const long = seen.history.find(({ x }) => x.length === 10);
    // The property P_n in cycle n of ten cycles follows the curve P_n = P_inf + (P_1 - P_inf) n^-1.2.
    const smooth = seen.history.find(({ x }) => x[1] === 1.25 && x.at(-1) === 10);
    near(smooth.y[4], long.y[1], 'smooth curve at cycle 2', 1e-3);
    near(long.y[0], 1.294167673, 'cycle 1');
    near(long.y[9], 0.91787109, 'cycle 10');
    expect(
      JSON.stringify(seen.levels[0].map((text) => text.replace(/\s/g, ' '))) ===
        JSON.stringify(['\u221220 \u00b0C: 3', '\u221215 \u00b0C: interpolated', '0 \u00b0C: 3', '20 \u00b0C: reference', '40 \u00b0C: 3', '45 \u00b0C: extrapolated']),
      'levels ' + seen.levels[0],
    );
    expect(seen.wide <= 0, `wider than the window by ${seen.wide}`);
    expect(page.errors.length === 0, page.errors.join('; '));
    await page.close();
  }
  const expect = (holds, what) => {
    if (!holds) failures.push(what);
  };
  const campaign = join(directory, 'campaign');
  run('calibrate', join(lot, 'lot.toml'), ...'--laws bilinear --runs 1 --replicates 0 --figures none --out'.split(' '), campaign);
  for (const [name, size] of [['report', { width: 1366, height: 900 }], ['report, telephone, dark', { width: 390, height: 800, dark: true }]]) {
    const page = await open(campaign, size, 'report.html');
    const { Bilinear: law, 'upper bound': upper, 'lower bound': lower, caption } = await page.evaluate(`(${lookAtBoundLaws})()`);
    const near = (value, wanted, what) => expect(Math.abs(value / wanted - 1) < 0.005, `${name}, ${what}: ${value}, wanted ${wanted}`);
    near(upper.K_eff / law.K_eff, 1.869155861, 'K_eff of the upper bound law');
    near(lower.K_eff / law.K_eff, 0.705430235, 'K_eff of the lower bound law');
    near(upper.energy / law.energy, 1.859391152, 'energy of the upper bound law');
    near(lower.energy / law.energy, 0.665827352, 'energy of the lower bound law');
    expect(/Upper bound law \(interpolated\)/.test(caption) && /Lower bound law \(extrapolated\)/.test(caption), `${name}: ${caption}`);
    if (hasAxe) await expectAccessible(page, name, (holds, what) => expect(holds, `${name}: ${what}`));
    expect(page.errors.length === 0, page.errors.join('; '));
    await page.close();
  }
  // The test multiplies the forces of P2 at -20 C by 1.4 and removes the test of P3 at -20 C. With the two remaining
  // devices Student's t is 12.7, so the interval of the mean goes from 0.18 to 13.
  const cold = join(lot, 'P2--20C.csv');
  writeFileSync(cold, readFileSync(cold, 'utf8').replace(/^([\d.]+,[^,]+,)([^,]+)/gm, (_, before, force) => before + 1.4 * Number(force)));
  const file = join(lot, 'lot.toml');
  writeFileSync(file, readFileSync(file, 'utf8').replace(/\[\[device\.test\]\]\nname = "-20C"\nfile = "P3[^[]*/, ''));
  run('inspect', file, '--out', join(directory, 'scatter'));
  const scatter = await open(join(directory, 'scatter'), { width: 1366, height: 900 });
  const { range, cut, caption } = await scatter.evaluate(`(${lookAtPanels})()`);
  expect(Math.exp(range[1]) < 6 && Math.exp(range[0]) > 0.25, `axis from ${range.map(Math.exp)}`);
  expect(cut.includes('-20: triangle-up') && cut.includes('-20: triangle-down') && /Arrow/.test(caption), `marks: ${cut}; ${caption}`);

  run('inspect', join(lot, 'P1-20C.csv'), '--out', join(directory, 'plain'));
  const plain = await open(join(directory, 'plain'), { width: 1366, height: 900 });
  if (await plain.evaluate("document.getElementById('conditions') !== null")) failures.push('a record without conditions has a section on them');
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
process.exit(failures.length === 0 ? 0 : 1);
