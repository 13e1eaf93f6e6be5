// Opens the page that `isolaw inspect` writes for a lot of four records. One record is a copy of another, and one is
// cut off early. The test checks what the certificate says of the copy, and that a window of 1280 pixels shows all
// columns of the tables. In a second lot the records have two amplitudes, and the design displacement chooses one of
// them.
//   node inspected_lot.mjs ISOLAW [CHROMIUM]
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';

const [isolaw, program] = process.argv.slice(2);
if (!program || !existsSync(program)) {
  console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
  process.exit(77);
}

// Returns the record of a bilinear device as CSV. The device yields at 10 mm and has 0.5 kN/mm after yielding and the
// given strength in kN. Cycles have 0.5 Hz and 100 mm, unless `amplitude` returns another amplitude for a sample.
function record(samples, strength, amplitude = () => 100) {
  const rows = ['time [s],displacement [mm],force [kN]'];
  for (let i = 0, z = 0, before = 0; i < samples; ++i) {
    const x = amplitude(i) * Math.sin((2 * Math.PI * i) / 200);
    z = Math.min(1, Math.max(-1, z + (x - before) / 10));
    before = x;
    rows.push([0.01 * i, x, 0.5 * x + strength * z].map((value) => value.toFixed(5)).join());
  }
  return rows.join('\n') + '\n';
}

// Returns what the certificate says, and which tables are wider than the window. This function runs in the page.
function look() {
  const rows = [...document.querySelectorAll('#figure-certificate-devices tbody tr')];
  const facts = [...document.querySelectorAll('#figure-certificate-head dt')];
  return {
    facts: Object.fromEntries(facts.map((term) => [term.textContent, term.nextElementSibling.textContent])),
    rows: Object.fromEntries(rows.map((row) => [row.cells[0].textContent, row.textContent])),
    cut: [...document.querySelectorAll('#figure-lot .scroll, #figure-certificate-devices .scroll')]
      .filter((region) => region.scrollWidth > region.clientWidth)
      .map((region) => `${region.getAttribute('aria-label')}: ${region.scrollWidth} in ${region.clientWidth}`),
  };
}

const failures = [];
const expect = (holds, what) => {
  if (!holds) failures.push(what);
};
const directory = mkdtempSync(join(tmpdir(), 'isolaw-browser-')),
  browser = new Chromium(program);
try {
  const inspected = async (files, design) => {
    const out = join(directory, Object.keys(files).join('-'));
    const inputs = Object.entries(files).map(([name, text]) => {
      writeFileSync(join(directory, name + '.csv'), text);
      return join(directory, name + '.csv');
    });
    execFileSync(isolaw, ['inspect', ...inputs, ...design, '--out', out], { stdio: ['ignore', 'ignore', 'inherit'] });
    const page = await browser.open(pathToFileURL(join(out, 'inspection.html')).href, { width: 1280, height: 800 });
    return page.evaluate(`(${look})()`);
  };
  const { facts, rows, cut } = await inspected(
    { a: record(601, 20), b: record(601, 22), cut: record(120, 20), twin: record(601, 20) },
    ['--rules', 'ntc-2018', '--design', 'K_eff=0.7,damping=17,disp=100,frequency=0.5'],
  );
  expect(!('Blocks tested' in facts), `blocks tested: ${facts['Blocks tested']}, of one amplitude`);
  expect(/100\.0\smm/.test(facts.Conditions), 'conditions ' + facts.Conditions);
  expect(facts.Test === 'cyclic shear of 3 devices', 'test: ' + facts.Test);
  expect(/pass on/.test(rows.a), 'a: ' + rows.a);
  expect(/not assessedthe same record as a/.test(rows.twin) && !/pass/.test(rows.twin), 'twin: ' + rows.twin);
  expect(cut.length === 0, 'cut off at 1280: ' + cut.join('; '));
  // At 60 mm the stiffness is 0.5 + 20 / 60 kN/mm, and at 100 mm it is 0.7 kN/mm.
  const twoSteps = (strength) => record(1201, strength, (i) => (i < 600 ? 60 : 100));
  const chosen = await inspected({ c: twoSteps(20), d: twoSteps(22) }, ['--design', 'disp=60']);
  expect(/60\.0\smm/.test(chosen.facts.Conditions) && /0\.833/.test(chosen.rows.c), `conditions ${chosen.facts.Conditions}, values ${chosen.rows.c}`);
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
process.exit(failures.length === 0 ? 0 : 1);
