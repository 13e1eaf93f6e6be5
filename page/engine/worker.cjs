// This script runs in a worker. It is appended to the script of emscripten, which defines `isolawProgram`. The worker
// runs one command at a time, each in a new instance of the program. The script is no module, because not every browser
// can start a module as a worker from a blob.
// The worker receives { kind: 'compiled', module } once, then { kind: 'run', argv, files, keep, watch } for each
// command. While the command runs, it posts { kind: 'text', stream, lines }, and { kind: 'kept', files } with the files
// that `watch` names. At the end it posts { kind: 'done', code, files } or { kind: 'failed', name, message }.
/* global isolawProgram */
'use strict';
(() => {
  const home = '/work',
    pauseOfText_ms = 50,
    pauseOfKept_ms = 3000;
  let compiled = null;

  const matcher = (globs) => {
    const tests = globs.map((glob) => new RegExp('^' + glob.replace(/[.+?^${}()|[\]\\]/g, '\\$&').replace(/\*/g, '[\\s\\S]*') + '$'));
    return (path) => tests.some((test) => test.test(path));
  };

  const filesBelow = (FS, folder, each) => {
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = folder + '/' + name;
      if (FS.isDir(FS.stat(path).mode)) filesBelow(FS, path, each);
      else each(path);
    }
  };

  const collected = (FS, taken) => {
    const files = [];
    filesBelow(FS, home, (path) => {
      const name = path.slice(home.length + 1);
      if (taken(name, FS.stat(path))) files.push({ path: name, bytes: FS.readFile(path) });
    });
    return files;
  };

  const post = (message) => self.postMessage(message, (message.files ?? []).map(({ bytes }) => bytes.buffer));

  async function run({ argv, files, keep, watch }) {
    const said = { stdout: [], stderr: [] };
    let last = 0,
      lastKept = Date.now(),
      program = null;
    const flush = () => {
      for (const stream of ['stderr', 'stdout'])
        if (said[stream].length > 0) self.postMessage({ kind: 'text', stream, lines: said[stream].splice(0) });
      last = Date.now();
    };
    const say = (stream) => (line) => {
      said[stream].push(line);
      const now = Date.now();
      if (now - last > pauseOfText_ms) flush();
      // The program prints a line of progress after it has stored the runs that the line counts. At this moment the
      // stored files are therefore complete.
      if (watch && now - lastKept > pauseOfKept_ms) {
        const watched = matcher(watch);
        post({ kind: 'kept', files: collected(program.FS, (name) => watched(name)) });
        lastKept = Date.now();
      }
    };
    program = await isolawProgram({
      thisProgram: 'isolaw',
      print: say('stdout'),
      printErr: say('stderr'),
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(compiled, imports).then(done, (error) => fail(error, flush));
        return {};
      },
      quit: (_, toThrow) => {
        throw toThrow;
      },
    });
    const { FS } = program;
    const given = new Map();
    FS.mkdirTree(home);
    FS.chdir(home);
    for (const { path, bytes } of files) {
      const at = home + '/' + path;
      FS.mkdirTree(at.slice(0, at.lastIndexOf('/')));
      FS.writeFile(at, bytes, { canOwn: true });
      FS.utime(at, 1000, 1000);
      given.set(path, FS.stat(at));
    }
    const code = program.callMain(argv);
    flush();
    const wanted = matcher(keep);
    const isNew = (name, { size, mtime, ino }) => {
      const before = given.get(name);
      return !before || before.ino !== ino || before.size !== size || before.mtime.getTime() !== mtime.getTime();
    };
    post({ kind: 'done', code, files: collected(FS, (name, stat) => wanted(name) && isNew(name, stat)) });
  }

  function fail(error, flush) {
    flush?.();
    const memory = error instanceof RangeError && /memory/i.test(error.message);
    self.postMessage({
      kind: 'failed',
      name: memory ? 'MemoryError' : 'CrashError',
      message: 'the program stopped: ' + (error?.message ?? error),
    });
  }

  self.onmessage = ({ data }) => {
    if (data.kind === 'compiled') compiled = data.module;
    else run(data).catch((error) => fail(error));
  };
})();
