// Takes the place of page/engine/engine.js in a test and offers the same functions. Each call goes to the test that
// drives the browser, which runs the native program (stand_in.mjs).
const waiting = new Map();
let count = 0;

const toBase64 = (bytes) => {
  let words = '';
  for (let i = 0; i < bytes.length; i += 0x8000) words += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(words);
};
const fromBase64 = (words) => Uint8Array.from(atob(words), (sign) => sign.charCodeAt(0));
const packed = (files) => files.map(({ path, bytes }) => ({ path, bytes: toBase64(bytes) }));
const unpacked = (answer) => ({ ...answer, files: (answer.files ?? []).map(({ path, bytes }) => ({ path, bytes: fromBase64(bytes) })) });

window.isolawAnswer = (id, answer) => {
  const { resolve, reject, onProgress } = waiting.get(id);
  if (answer.progress) {
    onProgress?.(answer.progress);
    return;
  }
  waiting.delete(id);
  const { failure } = answer;
  if (failure) reject(Object.assign(new Error(failure.message), failure, { parts: unpacked({ files: failure.parts }).files }));
  else resolve(unpacked(answer));
};

function call(what, { signal, onProgress, ...options }) {
  const id = ++count;
  return new Promise((resolve, reject) => {
    waiting.set(id, { resolve, reject, onProgress });
    signal?.addEventListener('abort', () => window.isolawCall(JSON.stringify({ id, what: 'abort' })));
    window.isolawCall(JSON.stringify({ id, what, ...options, files: packed(options.files ?? []), parts: packed(options.parts ?? []) }));
  });
}

export const createEngine = async () => ({
  workers: 2,
  licences: [{ name: 'zlib', version: '1.2.13', licence: 'Zlib', text: 'This software is provided "as-is" <b>' }],
  run: (options) => call('run', options),
  identify: (options) => call('identify', options),
  version: async () => 'stand-in',
  selfTest: async () => ({ ok: true, found: 0.1, expected: 0.1, what: 'a stand-in computes nothing' }),
  close: () => {},
});
