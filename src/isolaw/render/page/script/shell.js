import { element } from './dom.js';
import { buildFigure, drawn, redraw, redrawDependents, render, reserve } from './figure.js';
import { joinTables, partTables } from './tables.js';
import { typeset } from './symbols.js';
import { UNITS, UNIT_SYSTEMS } from './units.js';

// Builds the sections of a page from objects {id, title, short, figures, controls, adorn}. Before the figures of a
// section exist, adorn(element) may change the section's look, and opened(section, element) is called. onChoice(f)
// makes the page call f after each choice of its reader.
export function showSections(sections, { onChoice, opened = () => {} }) {
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

  document.querySelector('.masthead').append(unitsChooser());
  const main = document.getElementById('report'),
    contents = document.getElementById('contents');
  for (const section of sections) {
    const figures = section.figures.filter((figure) => figure.wanted?.() ?? true);
    if (figures.length === 0) continue;
    const node = element(
      'section',
      { id: section.id, 'aria-labelledby': section.id + '-title' },
      element('h2', { id: section.id + '-title' }, section.title),
    );
    section.adorn?.(node);
    opened(section, node);
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
  // The address may name a section, and after a question mark what its reader chose. The section can be scrolled to only
  // now that it exists.
  const [section] = location.hash.slice(1).split('?');
  if (section) document.getElementById(section)?.scrollIntoView();
}

// The page is loaded again in the chosen units, because every number, sentence and plot changes. A page in a frame of
// another origin cannot load itself, so it asks the page around it; without an answer the units stay as they are.
function unitsChooser() {
  const follow = () => {
    const [section, rest] = location.hash.slice(1).split('?');
    const asked = new URLSearchParams(rest ?? '');
    asked.set('units', select.value);
    const address = '#' + section + '?' + asked;
    if (window.parent !== window) {
      window.parent.postMessage('isolaw: open ' + address, '*');
      setTimeout(() => (select.value = UNITS), 1000);
      return;
    }
    history.replaceState(null, '', address);
    location.reload();
  };
  const select = element('select', { id: 'units', change: follow }, UNIT_SYSTEMS.map((id) => element('option', { value: id, selected: id === UNITS }, id)));
  return element('label', { class: 'units screen' }, 'Units', select);
}

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

export function followWindow({ beforePrint = () => {}, afterPrint = () => {} } = {}) {
  // For print, everything is drawn with light colours in the width of paper, including figures and tables out of sight.
  window.addEventListener('beforeprint', () => {
    document.documentElement.dataset.printing = '';
    redraw({ everything: true });
    beforePrint();
    partTables();
  });

  window.addEventListener('afterprint', () => {
    delete document.documentElement.dataset.printing;
    joinTables();
    afterPrint();
    redraw();
    for (const [figure, place] of drawn) if (figure.caption) place.caption.replaceChildren(...typeset(figure.caption()));
  });

  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => redraw());

  // All plots are drawn again if the page's width changes. Drawing changes heights only, so it starts no other drawing.
  let drawnWidth = document.getElementById('report').clientWidth;

  new ResizeObserver(([entry]) => {
    const width = Math.round(entry.contentRect.width);
    if (width === drawnWidth) return;
    drawnWidth = width;
    requestAnimationFrame(() => redraw()); // later, since drawing at once would change the observed height
  }).observe(document.getElementById('report'));
}
