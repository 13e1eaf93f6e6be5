// The program as the rest of the page uses it.

import { createEngine } from './engine/engine.js';

let ready = null;

// Started once; the page does not wait for it before it shows itself.
export const engine = () => (ready ??= createEngine());

const decoder = new TextDecoder();
export const asText = (bytes) => decoder.decode(bytes);
export const asBytes = (words) => new TextEncoder().encode(words);

export const run = async (argv, files, keep, signal) => (await engine()).run({ argv, files, keep, signal });

export const fileOf = (files, path) => files.find((file) => file.path === path)?.bytes ?? null;

// A path as an argument that is no option.
export const argument = (path) => (path.startsWith('-') ? './' + path : path);

// What the program says without its name in front of each line.
export const messageOf = (stderr) => stderr.replace(/^isolaw: /gm, '').trim();
