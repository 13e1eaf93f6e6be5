// The report must not break the rules of axe-core (WCAG 2 and recommended practice), in light and dark colours, on the
// screens of a laptop and a telephone.
//   node report_accessibility.mjs MAKE_PAGE [CHROMIUM]
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { withBrowser } from './page_of.mjs';

const [makePage, program] = process.argv.slice(2);
const axe = fileURLToPath(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url));
if (!existsSync(axe)) {
  console.log('skipped: no axe-core found (npm ci in the project\u2019s root)');
  process.exit(77);
}

const CASES = [
  { name: 'calibration', devices: 3, laws: 3, state: 'predicted', width: 1366 },
  { name: 'calibration, dark', devices: 3, laws: 3, state: 'predicted', width: 1366, dark: true },
  { name: 'calibration, telephone', devices: 3, laws: 3, state: 'predicted', width: 390 },
  { name: 'inspection with warnings', devices: 4, laws: 3, records: { laws: false }, width: 1366 },
  { name: 'inspection, dark', devices: 4, laws: 3, records: { laws: false, verified: false }, width: 1366, dark: true },
];

// Draws all figures, opens all details and returns the rules that the page then breaks. This function runs in the page.
async function violations() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  for (const details of document.querySelectorAll('details')) details.open = true;
  for (const plot of document.querySelectorAll('.plot')) {
    plot.scrollIntoView();
    for (let i = 0; i < 100 && !plot.querySelector('.main-svg .trace'); ++i) await wait(30);
  }
  const { violations: found, passes } = await window.axe.run(document, { resultTypes: ['violations'] });
  return {
    passes: passes.length,
    found: found.map(({ id, help, nodes }) => id + ', ' + help + ': ' + nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(' | ')),
  };
}

await withBrowser(program, makePage, async ({ open, expect }) => {
  for (const one of CASES) {
    const page = await open(one);
    await page.evaluate(readFileSync(axe, 'utf8') + ';0');
    const { passes, found } = await page.evaluate(`(${violations})()`);
    console.log(`${one.name}: ${passes} rules hold, ${found.length} do not`);
    expect(passes > 20, one.name, `${passes} rules apply`);
    for (const violation of found) expect(false, one.name, violation);
    await page.close();
  }
});
