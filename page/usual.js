// What the page must know of the program's settings before it asks it for anything; page.commands asks whether it is so.

// Runs where none are asked for.
export const usualRuns = (method) => (method === 'ga' ? 20 : 3);

// What the program takes with the genetic algorithm alone.
export const OF_GA = ['population', 'generations', 'stagnation-tolerance'];
