// Uses the page in Chromium as a user does: opens its file, drops files on it and collects the files that it saves.
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from '../browser/chromium.mjs';

export const wait = (ms) => new Promise((done) => setTimeout(done, ms));

// `standIn` is a function from stand_in.mjs that makes the native program answer in place of the page's engine. Without
// it the page uses its engine.
export async function openPage(browser, file, { width = 1280, height = 800, dark = false, standIn = null } = {}) {
  const page = await browser.open('about:blank', { width, height, dark });
  const downloads = mkdtempSync(join(tmpdir(), 'isolaw-downloads-'));
  await browser.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
  // In the DevTools protocol a frame of another origin is a target of its own, and it reports its errors separately.
  const targets = new Map();
  browser.listeners.add(({ method, params, sessionId }) => {
    if (method === 'Runtime.bindingCalled') page.onBinding?.(params.payload);
    if (method === 'Target.attachedToTarget' && params.targetInfo.type === 'iframe') {
      targets.set(params.sessionId, params.targetInfo);
      for (const domain of ['Runtime', 'Log', 'Network']) browser.send(domain + '.enable', {}, params.sessionId).catch(() => {});
    }
    if (!targets.has(sessionId)) return;
    if (method === 'Runtime.exceptionThrown') page.errors.push('frame: ' + (params.exceptionDetails.exception?.description ?? params.exceptionDetails.text));
    if (method === 'Log.entryAdded' && params.entry.level === 'error') page.errors.push('frame: ' + params.entry.text);
    if (method === 'Network.requestWillBeSent' && !/^(data|blob):/.test(params.request.url)) page.requests.push(params.request.url);
  });
  await page.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: true });
  if (standIn) await standIn(page);
  const started = Date.now();
  await page.send('Page.navigate', { url: pathToFileURL(file).href });
  page.until = async (expression, what = expression, seconds = 60) => {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const value = await page.evaluate(`(() => { try { return ${expression} } catch { return null } })()`).catch(() => null);
      if (value) return value;
      if (Date.now() > end) throw new Error('waited ' + seconds + ' s for: ' + what);
      await wait(30);
    }
  };
  await page.until("document.body?.dataset.ready === '' || (document.getElementById('failure') && !document.getElementById('failure').hidden)", 'the page to be ready');
  page.openedIn = (Date.now() - started) / 1000;
  page.idle = (seconds = 120) => page.until("(document.body.dataset.busy ?? '0') === '0'", 'the page to be idle', seconds);
  // Drags files or folders over the page with the pointer.
  page.drag = (type, paths, [x, y] = [300, 200]) => page.send('Input.dispatchDragEvent', { type, x, y, data: { items: [], files: paths, dragOperationsMask: 1 } });
  page.drop = async (paths, at) => {
    // If the page shows a frame at the place `at`, it lays an element over the frame when a drag begins. A browser then
    // sends a second dragEnter. The DevTools protocol does not send it, so this function does.
    for (const type of at ? ['dragEnter', 'dragEnter', 'dragOver', 'drop'] : ['dragEnter', 'dragOver', 'drop']) {
      await page.drag(type, paths, at);
      await wait(at ? 200 : 10);
    }
    await wait(50);
    await page.idle();
  };
  // Clicks as a user does: the button goes down, waits a moment and goes up. write() below enters one character after
  // the other.
  page.click = async (selector) => {
    const { x, y } = await page.evaluate(`(() => { const it = document.querySelector(${JSON.stringify(selector)}); it.scrollIntoView({ block: 'center' }); const { x, y, width, height } = it.getBoundingClientRect(); return { x: x + Math.min(width / 2, 60), y: y + height / 2 }; })()`);
    for (const type of ['mousePressed', 'mouseReleased']) {
      await page.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1 });
      await wait(80);
    }
  };
  const codes = { Tab: 9, Enter: 13, Escape: 27, a: 65, p: 80 };
  page.key = async (key, { control = false } = {}) => {
    for (const type of ['keyDown', 'keyUp'])
      await page.send('Input.dispatchKeyEvent', { type, key, code: key.length === 1 ? 'Key' + key.toUpperCase() : key, modifiers: control ? 2 : 0, windowsVirtualKeyCode: codes[key], text: type === 'keyDown' && key === 'Enter' ? '\r' : undefined, commands: control && key === 'a' ? ['selectAll'] : undefined });
  };
  page.write = async (words) => {
    for (const text of words) await page.send('Input.insertText', { text });
  };
  page.focused = () => page.evaluate('document.activeElement.id || document.activeElement.className || document.activeElement.tagName');
  page.press = (id) =>
    page.evaluate(`(() => { const it = document.getElementById(${JSON.stringify(id)}); if (!it) throw new Error('no #' + ${JSON.stringify(id)}); if (it.disabled) throw new Error(it.id + ' is disabled'); it.click(); })()`);
  page.type = (id, value) =>
    page.evaluate(`(() => { const it = document.getElementById(${JSON.stringify(id)}); it.value = ${JSON.stringify(value)}; it.dispatchEvent(new Event('change', { bubbles: true })); })()`);
  page.text = (selector) => page.evaluate(`document.querySelector(${JSON.stringify(selector)})?.innerText ?? ''`);
  // Evaluates an expression in the frame that joined the page last.
  page.inFrame = async (expression) => {
    const [session] = [...targets.keys()].slice(-1);
    if (!session) throw new Error('no frame is attached');
    const { result, exceptionDetails } = await browser.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true }, session);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  page.frames = targets;
  // Waits for the next file that the page saves and returns it as {name, bytes, path}.
  const seen = new Set();
  page.saved = async (seconds = 60) => {
    const end = Date.now() + 1000 * seconds;
    while (Date.now() < end) {
      const name = readdirSync(downloads).find((one) => !seen.has(one) && !one.endsWith('.crdownload') && !one.startsWith('.'));
      if (name) {
        await wait(100);
        seen.add(name);
        return { name, path: join(downloads, name), bytes: readFileSync(join(downloads, name)) };
      }
      await wait(50);
    }
    throw new Error('nothing was saved');
  };
  const close = page.close;
  page.close = async () => {
    await close();
    rmSync(downloads, { recursive: true, force: true });
  };
  page.shot = async (path, full = false) => {
    const { data } = await page.send('Page.captureScreenshot', { format: 'png', captureBeyondViewport: full });
    const { writeFileSync } = await import('node:fs');
    mkdirSync(join(path, '..'), { recursive: true });
    writeFileSync(path, Buffer.from(data, 'base64'));
  };
  return page;
}

// Measures the memory of a process and all its descendants twice a second (only Linux). Processes that share memory
// each count their share of it. Returns a function that ends the measurement and returns the largest number of bytes.
export function watchMemory(pid) {
  const read = (path) => {
    try {
      return readFileSync(path, 'utf8');
    } catch {
      return ''; // the process has ended
    }
  };
  let most = 0;
  const look = () => {
    const below = new Map();
    for (const one of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
      const parent = read(`/proc/${one}/stat`).replace(/^.*\) \S+ /s, '').split(' ')[0];
      below.set(parent, [...(below.get(parent) ?? []), one]);
    }
    const bytes = (one) => 1024 * Number(/^Pss:\s+(\d+)/m.exec(read(`/proc/${one}/smaps_rollup`))?.[1] ?? 0);
    const sum = (one) => bytes(one) + (below.get(one) ?? []).reduce((all, child) => all + sum(child), 0);
    most = Math.max(most, sum(String(pid)));
  };
  const timer = setInterval(look, 500);
  return () => {
    clearInterval(timer);
    return most;
  };
}

export function browserOr77(program) {
  if (!program || !existsSync(program)) {
    console.log('skipped: no Chromium found (install chromium)');
    process.exit(77);
  }
  return new Chromium(program);
}
