// Drives a headless Chromium by the DevTools protocol over a pipe. It needs only Node.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const FLAGS = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-dev-shm-usage',
  '--hide-scrollbars',
  '--remote-debugging-pipe',
];

// Returns the data of a report in kN and mm, with the names of laws and parameters that the page shows. This function
// runs in the page.
function reportAsShown() {
  const report = JSON.parse(document.getElementById('isolaw-data').textContent, (key, value) => value?.said?.[0] ?? value);
  const names = Object.fromEntries(report.laws.map(({ id, name }) => [id, name]));
  const named = (id) => names[id] ?? id;
  const { recommendation } = report.findings;
  if (recommendation) {
    recommendation.law &&= named(recommendation.law);
    for (const standing of recommendation.standings) standing.law = named(standing.law);
  }
  for (const law of report.published?.laws ?? []) law.law = named(law.law);
  for (const law of report.laws) {
    law.id = law.name;
    for (const parameter of law.parameters) parameter.name = (report.notation.parameters[parameter.name] ?? [parameter.name]).join('');
  }
  return report;
}

// Returns a sentence by isolaw as the page shows it, with symbols such as K_eff and minus signs typeset. This
// function runs in the page.
function asSet(text) {
  const { words } = JSON.parse(document.getElementById('isolaw-data').textContent).notation;
  return text
    .replace(/(^|[\s(])-(?=\d)/g, '$1\u2212')
    .replace(/(?<![\w./-])[A-Za-z]\w*(?![\w/-]|[.]\w)/g, (word) => (Object.hasOwn(words, word) ? words[word].join('') : word));
}

export class Chromium {
  constructor(program) {
    this.profile = mkdtempSync(join(tmpdir(), 'isolaw-chromium-'));
    this.process = spawn(program, [...FLAGS, `--user-data-dir=${this.profile}`, 'about:blank'], {
      stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
    });
    this.pending = new Map();
    this.listeners = new Set();
    this.count = 0;
    let rest = '';
    this.process.stdio[4].setEncoding('utf8').on('data', (text) => {
      const messages = (rest + text).split('\0');
      rest = messages.pop();
      for (const message of messages) this.receive(JSON.parse(message));
    });
    this.process.on('exit', () => {
      for (const { reject } of this.pending.values()) reject(new Error('the browser ended'));
    });
  }

  receive(message) {
    if (!message.id) {
      this.listeners.forEach((listener) => listener(message));
      return;
    }
    const { resolve, reject } = this.pending.get(message.id);
    this.pending.delete(message.id);
    if (message.error) reject(new Error(message.error.message));
    else resolve(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.count;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((resolve, reject) => this.pending.set(id, { resolve, reject }));
  }

  // Opens a page in a new window. send() and evaluate() of the returned object act on this page, whose errors and
  // requests are collected from the start.
  async open(url, { width, height, dark = false }) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = {
      errors: [],
      requests: [],
      send: (method, params) => this.send(method, params, sessionId),
      evaluate: async (expression) => {
        const { result, exceptionDetails } = await page.send('Runtime.evaluate', {
          expression,
          awaitPromise: true,
          returnByValue: true,
        });
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
      },
      close: () => this.send('Target.closeTarget', { targetId }),
    };
    const loaded = new Promise((resolve) => {
      this.listeners.add(({ method, params, sessionId: session }) => {
        if (session !== sessionId) return;
        if (method === 'Runtime.exceptionThrown')
          page.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
        if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
          page.errors.push(params.args.map((a) => a.value ?? a.description).join(' '));
        if (method === 'Log.entryAdded' && ['error', 'warning'].includes(params.entry.level))
          page.errors.push(params.entry.text);
        if (method === 'Network.requestWillBeSent' && !/^(file|data|blob):/.test(params.request.url))
          page.requests.push(params.request.url);
        if (method === 'Page.loadEventFired') resolve();
      });
    });
    for (const domain of ['Runtime', 'Log', 'Network', 'Page']) await page.send(domain + '.enable');
    await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
    await page.send('Emulation.setEmulatedMedia', {
      features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }],
    });
    await page.send('Page.navigate', { url });
    await loaded;
    await page.evaluate(`window.reportAsShown = ${reportAsShown}; window.asSet = ${asSet}; 0`);
    return page;
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    await this.send('Browser.close').catch(() => {});
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
