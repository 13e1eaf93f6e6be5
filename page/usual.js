// Settings of the program that the page needs before it can ask the program. The test page.commands compares them.

export const usualRuns = (method) => (method === 'ga' ? 20 : 3);

// Options that the program accepts only with the genetic algorithm.
export const OF_GA = ['population', 'generations', 'stagnation-tolerance'];
