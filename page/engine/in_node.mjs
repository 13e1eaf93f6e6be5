// Runs the engine under Node, for the build and the tests. The program comes from the page's HTML.
import { readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import { createEngine } from './engine.js';

// This JavaScript defines in a worker thread of Node the global names that a worker in a browser has.
const ofBrowser = `
const { parentPort } = require('node:worker_threads');
globalThis.self = globalThis;
globalThis.postMessage = (message, transfer) => parentPort.postMessage(message, transfer);
parentPort.on('message', (data) => self.onmessage({ data }));
`;
// Returns the text of a <script> element. JavaScript undoes what embed.mjs escaped, so the text needs no decoding here.
const elementIn = (html, id) => new RegExp(`<script type="[^"]*" id="${id}">([\\s\\S]*?)</script>`).exec(html)[1];

// `file` is isolaw.html or the output of embed.mjs. `before` is JavaScript that tests put in front of a worker's
// script.
export const engineOf = (file, { before = '', ...options } = {}) => {
  const html = readFileSync(file, 'utf8');
  const script = before + ofBrowser + elementIn(html, 'isolaw-worker');
  return createEngine({
    ...options,
    from: {
      facts: JSON.parse(elementIn(html, 'isolaw-facts')),
      packed: Buffer.from(elementIn(html, 'isolaw-program'), 'base64'),
      cores: availableParallelism(),
      start: () => {
        const thread = new Worker(script, { eval: true });
        const worker = {
          postMessage: (message) => thread.postMessage(message),
          terminate: () => thread.terminate(),
        };
        thread.on('message', (data) => worker.onmessage?.({ data }));
        thread.on('error', (error) => worker.onerror?.({ message: error.message }));
        return worker;
      },
    },
  });
};
