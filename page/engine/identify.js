// Computes a campaign on all workers, with the commands that serve to distribute a campaign over several machines.
// Workers first compute parts of the runs, then parts of the analyses of devices, then parts of the laws that are
// fitted to the whole lot. One worker merges all parts.

import { usualRuns } from '../usual.js';
import { isProgress, makeProgress } from './progress.js';

const stores = (folder) => [folder + '/campaign.sqlite*'];

// Returns the value of an option that is given as `--runs N` or `--runs=N`, or null if the option is not given.
const valueOf = (options, name) => {
  const at = options.findIndex((word) => word === name || word.startsWith(name + '='));
  return at < 0 ? null : options[at].includes('=') ? options[at].slice(name.length + 1) : options[at + 1];
};

// Returns into how many pieces an earlier campaign was divided, or null if it left no files of this kind. The number
// stands in their paths: 'parts/3-of-8/...' gives 8. `kind` is the first folder of the path: 'parts' (runs), 'shares'
// (analyses of devices) or 'lots' (laws for the whole lot).
const dealtInto = (parts, kind) => {
  const found = parts.map(({ path }) => /^(\w+)\/\d+-of-(\d+)\//.exec(path)).find((one) => one && one[1] === kind);
  return found ? Number(found[2]) : null;
};

// Runs all functions in `works`, at most `workers` at a time, and returns a promise of their results. The promise
// rejects as soon as one of the functions rejects.
const inTurn = async (works, workers) => {
  const results = Array(works.length);
  let next = 0;
  const take = async () => {
    while (next < works.length) {
      const i = next++;
      results[i] = await works[i]();
    }
  };
  await Promise.all(Array.from({ length: workers }, take));
  return results;
};

// Thrown if a command that computes a part of the campaign fails. `said` is the result of that command.
class Refused extends Error {
  constructor(said) {
    super('refused');
    this.said = said;
  }
}

export function identifyWith(pool) {
  return async ({ lotPath, inputs = [lotPath], files, options = [], workers: wanted = pool.count, parts = [], onProgress, onText, signal }) => {
    const workers = Math.max(1, Math.min(wanted, pool.count));
    const begun = (folder) => parts.filter(({ path }) => path.startsWith(folder + '/'));
    const analysed = valueOf(options, '--analysis') !== 'none';
    const runs = Number(valueOf(options, '--runs') ?? usualRuns(valueOf(options, '--method'))); // used only for the progress bar
    const kept = new Map();
    // Aborting this controller ends all commands of the campaign, for example after one of them has failed.
    const ended = new AbortController();
    const abort = () => ended.abort();
    signal?.addEventListener('abort', abort);
    if (signal?.aborted) abort();

    // With several parts for each worker, no worker waits long for the last part. With too many parts, much time goes
    // into reading, because each part reads all records.
    const count = dealtInto(parts, 'parts') ?? workers * (files.length > 20 ? 2 : 4);
    const isWhole = (workers === 1 && dealtInto(parts, 'parts') === null) || (begun('out').length > 0 && dealtInto(parts, 'parts') === null);
    const shares = analysed ? (dealtInto(parts, 'shares') ?? workers) : 0;
    // A law for the whole lot needs at least two records.
    const lots = analysed && files.filter(({ path }) => path !== lotPath).length > 1 ? (dealtInto(parts, 'lots') ?? workers) : 0;
    // The weights estimate the computing time. All analyses together take about as long as three runs of each law.
    const phases = isWhole
      ? [{ name: 'runs', weight: 1, tasks: 1 }]
      : [
          { name: 'runs', weight: runs, tasks: count },
          ...(shares > 0 ? [{ name: 'analyses', weight: 2, tasks: shares }] : []),
          ...(lots > 0 ? [{ name: 'analyses', weight: 1, tasks: lots }] : []),
          { name: 'analyses', weight: analysed ? 0.2 : 0.05, tasks: 1 },
        ];
    const progress = makeProgress(phases, workers, onProgress);

    // Runs one command and keeps the files with its finished work. A cancelled campaign returns these files.
    const work = async (phase, task, folder, argv, given) => {
      progress.begin(phase, task);
      const own = begun(folder);
      const said = await pool.run({
        argv,
        files: [...given, ...own],
        keep: folder === 'out' ? ['out/*'] : stores(folder),
        watch: stores(folder),
        onKept: (found) => kept.set(folder, found),
        onText: (stream, line) => {
          if (isProgress(line)) progress.read(phase, task, line);
          else if (phase === phases.length - 1 || (phase === 0 && task === 0)) onText?.(stream, line);
        },
        signal: ended.signal,
      });
      said.stderr = said.stderr.split('\n').filter((line) => !isProgress(line)).join('\n');
      if (folder === 'out') return said;
      if (said.code !== 0) throw new Refused(said);
      // If an earlier campaign had already done all work of a command, the command writes no file, and the earlier
      // files are its result.
      const found = said.files.length > 0 ? said.files : own;
      kept.set(folder, found);
      progress.end(phase, task);
      return found;
    };
    const folders = (kind, of) => Array.from({ length: of }, (_, k) => `${kind}/${k + 1}-of-${of}`);
    const common = ['--jobs', '1'];

    try {
      if (isWhole) return await work(0, 0, 'out', ['calibrate', ...inputs, ...options, ...common, '--out', 'out', '--figures', 'none'], files);
      const partFolders = folders('parts', count),
        shareFolders = folders('shares', shares),
        lotFolders = folders('lots', lots);
      const computed = await inTurn(
        partFolders.map((folder, k) => () => work(0, k, folder, ['calibrate', ...inputs, ...options, ...common, '--part', `${k + 1}/${count}`, '--out', folder], files)),
        workers,
      );
      const ofParts = computed.flat();
      const examined = await inTurn(
        shareFolders.map((folder, k) => () => work(1, k, folder, ['merge', folder, ...partFolders, ...common, '--figures', 'none', '--part', `${k + 1}/${shares}`], ofParts)),
        workers,
      );
      const ofShares = [...ofParts, ...examined.flat()];
      const fitted = await inTurn(
        lotFolders.map((folder, k) => () => work(2, k, folder, ['merge', folder, ...partFolders, ...shareFolders, ...common, '--figures', 'none', '--part', `${k + 1}/${lots}`], ofShares)),
        workers,
      );
      const last = lots > 0 ? lotFolders : shareFolders;
      return await work(phases.length - 1, 0, 'out', ['merge', 'out', ...partFolders, ...last, ...common, '--figures', 'none'], [...ofParts, ...(lots > 0 ? fitted : examined).flat()]);
    } catch (error) {
      ended.abort();
      if (error instanceof Refused) return error.said;
      error.parts = [...kept.values()].flat();
      throw error;
    } finally {
      progress.stop();
      signal?.removeEventListener('abort', abort);
    }
  };
}
