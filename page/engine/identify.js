// A campaign on all workers, by what the program has for many machines: parts, and their merge.

const store = (folder) => [folder + '/campaign.sqlite*'];
const partFolder = /^parts\/(\d+)-of-(\d+)\//;

// Of `--runs N` or `--runs=N`.
const valueOf = (options, name) => {
  const at = options.findIndex((word) => word === name || word.startsWith(name + '='));
  return at < 0 ? null : options[at].includes('=') ? options[at].slice(name.length + 1) : options[at + 1];
};

// Lines `progress SHARE SECONDS_LEFT DONE TOTAL runs|analyses` of several instances as one.
function combined(onProgress, count, shareOfRuns) {
  const parts = Array.from({ length: count }, () => ({ share: 0, left: null, done: 0, total: 0 }));
  let shown = 0;
  const tell = (share, left, done, total, phase) => {
    shown = Math.max(shown, Math.min(1, share));
    onProgress?.({ done, total, share: shown, secondsLeft: left, phase });
  };
  const read = (line) => {
    const [, share, left, done, total, phase] = /^progress ([\d.]+) ([\d.]+) (\d+) (\d+) (\w+)$/.exec(line) ?? [];
    return share === undefined ? null : { share: Number(share), left: Number(left), done: Number(done), total: Number(total), phase };
  };
  return {
    ofPart: (k, line) => {
      const told = read(line);
      if (!told) return;
      parts[k] = told;
      const sum = (key) => parts.reduce((all, part) => all + (part[key] ?? 0), 0);
      const known = parts.filter((part) => part.left !== null);
      const left = Math.max(...known.map((part) => part.left));
      // What follows the runs takes as long as runs of their number do.
      const share = sum('share') / count;
      tell(share * shareOfRuns, share > 0 && share < 1 ? left + (left / (1 - share)) * (1 / shareOfRuns - 1) : left, sum('done'), sum('total'), 'runs');
    },
    ofMerge: (line) => {
      const told = read(line);
      if (told) tell(shareOfRuns + (1 - shareOfRuns) * told.share, told.left, told.done, told.total, told.phase);
    },
  };
}

export function identifyWith(pool) {
  return async ({ lotPath, inputs = [lotPath], files, options = [], workers = pool.count, parts = [], onProgress, onText, signal }) => {
    const dealt = parts.map(({ path }) => partFolder.exec(path)).find((found) => found);
    const count = dealt ? Number(dealt[2]) : Math.max(1, Math.min(workers, pool.count));
    const begun = (folder) => parts.filter(({ path }) => path.startsWith(folder + '/'));
    const analysed = valueOf(options, '--analysis') !== 'none';
    const runs = Number(valueOf(options, '--runs') ?? (valueOf(options, '--method') === 'ga' ? 20 : 3));
    const progress = combined(onProgress, count, analysed ? runs / (runs + 3) : 0.99);
    const kept = new Map();
    const keepOf = (folder) => (found) => kept.set(folder, found);
    const speak = (told) => (stream, line) => {
      told(line);
      if (!line.startsWith('progress ')) onText?.(stream, line);
    };
    const without = (said) => ({ ...said, stderr: said.stderr.replace(/^progress .*\n/gm, '') });
    const words = ['calibrate', ...inputs, ...options, '--jobs', '1'];
    // One fails: the others are ended.
    const ended = new AbortController();
    const abort = () => ended.abort();
    signal?.addEventListener('abort', abort);
    if (signal?.aborted) abort();
    try {
      if (begun('out').length > 0 || count === 1) {
        const said = await pool.run({
          argv: [...words, '--out', 'out', '--figures', 'none'],
          files: [...files, ...begun('out')],
          keep: ['out/*'],
          watch: store('out'),
          onKept: keepOf('out'),
          onText: speak(progress.ofMerge),
          signal: ended.signal,
        });
        return without(said);
      }
      const folders = Array.from({ length: count }, (_, k) => `parts/${k + 1}-of-${count}`);
      const made = await Promise.all(
        folders.map(async (folder, k) => {
          try {
            const said = await pool.run({
              argv: [...words, '--part', `${k + 1}/${count}`, '--out', folder],
              files: [...files, ...begun(folder)],
              keep: store(folder),
              watch: store(folder),
              onKept: keepOf(folder),
              onText: k === 0 ? speak((line) => progress.ofPart(k, line)) : (_, line) => progress.ofPart(k, line),
              signal: ended.signal,
            });
            const files_ = said.files.length > 0 ? said.files : begun(folder);
            kept.set(folder, files_);
            if (said.code !== 0) ended.abort();
            return { ...said, files: files_ };
          } catch (error) {
            if (error.name === 'AbortError') return error;
            ended.abort();
            throw error;
          }
        }),
      );
      const wrong = made.find((said) => said.code > 0);
      if (wrong) return without(wrong);
      if (ended.signal.aborted) throw made.find((said) => said instanceof Error);
      const said = await pool.run({
        argv: ['merge', 'out', ...folders, '--jobs', '1', '--figures', 'none'],
        files: made.flatMap((one) => one.files.map(({ path, bytes }) => ({ path, bytes: bytes.slice() }))),
        keep: ['out/*'],
        watch: store('out'),
        onKept: keepOf('out'),
        onText: speak(progress.ofMerge),
        signal: ended.signal,
      });
      return without(said);
    } catch (error) {
      error.parts = [...kept.values()].flat();
      throw error;
    } finally {
      signal?.removeEventListener('abort', abort);
    }
  };
}
