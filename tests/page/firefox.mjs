// Drives a headless Firefox by the protocol WebDriver BiDi over a socket. It needs only Node.
import { spawn } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// A WebSocket client (RFC 6455) for a server on this machine. It handles text messages, including those that come in
// several frames.
class Socket {
  constructor(port, path, onMessage) {
    this.onMessage = onMessage;
    this.rest = Buffer.alloc(0);
    this.parts = [];
    this.socket = connect(port, '127.0.0.1');
    this.open = new Promise((resolve, reject) => {
      this.socket.once('error', reject);
      this.socket.once('connect', () =>
        this.socket.write(`GET ${path} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: ${randomBytes(16).toString('base64')}\r\nSec-WebSocket-Version: 13\r\n\r\n`),
      );
      let head = '';
      const greet = (data) => {
        head += data.toString('latin1');
        const end = head.indexOf('\r\n\r\n');
        if (end < 0) return;
        this.socket.off('data', greet);
        if (!head.startsWith('HTTP/1.1 101')) {
          reject(new Error(head.slice(0, 200)));
          return;
        }
        this.socket.on('data', (more) => this.receive(more));
        this.receive(Buffer.from(head.slice(end + 4), 'latin1'));
        resolve();
      };
      this.socket.on('data', greet);
    });
  }

  send(text) {
    const body = Buffer.from(text),
      mask = randomBytes(4);
    const head = body.length < 126 ? Buffer.from([0x81, 0x80 | body.length]) : body.length < 65536 ? Buffer.from([0x81, 0xfe, body.length >> 8, body.length & 255]) : Buffer.alloc(10);
    if (head.length === 10) {
      head[0] = 0x81;
      head[1] = 0xff;
      head.writeBigUInt64BE(BigInt(body.length), 2);
    }
    for (let i = 0; i < body.length; ++i) body[i] ^= mask[i & 3];
    this.socket.write(Buffer.concat([head, mask, body]));
  }

  receive(data) {
    this.rest = Buffer.concat([this.rest, data]);
    for (;;) {
      if (this.rest.length < 2) return;
      const short = this.rest[1] & 127;
      const from = short === 126 ? 4 : short === 127 ? 10 : 2;
      if (this.rest.length < from) return;
      const length = short === 126 ? this.rest.readUInt16BE(2) : short === 127 ? Number(this.rest.readBigUInt64BE(2)) : short;
      if (this.rest.length < from + length) return;
      const code = this.rest[0] & 15,
        last = this.rest[0] & 128;
      if (code < 8) this.parts.push(this.rest.subarray(from, from + length));
      this.rest = this.rest.subarray(from + length);
      if (code < 8 && last) {
        const text = Buffer.concat(this.parts).toString('utf8');
        this.parts = [];
        this.onMessage(text);
      }
    }
  }
}

export class Firefox {
  static async start(program, downloads) {
    const firefox = new Firefox();
    firefox.profile = mkdtempSync(join(tmpdir(), 'isolaw-firefox-'));
    const prefs = { 'browser.download.folderList': 2, 'browser.download.dir': downloads, 'browser.download.always_ask_before_handling_new_types': false, 'app.update.enabled': false, 'datareporting.policy.dataSubmissionEnabled': false, 'browser.shell.checkDefaultBrowser': false, 'network.captive-portal-service.enabled': false, 'network.connectivity-service.enabled': false };
    writeFileSync(join(firefox.profile, 'user.js'), Object.entries(prefs).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`).join(''));
    firefox.process = spawn(program, ['--headless', '--no-remote', '--profile', firefox.profile, '--remote-debugging-port', '0', 'about:blank'], { stdio: ['ignore', 'ignore', 'pipe'], env: { ...process.env, HOME: firefox.profile, MOZ_HEADLESS: '1' } });
    const port = await new Promise((resolve, reject) => {
      let said = '';
      firefox.process.stderr.setEncoding('utf8').on('data', (text) => {
        said += text;
        const found = /BiDi listening on ws:\/\/127\.0\.0\.1:(\d+)/.exec(said);
        if (found) resolve(Number(found[1]));
      });
      firefox.process.once('exit', () => reject(new Error('Firefox ended: ' + said.slice(-500))));
      setTimeout(() => reject(new Error('Firefox did not listen: ' + said.slice(-500))), 90000).unref();
    });
    firefox.pending = new Map();
    firefox.count = 0;
    firefox.errors = [];
    firefox.requests = [];
    firefox.socket = new Socket(port, '/session', (text) => firefox.receive(JSON.parse(text)));
    await firefox.socket.open;
    await firefox.send('session.new', { capabilities: {} });
    await firefox.send('session.subscribe', { events: ['log.entryAdded', 'network.beforeRequestSent'] });
    const { contexts } = await firefox.send('browsingContext.getTree', {});
    firefox.context = contexts[0].context;
    return firefox;
  }

  receive(message) {
    if (message.id === undefined || message.id === null) {
      const { method, params } = message;
      if (method === 'log.entryAdded' && ['error', 'warn'].includes(params.level)) this.errors.push(params.text);
      if (method === 'network.beforeRequestSent') this.requests.push(params.request.url);
      return;
    }
    const { resolve, reject } = this.pending.get(message.id);
    this.pending.delete(message.id);
    if (message.type === 'error') reject(new Error(message.error + ': ' + message.message));
    else resolve(message.result);
  }

  send(method, params) {
    const id = ++this.count;
    this.socket.send(JSON.stringify({ id, method, params }));
    return new Promise((resolve, reject) => this.pending.set(id, { resolve, reject }));
  }

  // Evaluates an expression in the page or in a frame and returns its value, which JSON must be able to represent.
  async evaluate(expression, context = this.context) {
    const found = await this.send('script.evaluate', { expression: `Promise.resolve(${expression}).then((value) => JSON.stringify(value ?? null))`, target: { context }, awaitPromise: true });
    if (found.type === 'exception') throw new Error(found.exceptionDetails.text);
    return JSON.parse(found.result.value);
  }

  async until(expression, what, seconds = 120, context = undefined) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const value = await this.evaluate(expression, context ? await context() : this.context).catch(() => null);
      if (value) return value;
      if (Date.now() > end) throw new Error('waited ' + seconds + ' s for: ' + what);
      await new Promise((done) => setTimeout(done, 50));
    }
  }

  async setFiles(selector, files) {
    const { nodes } = await this.send('browsingContext.locateNodes', { context: this.context, locator: { type: 'css', value: selector } });
    await this.send('input.setFiles', { context: this.context, element: { sharedId: nodes[0].sharedId }, files });
  }

  // Returns the last frame in the page.
  async frame() {
    const { contexts } = await this.send('browsingContext.getTree', { root: this.context });
    return contexts[0].children.at(-1)?.context;
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    await Promise.race([this.send('browser.close', {}).catch(() => {}), new Promise((done) => setTimeout(done, 3000))]);
    const killer = setTimeout(() => this.process.kill('SIGKILL'), 5000);
    await ended;
    clearTimeout(killer);
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
