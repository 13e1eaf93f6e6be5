// Calls of the engine for the rest of the page.

import { createEngine } from './engine/engine.js';

let ready = null;

// Starts once, at the first call; the page shows itself before that is done.
export const engine = () => (ready ??= createEngine());

const decoder = new TextDecoder();
export const asText = (bytes) => decoder.decode(bytes);
export const asBytes = (words) => new TextEncoder().encode(words);

export const run = async (argv, files, keep, signal) => (await engine()).run({ argv, files, keep, signal });

export const fileOf = (files, path) => files.find((file) => file.path === path)?.bytes ?? null;

// A path as an argument that cannot be taken for an option.
export const argument = (path) => (path.startsWith('-') ? './' + path : path);

// The program's complaints about a command, or where it has none, its messages as such.
export const complaintsOf = ({ error, stderr = '' }) => error?.complaints ?? asComplaints(stderr);

// Each line of a text as a complaint that has no other parts.
export const asComplaints = (text) => text.split('\n').filter(Boolean).map((found) => ({ where: '', found, allowed: '', advice: '' }));
