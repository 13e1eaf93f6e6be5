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

// What a command ended with, as the page shows it: the program's complaints, or where there are none, what it said.
export const complaintsOf = ({ error, stderr = '' }) => error?.complaints ?? asComplaints(stderr);

// A text that is no more than that, each line by itself.
export const asComplaints = (text) => text.split('\n').filter(Boolean).map((found) => ({ where: '', found, allowed: '', advice: '' }));
