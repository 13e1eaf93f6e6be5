// Starts the engine and offers short functions to use it, for the rest of the page.

import { createEngine } from './engine/engine.js';

let ready = null;

// The first call starts the engine. Every later call returns the same promise. The page can be used while the engine
// starts.
export const engine = () => (ready ??= createEngine());

const decoder = new TextDecoder();
export const asText = (bytes) => decoder.decode(bytes);
export const asBytes = (words) => new TextEncoder().encode(words);

export const run = async (argv, files, keep, signal) => (await engine()).run({ argv, files, keep, signal });

export const fileOf = (files, path) => files.find((file) => file.path === path)?.bytes ?? null;

// Writes a path as an argument. A path that begins with "-" gets "./" in front, so that the program does not read it as
// an option.
export const argument = (path) => (path.startsWith('-') ? './' + path : path);

// Returns the program's complaints about a command. If it has none, every line on standard error becomes a complaint.
export const complaintsOf = ({ error, stderr = '' }) => error?.complaints ?? asComplaints(stderr);

// Returns a complaint for each line of a text.
export const asComplaints = (text) => text.split('\n').filter(Boolean).map((found) => ({ where: '', found, allowed: '', advice: '' }));
