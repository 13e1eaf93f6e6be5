// The program prints lines `progress SHARE SECONDS_LEFT DONE TOTAL runs|analyses`, and `run LAW OBJECTIVE DEVICE` for
// each run that was finished. This module combines the lines of all commands of a campaign into one share of finished
// work, one remaining time, and the error of each law so far.

const line = /^progress ([\d.]+) ([\d.]+) (\d+) (\d+) (\w+)$/;
const ofRun = /^run (\S+) (\S+) (\d+)$/;
export const isProgress = (text) => line.test(text) || ofRun.test(text);

// `phases` is [{ name, weight, tasks }], in the order of computing. At most `workers` tasks of a phase run at once.
// `tell` is the onProgress of engine.js.
export function makeProgress(phases, workers, tell) {
  const all = phases.map(({ name, weight, tasks }) => ({ name, weight, began: null, tasks: Array.from({ length: tasks }, () => ({ share: 0, left: null, done: 0, total: 0, began: null, took: null })) }));
  const weights = all.reduce((sum, { weight }) => sum + weight, 0);
  const laws = new Map(); // law -> {runs, best: device -> least objective}
  let current = 0,
    told = 0,
    shown = { share: 0, left: null, at: 0 };

  // Estimates the seconds left in a phase. A task that has not reported a time yet is assumed to take as long as the
  // average of the others.
  const leftIn = (phase, now) => {
    const known = phase.tasks.filter(({ took, left }) => took !== null || left !== null).map(({ took, left, began }) => took ?? (now - began) / 1000 + left);
    if (known.length === 0) return null;
    const usual = known.reduce((sum, seconds) => sum + seconds, 0) / known.length;
    const lefts = phase.tasks.map(({ took, left, began }) => (took !== null ? 0 : (left ?? (began === null ? usual : Math.max(0, usual - (now - began) / 1000)))));
    return Math.max(lefts.reduce((sum, seconds) => sum + seconds, 0) / workers, ...phase.tasks.map((_, i) => (phase.tasks[i].began === null ? 0 : lefts[i])));
  };
  const update = () => {
    const now = Date.now(),
      phase = all[current],
      before = all.slice(0, current).reduce((sum, { weight }) => sum + weight, 0) / weights;
    const within = phase.tasks.reduce((sum, { share }) => sum + share, 0) / phase.tasks.length;
    const left = leftIn(phase, now);
    let seconds = left;
    if (left !== null) {
      // Estimates the time of later phases from the time of this phase, in proportion to their weights.
      const whole = (now - phase.began) / 1000 + left;
      const after = all.slice(current + 1).reduce((sum, { weight }) => sum + weight, 0);
      seconds = left + (whole * after) / phase.weight;
    }
    shown = { share: Math.max(shown.share, before + (within * phase.weight) / weights), left: seconds, at: now };
    say();
  };
  const say = () => {
    const phase = all[current];
    const sum = (key) => phase.tasks.reduce((total, task) => total + task[key], 0);
    const since = (Date.now() - shown.at) / 1000;
    const left = shown.left === null ? null : Math.max(0, shown.left - since);
    // Between two lines of progress the share grows with time. It never decreases, and it reaches 1 only when all work
    // is done.
    const gone = shown.left > 0 ? 0.9 * Math.min(1, since / shown.left) : 0;
    told = Math.max(told, Math.min(1, shown.share + (1 - shown.share) * gone));
    tell?.({ done: sum('done'), total: sum('total'), share: told, secondsLeft: left, phase: phase.name, laws: lawsSoFar() });
  };
  // A command that makes analyses prints the line of every run again, also of runs that an earlier, cancelled
  // identification finished. Such a line is not new: it may improve `best`, but it does not count as one more run.
  const note = (law, objective, device, isNew) => {
    const { best } = laws.get(law) ?? laws.set(law, { runs: 0, best: new Map() }).get(law);
    if (isNew) ++laws.get(law).runs;
    if (Number.isFinite(objective)) best.set(device, Math.min(objective, best.get(device) ?? Infinity));
  };
  const lawsSoFar = () =>
    [...laws].map(([id, { runs, best }]) => ({ id, runs, devices: best.size, error: best.size > 0 ? [...best.values()].reduce((sum, one) => sum + one, 0) / best.size : null }));
  const ticking = tell ? setInterval(() => shown.at > 0 && say(), 500) : null;

  return {
    begin: (phase, task) => {
      current = Math.max(current, phase);
      all[phase].began ??= Date.now();
      all[phase].tasks[task].began = Date.now();
    },
    read: (phase, task, text) => {
      const [, law, objective, device] = ofRun.exec(text) ?? [];
      if (law !== undefined) {
        note(law, Number(objective), device, phase === 0);
        return;
      }
      const [, share, left, done, total] = line.exec(text) ?? [];
      if (share === undefined || phase !== current) return;
      Object.assign(all[phase].tasks[task], { share: Number(share), left: Number(left), done: Number(done), total: Number(total) });
      update();
    },
    end: (phase, task) => {
      const it = all[phase].tasks[task];
      Object.assign(it, { share: 1, left: 0, took: (Date.now() - it.began) / 1000 });
      if (phase === current) update();
    },
    stop: () => clearInterval(ticking),
  };
}
