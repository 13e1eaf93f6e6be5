// The view "Laws": the settings of an identification, its progress and its report.

import { button, element, fill, place, visible } from './dom.js';
import { complaintsOf, engine, fileOf } from './engine_use.js';
import { choiceField, textField } from './fields.js';
import { reportFrame } from './frame.js';
import { lotFiles, lotName, lotPath, lotTables, present, resultsDoubt, setCampaign } from './lot.js';
import { problemList, readable } from './records.js';
import { DASH } from '../src/isolaw/render/page/script/text.js';
import { changed, state } from './state.js';
import { text } from './text.js';
import { withSetting } from './toml.js';
import { OF_GA, usualRuns } from './usual.js';

let running = null; // an AbortController while an identification runs, else null
let workers = 1;
let settingsOpen = false;
let shown = null;
let progress = null; // the last progress that the engine reported
let furthest = 0; // the largest share so far; the bar shows it, so that it never goes back
let started = 0;
let begun = null; // the laws, devices and runs of the present identification, and whether it continues an earlier one

const settings = () => lotTables().tables?.find(({ path }) => path === 'calibrate')?.keys ?? new Map();
const value = (key, other) => settings().get(key)?.value ?? other;
const chosenRuns = () => value('runs', usualRuns(value('method', 'best')));

// Returns 'paper', 'usual', 'all' or a list of ids of laws.
const chosenLaws = () => {
  const laws = value('laws', 'usual');
  return Array.isArray(laws) && laws.length === 1 && text.lawSets[laws[0]] ? laws[0] : laws;
};

function lawIds(chosen) {
  if (chosen === 'all') return state.laws.map(({ id }) => id);
  if (chosen === 'paper') return state.laws.filter(({ set }) => set === 'paper').map(({ id }) => id);
  if (chosen === 'usual') return state.laws.filter(({ set }) => set !== 'all').map(({ id }) => id);
  return (Array.isArray(chosen) ? chosen : String(chosen).split(',')).map((id) => String(id).trim()).filter(Boolean);
}

function settingsForm(edit) {
  const set = (key) => (typed) => edit(withSetting(state.lot, 'calibrate', key, typed));
  const chosen = chosenLaws();
  const kind = typeof chosen === 'string' && text.lawSetsWhy[chosen] ? chosen : 'some';
  const ids = new Set(lawIds(chosen));
  const radio = (one) =>
    element(
      'label',
      { class: 'option' },
      element('input', { type: 'radio', name: 'laws', id: 'laws-' + one, value: one, checked: one === kind, change: () => set('laws')(one === 'some' ? [...ids] : one) }),
      element('span', {}, element('b', {}, text.lawSets[one]), element('small', {}, text.lawSetsWhy[one])),
    );
  const law = ({ id, title, parameters }) => {
    const box = element('input', {
      type: 'checkbox',
      id: 'law-' + id,
      checked: ids.has(id),
      change: ({ currentTarget }) => set('laws')(state.laws.map(({ id: one }) => one).filter((one) => (one === id ? currentTarget.checked : ids.has(one)))),
    });
    return element('label', { class: 'option' }, box, element('span', {}, title, element('small', {}, text.parameters(parameters))));
  };
  const method = value('method', 'best');
  return element(
    'div',
    { class: 'form', id: 'law-settings' },
    element(
      'fieldset',
      {},
      element('legend', {}, text.whichLaws),
      element('div', { class: 'options' }, Object.keys(text.lawSets).map(radio)),
      kind === 'some' && element('div', { class: 'options laws' }, state.laws.map(law)),
    ),
    element(
      'div',
      { class: 'fields broad' },
      textField('runs', [text.runs, text.runsWhy], chosenRuns(), set('runs'), { whole: true }),
      choiceField('method', [text.method, ''], Object.entries(text.methods), method, (typed) => {
        const others = typed === 'ga' ? [] : OF_GA;
        edit(others.reduce((lot, key) => withSetting(lot, 'calibrate', key, null), withSetting(state.lot, 'calibrate', 'method', typed)));
      }),
      choiceField('analysis', [text.analysis, ''], Object.entries(text.analyses), value('analysis', 'full'), set('analysis')),
    ),
  );
}

function drawProgress() {
  const bar = place('progress-bar');
  if (!bar) return;
  const known = progress !== null;
  if (known) bar.value = furthest;
  else bar.removeAttribute('value');
  const seconds = Math.round((performance.now() - started) / 1000);
  const more = known ? [text.left(progress.secondsLeft), text.phases[progress.phase] ?? ''].filter(Boolean).join(', ') : text.unknownYet;
  fill(place('progress-words'), element('b', {}, known ? text.percent(furthest) : text.since(seconds)), '\u2002' + more);
  drawFits();
  document.title = known ? text.percent(furthest) + ' \u2013 ' + text.program : text.program;
}

// Shows the progress and the error of each law so far. The laws whose searches are finished come first, ordered by
// error; all other laws follow. All rows are there from the start, so that the page does not jump.
function drawFits() {
  const { laws, devices, runs, continues } = begun;
  const all = devices * runs;
  const searched = progress !== null && progress.phase !== 'runs';
  const rows = laws.map((id, order) => {
    const { runs: finished = 0, devices: fitted = 0, error = null } = progress?.laws?.find((one) => one.id === id) ?? {};
    return { id, order, name: state.laws.find((one) => one.id === id)?.name ?? id, finished, fitted, error, whole: searched || finished >= all };
  });
  rows.sort((a, b) => b.whole - a.whole || (a.whole ? (a.error ?? Infinity) - (b.error ?? Infinity) || a.order - b.order : a.order - b.order));
  // If this identification continues an earlier one, the runs of the earlier one are known only once the program has
  // printed them again.
  const done = ({ finished, fitted, whole }) =>
    !whole ? text.searches(finished, all) : fitted === 0 && !continues ? text.notFitted : devices === 1 || (continues && finished < all) ? text.fitted : text.fittedOn(fitted);
  fill(
    place('fits'),
    rows.map((row) =>
      element(
        'tr',
        { id: 'fit-' + row.id, class: row.whole && row.fitted > 0 ? null : 'muted' },
        element('th', { scope: 'row' }, row.name),
        element('td', { class: 'number' }, row.error === null ? DASH : (100 * row.error).toFixed(1) + '\u202f%'),
        element('td', {}, done(row)),
      ),
    ),
  );
}

// The engine cuts the work into parts by these settings and cannot read them from the lot file. They are therefore
// given as options.
const spelled = () => [...['method', 'analysis'].flatMap((key) => (settings().has(key) ? ['--' + key, String(value(key))] : [])), '--runs', String(chosenRuns())];

export const isIdentifying = () => running !== null;
export const cancelIdentifying = () => running?.abort();

async function identify({ fail }) {
  const before = state.campaign;
  const store = before && before.files.filter(({ path }) => path === 'out/campaign.sqlite');
  running = new AbortController();
  progress = null;
  furthest = 0;
  started = performance.now();
  begun = { laws: lawIds(chosenLaws()), devices: readable(), runs: chosenRuns(), continues: state.parts.length > 0 || store?.length > 0 };
  const clock = setInterval(drawProgress, 1000);
  state.cancelled = false;
  settingsOpen = false;
  changed();
  const ask = async (parts) =>
    (await engine()).identify({
      lotPath,
      files: lotFiles(),
      options: spelled(),
      parts,
      signal: running.signal,
      onProgress: (told) => {
        progress = told;
        furthest = Math.max(furthest, Math.min(1, told.share));
        drawProgress();
      },
    });
  const of = present(),
    lots = state.lots;
  try {
    const parts = state.parts.length > 0 ? state.parts : store?.length > 0 ? store : undefined;
    let result = await ask(parts);
    // The program writes no summary if it refuses to continue the earlier campaign, for example because settings have
    // changed. Then everything is computed anew.
    if (parts && !fileOf(result.files, 'out/summary.json')) result = await ask(undefined);
    if (state.lots !== lots) return;
    state.parts = [];
    if (!fileOf(result.files, 'out/summary.json')) throw Object.assign(new Error(text.failed), { complaints: complaintsOf(result) });
    setCampaign(result.files, of);
  } catch (error) {
    if (state.lots !== lots) return;
    if (error.name === 'AbortError') {
      if (error.parts?.length > 0) Object.assign(state, { parts: error.parts, saved: false });
      state.cancelled = true;
    } else fail(error);
  } finally {
    clearInterval(clock);
    running = null;
    document.title = text.program;
    changed();
    // Moves the focus to the result, but not away from a field in which the user is typing.
    if (document.activeElement === document.body) place(state.campaign && !state.cancelled ? 'laws-title' : 'identify')?.focus();
  }
}

export const knowWorkers = (number) => {
  workers = number;
};

export function drawLaws(use) {
  const node = place('view-laws');
  const { edit, show } = use;
  const page = state.campaign && fileOf(state.campaign.files, 'out/report.html');
  if (running) {
    shown = null;
    if (place('progress-bar')) return;
    fill(
      node,
      element('h2', { tabindex: '-1', id: 'laws-title' }, text.running),
      element(
        'div',
        { class: 'running' },
        element('p', { id: 'progress-words' }),
        element('progress', { id: 'progress-bar', max: '1', 'aria-label': text.running }),
        element(
          'p',
          { class: 'next' },
          button(text.cancel, ({ currentTarget }) => {
            currentTarget.disabled = true;
            currentTarget.textContent = text.cancelling;
            running?.abort();
          }, { class: 'action', id: 'cancel' }),
          element('span', { class: 'muted' }, text.mayLeave),
        ),
      ),
      element(
        'table',
        { class: 'fits' },
        element('caption', {}, text.soFar),
        element('thead', {}, element('tr', {}, [[text.law, ''], [text.error, 'number'], [text.searched, '']].map(([title, className]) => element('th', { scope: 'col', class: className || null }, title)))),
        element('tbody', { id: 'fits' }),
      ),
    );
    drawProgress();
    place('cancel').focus({ preventScroll: true });
    return;
  }
  const devices = readable();
  const laws = lawIds(chosenLaws());
  const runs = chosenRuns();
  const showSettings = !page || settingsOpen;
  const doubt = resultsDoubt();
  const start = button(page ? text.identifyAgain : text.identify, () => identify(use), { class: page && !settingsOpen && !doubt ? 'action' : 'action main', id: 'identify', disabled: devices === 0 || laws.length === 0 });
  const heading = element('h2', { tabindex: '-1', id: 'laws-title', class: page && !settingsOpen ? 'hidden' : null }, text.laws);

  if (page && !showSettings) {
    const key = [page, doubt, state.cancelled, start.disabled, state.lot === null];
    if (shown && key.every((one, i) => one === shown[i])) return;
    shown = key;
    const change = state.lot !== null && button(text.change, () => {
      settingsOpen = true;
      changed();
      place('laws-title').focus();
    }, { class: 'action', id: 'change' });
    const { tools, frame } = reportFrame('report-frame', text.reportFrame, page, lotName() + '-report.html', [
      (doubt || state.cancelled) &&
        element('div', { class: 'told' }, doubt && element('p', { class: 'care', id: 'laws-doubt' }, doubt), state.cancelled && element('p', { role: 'status', id: 'laws-said' }, text.cancelled)),
      button(text.toSave, () => show('save'), { class: doubt ? 'action' : 'action main', id: 'to-save' }),
      state.lot !== null && start,
      change,
    ]);
    fill(node, heading, tools, frame);
    return;
  }
  shown = null;
  fill(
    node,
    heading,
    state.cancelled && element('p', { class: 'hint', role: 'status', id: 'laws-said' }, text.cancelled),
    state.lot !== null && lotTables().tables && settingsForm(edit),
    element(
      'p',
      { class: 'next start' },
      start,
      settingsOpen && button(text.done, () => {
        settingsOpen = false;
        changed();
      }, { class: 'action' }),
      element('span', { class: 'muted' }, devices === 0 ? (state.problems.length > 0 ? '' : text.noDevice) : laws.length === 0 ? text.noLaw : visible(text.work(devices, laws.length, runs) + text.workers(workers))),
    ),
    devices === 0 && state.problems.length > 0 && element('div', { class: 'poor' }, problemList(state.problems)),
  );
}
