// The view "Save": it saves everything as one file, single files, or a law for an analysis program.

import { button, element, fill, place, visible } from './dom.js';
import { asBytes, complaintsOf, fileOf, run } from './engine_use.js';
import { download } from '../src/isolaw/render/page/script/download.js';
import { choiceField, flagField } from './fields.js';
import { problemList } from './records.js';
import { fileName, lotName, markerFile, outdated, resultsDoubt } from './lot.js';
import { state } from './state.js';
import { text } from './text.js';
import { writeZip } from './zip.js';

const TYPES = { html: 'text/html', json: 'application/json', toml: 'application/toml', zip: 'application/zip' };
let said = []; // messages about the last export
let exportsOf = null; // the campaign to which `said` belongs
const chosen = { law: null, device: null, to: 'opensees-cpp', units: 'kN-mm', anyway: false };

// Returns the files of a whole saved campaign: the lot file, the records, the results below out/ as the command line
// names them, and finished work of a cancelled campaign.
const wholeFiles = () => [
  ...(state.lot === null ? [] : [{ path: 'lot.toml', bytes: asBytes(state.lot) }]),
  ...[...state.files].map(([path, bytes]) => ({ path, bytes })),
  ...(state.campaign?.files ?? []),
  ...state.parts,
  markerFile(),
];

const saveWhole = async () => {
  download(lotName() + '.isolaw.zip', await writeZip(wholeFiles()), TYPES.zip);
  state.saved = true;
};

const under = (files, folder) => files.filter(({ path }) => path.startsWith(folder));

async function saveTables() {
  const tables = [
    ...under(state.campaign?.files ?? [], 'out/tables/').map(({ path, bytes }) => ({ path: path.slice('out/'.length), bytes })),
    ...under(state.inspectionFiles, 'tables/').map(({ path, bytes }) => ({ path: 'inspection/' + path, bytes })),
  ];
  download(lotName() + '-tables.zip', await writeZip(tables), TYPES.zip);
}

function singles() {
  const files = state.campaign?.files ?? [];
  const all = [
    ['report.html', fileOf(files, 'out/report.html')],
    ['inspection.html', fileOf(state.inspectionFiles, 'inspection.html')],
    ['lot.toml', state.lot === null ? null : asBytes(state.lot)],
    ['summary.json', fileOf(files, 'out/summary.json')],
    ['inspection.json', fileOf(state.inspectionFiles, 'inspection.json')],
  ].filter(([, bytes]) => bytes);
  const ofResults = (file) => /^(report|summary|tables)/.test(file) && outdated();
  const rows = all.map(([file, bytes]) => ({ file, old: ofResults(file), press: () => download(file === 'lot.toml' ? file : lotName() + '-' + file, bytes, TYPES[file.split('.').pop()]), size: text.size(bytes.length) }));
  if (all.length > 0) rows.push({ file: 'tables.zip', old: ofResults('tables.zip'), press: saveTables, size: '' });
  return rows;
}

const fileOfExport = () => fileName([chosen.law, chosen.device].join('-')) + (chosen.to === 'opensees-cpp' ? '-opensees' : '') + '.' + text.extensions[chosen.to];

async function makeExport() {
  const file = fileOfExport();
  const words = ['export', 'out', '--law', chosen.law, '--device', chosen.device, '--to', chosen.to, '--out', file];
  if (chosen.units !== 'kN-mm') words.push('--units', chosen.units);
  if (chosen.anyway) words.push('--anyway');
  said = [];
  const result = await run(words, under(state.campaign.files, 'out/').filter(({ path }) => /\.(sqlite|json)$/.test(path)), ['*']);
  const written = result.files.filter(({ path }) => !path.startsWith('out/'));
  for (const { path, bytes } of written) download(path.replace(/^.*\//, ''), bytes);
  // The command prints the name of the written file. The page already shows it, so this line is left out.
  const warnings = result.stderr.split('\n').filter((line) => line !== file).join('\n').trim();
  said = [
    written.length > 0 ? element('p', { class: warnings || resultsDoubt() ? 'care' : 'good' }, visible(text.exported(written.map(({ path }) => path).join(', ')))) : null,
    written.length > 0 && resultsDoubt() && element('p', { class: 'care' }, resultsDoubt()),
    written.length > 0 ? warnings && element('pre', { tabindex: '0' }, visible(warnings)) : element('div', { class: 'poor' }, problemList(complaintsOf(result))),
  ];
}

export function drawSave({ busy, show }) {
  const node = place('view-save');
  if (exportsOf !== state.campaign) {
    exportsOf = state.campaign;
    said = [];
    chosen.anyway = false;
  }
  const summary = state.campaign?.summary;
  const laws = summary?.laws.map(({ id }) => id) ?? [];
  if (!laws.includes(chosen.law)) chosen.law = laws.includes(summary?.recommendation?.law) ? summary.recommendation.law : (laws[0] ?? null);
  const title = (id) => state.laws.find((one) => one.id === id)?.title ?? id;
  const devices = summary?.devices.filter(({ status }) => status === 'ok').map(({ name: one }) => one) ?? [];
  // A law for the whole lot exists only if analyses were made and the lot has at least two devices.
  const ofLot = summary?.settings.analysis !== 'none' && devices.length > 1;
  if (chosen.device === null || (chosen.device === 'lot' ? !ofLot : !devices.includes(chosen.device))) chosen.device = ofLot ? 'lot' : (devices[0] ?? null);
  const choose = (key) => (picked) => {
    chosen[key] = picked;
    said = [];
    fill(place('export-said'));
  };
  const doubt = resultsDoubt();
  fill(
    node,
    element('h2', { tabindex: '-1', id: 'save-title' }, text.save),
    doubt &&
      element(
        'div',
        { class: 'band care', id: 'save-doubt' },
        element('p', {}, doubt),
        state.lot !== null && element('p', { class: 'next' }, button(text.toLaws, () => show('laws'), { class: 'action' })),
      ),
    element(
      'section',
      { class: 'card', 'aria-labelledby': 'whole-title' },
      element('h3', { id: 'whole-title' }, text.whole),
      element('p', { class: 'fine' }, (state.campaign ? text.wholeWhy : text.wholeEarly) + (state.parts.length > 0 ? ' ' + text.wholeParts : '')),
      element('p', { class: 'next' }, button(text.download(lotName() + '.isolaw.zip'), () => busy(text.save, saveWhole), { class: 'action main', id: 'save-whole' })),
    ),
    element(
      'section',
      { class: 'card', 'aria-labelledby': 'files-title' },
      element('h3', { id: 'files-title' }, text.files),
      element(
        'ul',
        { class: 'downloads' },
        singles().map(({ file, press, size, old }) =>
          element(
            'li',
            {},
            button(file, press, { class: 'action', id: 'save-' + file.replace('.', '-'), 'aria-label': text.download(file) }),
            element('span', {}, text.fileOf[file], size && element('small', {}, size), old && element('small', { class: 'care' }, text.old)),
          ),
        ),
      ),
    ),
    element(
      'section',
      { class: 'card form', 'aria-labelledby': 'export-title' },
      element('h3', { id: 'export-title' }, text.export),
      element('p', { class: 'fine' }, summary ? text.exportWhy : text.exportNone),
      summary?.recommendation &&
        element('p', { id: 'answers' }, visible(summary.recommendation.answer), ' ', element('small', {}, visible(summary.recommendation.sure))),
      summary &&
        element(
          'div',
          { class: 'fields broad' },
          choiceField('export-law', [text.law, ''], laws.map((id) => [id, title(id)]), chosen.law, choose('law')),
          choiceField('export-device', [text.ofDevice, ''], [...(ofLot ? [['lot', text.ofLot]] : []), ...devices.map((one) => [one, visible(one)])], chosen.device, choose('device')),
          choiceField('export-to', [text.target, ''], Object.entries(text.targets), chosen.to, choose('to')),
          choiceField('export-units', [text.unitsOf, ''], ['kN-mm', 'N-m', 'kip-in'].map((one) => [one, one]), chosen.units, choose('units')),
          flagField('export-anyway', [text.anyway], chosen.anyway, (on) => choose('anyway')(on === true)),
        ),
      summary && element('p', { class: 'next' }, button(text.makeExport, () => busy(text.exporting, makeExport), { class: 'action main', id: 'make-export' })),
      element('div', { id: 'export-said', role: 'status' }, said),
    ),
  );
}
