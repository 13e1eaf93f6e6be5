// Opens pages of made-up lots for the browser tests.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';
import { extend, with_data } from './test_records.mjs';

// Calls `test` with two functions, one that opens pages and one that records failures, and then ends the process.
// Without a browser it calls nothing and ends the process with the exit code 77.
export async function withBrowser(program, makePage, test) {
  if (!program || !existsSync(program)) {
    console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
    process.exit(77);
  }
  const directory = mkdtempSync(join(tmpdir(), 'isolaw-browser-')),
    browser = new Chromium(program),
    failures = [];
  const expect = (holds, name, what) => {
    if (!holds) failures.push(`${name}: ${what}`);
  };
  // `state` is the option STATE of make_page.cpp. `records` are the options of extend() in test_records.mjs, which
  // replaces the records in the data of the page.
  const written = new Map();
  const open = async ({ devices, laws, state, records, width, height = 800, dark }) => {
    const name = [devices, laws, state ?? 'plain', records ? JSON.stringify(records) : 'as-written'].join('-').replace(/[^\w-]/g, '');
    if (!written.has(name)) {
      const out = join(directory, name);
      execFileSync(makePage, [out, String(devices), String(laws), ...(state ? [state] : [])], { stdio: ['ignore', 'ignore', 'inherit'] });
      const file = join(out, 'report.html');
      if (records) writeFileSync(file, with_data(readFileSync(file, 'utf8'), (report) => extend(report, records)));
      written.set(name, file);
    }
    const page = await browser.open(pathToFileURL(written.get(name)).href, { width, height, dark });
    page.resize = async (wide) => {
      await page.send('Emulation.setDeviceMetricsOverride', { width: wide, height, deviceScaleFactor: 1, mobile: wide < 500 });
      await page.evaluate('new Promise((done) => setTimeout(done, 300))');
    };
    // Shows the page as it is printed on paper with 180 mm between its left and right margins.
    page.print = async () => {
      await page.resize(681);
      await page.send('Emulation.setEmulatedMedia', { media: 'print' });
      await page.evaluate("dispatchEvent(new Event('beforeprint')); new Promise((done) => setTimeout(done, 500))");
    };
    return page;
  };
  try {
    await test({ open, expect });
  } finally {
    await browser.close();
    rmSync(directory, { recursive: true, force: true });
  }
  for (const failure of failures) console.log('FAILED ' + failure);
  process.exit(failures.length === 0 ? 0 : 1);
}
