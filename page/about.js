// The view "About": it shows the version, what happens to the user's data, the self-test and the licences.

import { button, element, fill, place, visible } from './dom.js';
import { engine } from './engine_use.js';
import { text } from './text.js';

async function selfTest(out, press) {
  press.disabled = true;
  fill(out, element('p', {}, text.selfTestRunning));
  try {
    const { ok, found, expected, what } = await (await engine()).selfTest();
    fill(
      out,
      element('p', { class: ok ? 'good' : 'poor' }, element('b', {}, ok ? text.selfTestGood : text.selfTestBad)),
      element('p', { class: 'fine' }, visible([what, text.found + ' ' + found, text.expected + ' ' + expected].filter(Boolean).join('; '))),
    );
  } catch (error) {
    fill(out, element('p', { class: 'poor' }, element('b', {}, text.selfTestBad)), element('p', { class: 'fine' }, visible(error.message)));
  }
  press.disabled = false;
}

export const drawAbout = async () => {
  const node = place('view-about');
  if (node.firstChild) return;
  const version = element('dd', { id: 'version' }, '\u2013'),
    cores = element('dd', {}, '\u2013'),
    tested = element('div', { id: 'self-test-said', role: 'status' }),
    licences = element('div', { id: 'licences' });
  const press = button(text.selfTestRun, () => selfTest(tested, press), { class: 'action', id: 'self-test' });
  fill(
    node,
    element('h2', { tabindex: '-1', id: 'about-title' }, text.about),
    element('div', { class: 'prose' }, element('p', {}, text.aboutIs), element('p', {}, text.aboutPrivacy), element('p', {}, text.differences)),
    element('dl', { class: 'facts-list' }, element('dt', {}, text.version), version, element('dt', {}, text.cores), cores),
    element('section', { class: 'card' }, element('h3', {}, text.selfTest), element('p', { class: 'fine' }, text.selfTestWhy), element('p', { class: 'next' }, press), tested),
    element('section', { class: 'card' }, element('h3', {}, text.licences), licences),
  );
  const started = await engine();
  version.textContent = await started.version();
  cores.textContent = String(started.workers ?? '\u2013');
  const list = started.licences ?? [];
  fill(
    licences,
    list.length === 0
      ? element('p', { class: 'fine' }, text.noLicences)
      : list.map(({ name, version: of, licence, text: words }) =>
          element('details', { class: 'rarely' }, element('summary', {}, visible(name), element('small', {}, ' ' + [of, licence].filter(Boolean).map(visible).join(', '))), element('pre', { tabindex: '0' }, visible(words ?? ''))),
        ),
  );
};
