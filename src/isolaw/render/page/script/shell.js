import { button, element } from './dom.js';
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
  // The address of the page may name a section, followed by a question mark and the reader's choices. The page is
  // scrolled to the section here, because the section exists only now.
  const [section] = location.hash.slice(1).split('?');
  if (section) document.getElementById(section)?.scrollIntoView();
}

// Makes buttons that write a system of units into the address; followAddress() then loads the page again in these
// units. Inside the web page that runs isolaw (page/), a report comes from a blob in a sandboxed frame and cannot
// change its address. It then asks that web page to open it again in these units.
function unitsChooser() {
  const press = ({ currentTarget: { value } }) => {
    const [section, rest] = location.hash.slice(1).split('?');
    const asked = new URLSearchParams(rest);
    asked.set('units', value);
    const address = '#' + section + '?' + asked;
    if (location.protocol === 'blob:' && window.parent !== window) window.parent.postMessage('isolaw: open ' + address, '*');
    else location.hash = address;
  };
  const buttons = UNIT_SYSTEMS.map((id) => button(id, press, { value: id, 'aria-pressed': String(id === UNITS) }));
  return element('div', { class: 'units choice screen', role: 'group', 'aria-label': 'Units' }, buttons);
}

// Follows the page's address, which may change by a link or by hand. `read` takes the reader's choices from it, and
// `write` adds them to an address that lacks them. In other units the page is loaded again, because every number,
// sentence and plot changes.
export function followAddress({ read = () => {}, write }) {
  read();
  window.addEventListener('hashchange', () => {
    const units = new URLSearchParams(location.hash.split('?')[1]).get('units');
    if (UNIT_SYSTEMS.includes(units) && units !== UNITS) return location.reload();
    read();
    return write();
  });
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
