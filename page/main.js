// Starts the page: it shows the views, takes dropped files, and offers the next step.

import { drawAbout } from './about.js';
import { button, element, fill, place, visible } from './dom.js';
import { asComplaints, complaintsOf, engine } from './engine_use.js';
import { forgetFrames, isFrame, printFrame } from './frame.js';
import { cancelIdentifying, drawLaws, isIdentifying, knowWorkers } from './laws.js';
import { addFiles, exampleLot, inspect, lotDevices, openStore, proposeTests, readCatalogue, readRecords, replaces, titleOfAll } from './lot.js';
import { drawProperties } from './properties.js';
import { drawRecords, noteList, problemList } from './records.js';
import { drawSave } from './save.js';
import { changed, forgetAll, onChange, state } from './state.js';
import { ofDrop, ofInput, take, withoutFolder } from './taking.js';
import { text } from './text.js';

const VIEWS = Object.keys(text.views);
let current = 'records';
let working = 0;

const isEmpty = () => state.lot === null && !state.campaign;
const allowed = (view) => view === 'records' || view === 'about' || (view === 'save' ? !isEmpty() : view === 'laws' ? state.campaign !== null || lotDevices().length > 0 : state.inspection !== null);

function drawMast() {
  place('title').textContent = visible(titleOfAll() || text.kind);
  place('title').title = place('title').textContent;
  place('brand').textContent = text.program;
}

function drawViews() {
  fill(
    place('views'),
    VIEWS.map((view) =>
      button(text.views[view], () => show(view, true), { id: 'show-' + view, 'data-words': text.views[view], 'aria-current': view === current ? 'page' : null, disabled: !allowed(view), title: allowed(view) ? null : text.notYet[view] }),
    ),
  );
  for (const view of VIEWS) place('view-' + view).hidden = view !== current;
  document.body.dataset.view = current;
}

function drawEmpty() {
  fill(
    place('view-records'),
    element('h2', { class: 'hidden', tabindex: '-1', id: 'records-title' }, text.records),
    element('p', { class: 'headline' }, text.promise),
    noteList(),
    element(
      'div',
      { class: 'drop', id: 'drop' },
      element('p', { class: 'word' }, text.drop),
      element('p', { class: 'fine' }, text.dropWhat),
      element(
        'p',
        { class: 'next' },
        button(text.chooseFiles, () => place('pick').click(), { class: 'action main', id: 'choose-files' }),
        button(text.chooseFolder, () => place('pick-folder').click(), { class: 'action', id: 'choose-folder' }),
        button(text.example, () => busy(text.starting, async () => takeIn(await exampleLot())), { class: 'action', id: 'example' }),
      ),
    ),
    element('ol', { class: 'steps' }, text.steps.map(([title, words]) => element('li', {}, element('b', {}, title), element('span', {}, words)))),
  );
}

const use = {
  edit: (lot) => {
    state.lot = lot;
    state.saved = false;
    if (lotDevices().length === 0) {
      state.inspection = null;
      state.inspectionFiles = [];
      state.problems = [];
    }
    changed();
    busy(text.inspecting, inspectIfAny);
  },
  show: (view) => show(view, true),
  pick: () => place('pick').click(),
  pickFolder: () => place('pick-folder').click(),
  startOver: () => {
    if (state.saved || window.confirm(text.reallyStartOver)) startOver();
  },
  addAgain: (paths) => busy(text.reading(paths.length), async () => {
    await readRecords(paths);
    changed();
    await inspectIfAny();
  }),
  propose: () => busy(text.inspecting, async () => {
    await proposeTests();
    state.saved = false;
    changed();
    await inspectIfAny();
  }),
  busy: (words, work) => busy(words, work),
  fail: (error) => fail(error),
};

const inspectIfAny = async () => {
  // If this page cannot parse the lot file, the program still reads it and reports the fault.
  if (state.lot !== null && /^\s*\[\[\s*device/m.test(state.lot)) await inspect();
};

function draw() {
  drawMast();
  drawViews();
  if (isEmpty()) drawEmpty();
  else drawRecords(use);
  if (current === 'properties') drawProperties(use);
  if (current === 'laws') drawLaws(use);
  if (current === 'save') drawSave(use);
}

function show(view, focus = false) {
  if (!allowed(view)) return;
  current = view;
  draw();
  if (view === 'about') drawAbout().catch(fail);
  if (focus) place('view-' + view).querySelector('h2')?.focus();
}

function forget() {
  cancelIdentifying();
  forgetAll();
  forgetFrames();
  hush();
}

function startOver() {
  forget();
  show('records', true);
}

// Shows the text `words` while `work` runs. The user can use the page in the meantime.
async function busy(words, work) {
  ++working;
  document.body.dataset.busy = String(working);
  place('status').textContent = words;
  place('busy').hidden = false;
  try {
    return await work();
  } catch (error) {
    fail(error);
    return null;
  } finally {
    --working;
    document.body.dataset.busy = String(working);
    if (working === 0) {
      place('busy').hidden = true;
      place('status').textContent = '';
    }
    changed();
  }
}

const hush = () => {
  place('failure').hidden = true;
};

function fail(error) {
  const node = place('failure');
  const complaints = error.complaints ?? complaintsOf(error);
  fill(
    node,
    element('p', { class: 'word' }, visible(error.message || text.failed)),
    problemList(complaints).slice(0, 5),
    complaints.length === 0 && !error.shown && element('p', { class: 'fine' }, visible(error.name)),
    button(text.close, () => {
      node.hidden = true;
      place('show-' + current)?.focus();
    }, { class: 'action', id: 'close-failure' }),
  );
  node.hidden = false;
  node.focus();
}

const takeIn = async (files) => {
  hush();
  const { files: all, title } = withoutFolder(files);
  const notes = state.notes;
  const taken = replaces(all);
  if (taken && !state.saved && (taken === 'everything' ? !isEmpty() : state.campaign !== null) && !window.confirm(text.reallyReplace)) return;
  if (taken === 'everything') forget();
  const { store, of } = await addFiles({ files: all, title, notes });
  changed();
  place('status').textContent = text.inspecting;
  await inspectIfAny();
  if (store) {
    place('status').textContent = text.reporting;
    await openStore(store, of);
    changed();
    show('laws');
  } else show('records');
};

let received = Promise.resolve(); // fulfilled once the last drop has been read; the next drop waits for it
const receive = (chosen) => {
  const before = received;
  received = busy(text.starting, async () => {
    const all = await chosen;
    await before;
    place('status').textContent = text.reading(all.length);
    state.notes = [];
    const size = [...state.files.values()].reduce((sum, { length }) => sum + length, 0);
    const { files, notes } = await take(all, size);
    state.notes = notes;
    if (files.length > 0) await takeIn(files);
  });
};

function listen() {
  // While the user drags a file, an element covers the whole page. Without it, the frame of a report would get the
  // dropped file.
  const over = (on) => document.body.toggleAttribute('data-dropping', on);
  addEventListener('dragenter', (event) => {
    event.preventDefault();
    if (event.dataTransfer?.types.includes('Files')) over(true);
  });
  addEventListener('message', ({ data, source }) => data === 'isolaw: drag' && isFrame(source) && over(true));
  place('dropping').addEventListener('dragleave', () => over(false));
  addEventListener('pointermove', () => over(false)); // browsers send no pointermove during a drag
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    over(false);
    document.activeElement?.blur(); // a field that is being edited first writes its value to the lot file
    receive(ofDrop(event.dataTransfer));
  });
  for (const id of ['pick', 'pick-folder'])
    place(id).addEventListener('change', ({ currentTarget }) => {
      const chosen = ofInput(currentTarget);
      currentTarget.value = '';
      receive(Promise.resolve(chosen));
    });
  addEventListener('beforeunload', (event) => {
    if (!isIdentifying() && (state.saved || isEmpty())) return;
    event.preventDefault();
    event.returnValue = text.leave;
  });
  addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && current === 'laws' && isIdentifying()) cancelIdentifying();
    // Browsers print only one sheet of a page that contains a frame. So the report in the frame prints itself.
    if (event.key.toLowerCase() === 'p' && (event.ctrlKey || event.metaKey) && printFrame(place('view-' + current))) event.preventDefault();
  });
}

document.documentElement.lang = text.language;
place('skip').textContent = text.skip;
place('views').setAttribute('aria-label', text.sections);
place('dropping').textContent = text.dropNow;
place('print-hint').textContent = text.printHint;
onChange(draw);
listen();
draw();
engine()
  .then((started) => {
    knowWorkers(started.workers ?? 1);
    return readCatalogue();
  })
  .then(() => {
    document.body.dataset.ready = '';
    changed();
  })
  .catch((error) => fail(Object.assign(new Error(text.noEngine + ' ' + text.noEngineTry), { complaints: asComplaints(error.message), shown: true })));
