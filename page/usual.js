// Settings of the program that the page must know before it asks for anything; the test page.commands compares them.

export const usualRuns = (method) => (method === 'ga' ? 20 : 3);

// Options that the program takes with the genetic algorithm alone.
export const OF_GA = ['population', 'generations', 'stagnation-tolerance'];
