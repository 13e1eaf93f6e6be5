// Calls the engine for the rest of the page.

import { createEngine } from './engine/engine.js';

let ready = null;

// Starts the engine once, at the first call. The page is shown before the engine is ready.
export const engine = () => (ready ??= createEngine());

const decoder = new TextDecoder();
export const asText = (bytes) => decoder.decode(bytes);
export const asBytes = (words) => new TextEncoder().encode(words);

export const run = async (argv, files, keep, signal) => (await engine()).run({ argv, files, keep, signal });

export const fileOf = (files, path) => files.find((file) => file.path === path)?.bytes ?? null;

// Writes a path as an argument that cannot be mistaken for an option.
export const argument = (path) => (path.startsWith('-') ? './' + path : path);

// The program's complaints about a command or, if it has none, its messages in the same form.
export const complaintsOf = ({ error, stderr = '' }) => error?.complaints ?? asComplaints(stderr);

// Turns each line of a text into a complaint without other parts.
export const asComplaints = (text) => text.split('\n').filter(Boolean).map((found) => ({ where: '', found, allowed: '', advice: '' }));
