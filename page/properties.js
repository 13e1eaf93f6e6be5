// The view "Properties": it shows the page with cycles, verdicts and the certificate that `isolaw inspect` writes.

import { button, element, fill, place, visible } from './dom.js';
import { fileOf } from './engine_use.js';
import { reportFrame } from './frame.js';
import { lotName } from './lot.js';
import { state } from './state.js';
import { text } from './text.js';

const TONES = { PASS: 'good', FAIL: 'poor', INCOMPLETE: 'care' };
let shown = null;

export function drawProperties({ show }) {
  const page = fileOf(state.inspectionFiles, 'inspection.html');
  if (page && page === shown) return;
  shown = page;
  const node = place('view-properties');
  if (!page) {
    fill(node, element('h2', { class: 'hidden', tabindex: '-1' }, text.properties), element('p', { class: 'empty' }, text.notInspected));
    return;
  }
  const { word, sentence } = state.inspection.result ?? {};
  // The report in the frame gives the reasons of a verdict. Without a verdict, this line says why there is none.
  const verdict = element('p', { class: 'verdict-line' }, word ? element('b', { class: 'word ' + (TONES[word] ?? '') }, word) : visible(sentence ?? text.noVerdict));
  const { tools, frame } = reportFrame('inspection-frame', text.inspectionFrame, page, lotName() + '-inspection.html', [
    verdict,
    !state.inspection.assessment?.rule_set &&
      button(
        text.chooseRules,
        () => {
          show('records');
          place('rules')?.focus();
        },
        { class: 'action', id: 'choose-rules' },
      ),
  ]);
  fill(node, element('h2', { class: 'hidden', tabindex: '-1' }, text.properties), tools, frame);
}
