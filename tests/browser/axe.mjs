// Checks pages with axe-core: the rules of WCAG 2 and recommended practice.
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const axe = fileURLToPath(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url));
export const hasAxe = existsSync(axe);

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

// Calls `expect` with false and a text for each rule that the page breaks. The page must also keep more than 20 rules,
// which shows that axe-core really examined it.
export async function expectAccessible(page, name, expect) {
  await page.evaluate(readFileSync(axe, 'utf8') + ';0');
  const { passes, found } = await page.evaluate(`(${violations})()`);
  console.log(`${name}: ${passes} rules hold, ${found.length} do not`);
  expect(passes > 20, `${passes} rules apply`);
  for (const violation of found) expect(false, violation);
}
