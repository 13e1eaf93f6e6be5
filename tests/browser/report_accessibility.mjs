// The report must not break the rules of axe-core (WCAG 2 and recommended practice), in light and dark colours, on the
// screens of a laptop and a telephone.
//   node report_accessibility.mjs MAKE_PAGE [CHROMIUM]
import { expectAccessible, hasAxe } from './axe.mjs';
import { withBrowser } from './page_of.mjs';

const [makePage, program] = process.argv.slice(2);
if (!hasAxe) {
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

await withBrowser(program, makePage, async ({ open, expect }) => {
  for (const one of CASES) {
    const page = await open(one);
    await expectAccessible(page, one.name, (holds, what) => expect(holds, one.name, what));
    await page.close();
  }
});
