// The report page: its sections in order, and what draws them anew. The build joins these modules into one script
// (cmake/join_modules.cmake); a folder is a section, a figure a file in it. Text of the input reaches the document through
// textContent only, and plots through plain().

import { accuracySection } from './accuracy/section.js';
import { certificateSection } from './certificate/section.js';
import { onChoice } from './choice.js';
import { decisionSection } from './decision/section.js';
import { determinationSection } from './determination/section.js';
import { devicesSection } from './devices/section.js';
import { element } from './dom.js';
import { buildFigure, drawn, redraw, redrawDependents, render, reserve } from './figure.js';
import { loopsSection } from './loops/section.js';
import { oneLawSection } from './one_law/section.js';
import { parametersSection } from './parameters/section.js';
import { predictionSection } from './prediction/section.js';
import { propertiesSection } from './properties/section.js';
import { provenanceSection } from './provenance/section.js';
import { publishedSection } from './published/section.js';
import { devices, inspection, laws, report, usable } from './report.js';
import { joinTables, partTables } from './tables.js';
import { typeset } from './symbols.js';
import { count } from './text.js';
import { verdictSection } from './verdict/section.js';
import { WORDS } from './verdicts.js';

// In the order of the page.
const SECTIONS = [
  verdictSection, decisionSection, accuracySection, loopsSection, parametersSection, determinationSection, oneLawSection,
  predictionSection, publishedSection, propertiesSection, devicesSection, certificateSection, provenanceSection,
];

function buildPage() {
  const refused = devices.length - usable.length;
  document.getElementById('title').textContent = report.title || 'Isolation devices';
  if (inspection) document.getElementById('kind').textContent = 'Test records';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    ...(inspection ? [] : [count(laws.length, 'law'), 'seed ' + report.seed]),
    'isolaw ' + report.isolaw,
  ].join(' \u00b7 ');
  const { word } = report.result;
  if (word && !inspection)
    document
      .getElementById('facts')
      .append(' \u00b7 ', element('a', { class: 'word ' + WORDS[word].tone, href: '#devices', title: report.result.sentence }, word));
  document.getElementById('colophon').append(
    'Made by isolaw ' + report.isolaw +
      (inspection ? ' from the test records' : ' from the campaign\u2019s store') + '. This file needs no network',
    element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'),
    '.',
  );

  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const place = drawn.get(target.figure);
        place.seen = isIntersecting;
        if (isIntersecting && place.stale) render(target.figure);
      }
    },
    { rootMargin: '300px 0px' },
  );

  const main = document.getElementById('report'),
    contents = document.getElementById('contents');
  for (const section of SECTIONS) {
    const figures = section.figures.filter((figure) => figure.wanted?.() ?? true);
    if (figures.length === 0 || (section.laws && inspection)) continue;
    const node = element(
      'section',
      { id: section.id, 'aria-labelledby': section.id + '-title' },
      element('h2', { id: section.id + '-title' }, section.title),
    );
    section.adorn?.(node);
    if (section.id === 'decision' && report.missing_runs + report.missing_analyses > 0)
      node.append(element('p', { class: 'warnings' }, element('b', {}, incomplete())));
    const grid = element('div', { class: 'figures' });
    const controls = section.controls?.() ?? [];
    if (controls.length > 0) grid.append(element('div', { class: 'controls' }, ...controls));
    grid.append(...figures.map((figure) => buildFigure(figure, observer)));
    node.append(grid);
    main.append(node);
    contents.append(element('a', { href: '#' + section.id }, section.short ?? section.title));
  }
  onChoice(redrawDependents);
  for (const figure of drawn.keys()) if (figure.draw) reserve(figure);
  markCurrentSection(main, contents);
  if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView(); // now that it exists
}

// A decision on part of the campaign may change.
const incomplete = () =>
  'Not complete: ' +
  [[report.missing_runs, 'run', 'runs'], [report.missing_analyses, 'analysis', 'analyses']]
    .filter(([missing]) => missing > 0)
    .map(([missing, one, several]) => missing + ' ' + (missing === 1 ? one : several))
    .join(' and ') +
  ' missing. What follows may change; the last calibrate command there continues the campaign.';

function markCurrentSection(main, contents) {
  const links = new Map([...contents.children].map((link) => [link.hash.slice(1), link]));
  const inView = new Set();
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries)
        isIntersecting ? inView.add(target.id) : inView.delete(target.id);
      const current = [...links.keys()].find((id) => inView.has(id));
      for (const [id, link] of links)
        id === current ? link.setAttribute('aria-current', 'true') : link.removeAttribute('aria-current');
    },
    { rootMargin: '-22% 0px -75% 0px' },
  );
  for (const section of main.children) observer.observe(section);
}

// On paper: light colours, the width of the page, every figure and every table.
window.addEventListener('beforeprint', () => {
  document.documentElement.dataset.printing = '';
  redraw({ everything: true });
  for (const details of document.querySelectorAll('details.law')) details.print();
  for (const details of document.querySelectorAll('.warnings details, .steps.warned, #figure-published-laws details')) details.open = true;
  partTables();
});

window.addEventListener('afterprint', () => {
  delete document.documentElement.dataset.printing;
  joinTables();
  for (const details of document.querySelectorAll('details.law')) details.restore();
  redraw();
  for (const [figure, place] of drawn) if (figure.caption) place.caption.replaceChildren(...typeset(figure.caption()));
});

window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => redraw());

buildPage();

// Plots follow the width of the page, however it changes; drawing them changes its height only.
let drawnWidth = document.getElementById('report').clientWidth;

new ResizeObserver(([entry]) => {
  const width = Math.round(entry.contentRect.width);
  if (width === drawnWidth) return;
  drawnWidth = width;
  requestAnimationFrame(() => redraw()); // not here: what is drawn changes the height that is being observed
}).observe(document.getElementById('report'));
