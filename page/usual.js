// These values repeat values of the program, because the page needs them before the program has started. The test
// page.commands compares them with the program.

export const usualRuns = (method) => (method === 'ga' ? 20 : 2);

// The program accepts these options only together with the genetic algorithm.
export const OF_GA = ['population', 'generations', 'stagnation-tolerance'];
