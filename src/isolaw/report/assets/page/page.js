// The page

const drawn = new Map(); // figure -> {node, body, caption, seen, stale}

// Room for a plot before it is drawn, so that nothing moves when it is.
function reserve(figure) {
  const { body } = drawn.get(figure);
  const height = figure.height(body.clientWidth);
  body.style.height = height + 'px';
  return height;
}

function render(figure) {
  const place = drawn.get(figure);
  if (place.stale && figure.build) place.body.replaceChildren(figure.build());
  place.stale = false;
  if (figure.caption) place.caption.textContent = figure.caption();
  if (!figure.draw) return;
  const look = theme();
  const width = place.body.clientWidth,
    height = reserve(figure);
  const { traces, layout } = figure.draw(look, width);
  place.body.setAttribute('aria-label', figure.title + '. ' + (figure.caption ? figure.caption() : ''));
  Plotly.react(place.body, traces, styled({ ...layout, width, height }, look), {
    ...PLOT_CONFIG,
    displayModeBar: width > 480 ? 'hover' : false,
  });
}

// Everything that depends on what changes is drawn again; what is out of sight waits until it is seen.
function choose(changes) {
  Object.assign(chosen, changes);
  for (const follow of followers) follow();
  for (const [figure, place] of drawn) {
    if (!figure.depends?.some((key) => key in changes)) continue;
    place.stale = true;
    if (place.seen) render(figure);
  }
}

function buildFigure(figure, observer) {
  const head = figure.title === '' ? null : element('div', { class: 'figure-head' }, element('h3', {}, figure.title));
  if (head && figure.csv) {
    const button = element(
      'button',
      { type: 'button', class: 'csv', 'aria-label': 'Download the data of \u201c' + figure.title + '\u201d as CSV' },
      'CSV',
    );
    button.addEventListener('click', () => download('isolaw-' + figure.id + '.csv', figure.csv()));
    head.append(button);
  }
  const controls = figure.controls ? element('div', { class: 'controls' }, ...figure.controls()) : null;
  const body = element('div', figure.draw ? { class: 'plot', role: 'img', 'aria-label': figure.title } : {});
  const caption = figure.caption ? element('figcaption') : null;
  const node = element(
    'figure',
    { id: 'figure-' + figure.id, class: [figure.width ?? '', figure.long ? 'long' : ''].join(' ').trim() || null },
    head,
    controls,
    body,
    caption,
  );
  if (figure.build) body.append(figure.build());
  if (figure.caption) caption.textContent = figure.caption();
  drawn.set(figure, { node, body, caption, seen: false, stale: Boolean(figure.draw) });
  observer.observe(node);
  node.figure = figure;
  return node;
}

function buildPage() {
  const refused = devices.length - usable.length;
  document.getElementById('title').textContent = report.title || 'Isolation devices';
  if (inspection) document.getElementById('kind').textContent = 'Test records';
  document.getElementById('facts').textContent = [
    count(devices.length, 'device') + (refused > 0 ? ' (' + refused + ' refused)' : ''),
    ...(inspection ? [] : [count(laws.length, 'law'), 'seed ' + report.seed]),
    'isolaw ' + report.isolaw,
  ].join(' \u00b7 ');
  document.getElementById('colophon').textContent =
    'Made by isolaw ' +
    report.isolaw +
    (inspection ? ' from the test records' : ' from the campaign\u2019s store') +
    '. This file needs no network';
  document
    .getElementById('colophon')
    .append(element('span', { class: 'screen' }, '; the data of every figure can be saved as CSV'), '.');

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
    if (section.id === 'decision' && report.missing_runs + report.missing_analyses > 0)
      node.append(element('p', { class: 'warnings' }, element('b', {}, incomplete())));
    if (section.id === 'decision')
      node.append(element('p', { class: 'headline' }, ...withBadges(report.findings.headline)));
    const grid = element('div', { class: 'figures' });
    if (section.controls) grid.append(element('div', { class: 'controls' }, ...section.controls()));
    grid.append(...figures.map((figure) => buildFigure(figure, observer)));
    node.append(grid);
    main.append(node);
    contents.append(element('a', { href: '#' + section.id }, section.title));
  }
  for (const figure of drawn.keys()) if (figure.draw) reserve(figure);
  markCurrentSection(main, contents);
  if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView(); // now that it exists
}

// A decision on part of the campaign may change.
const incomplete = () =>
  'Not complete: ' +
  [
    report.missing_runs > 0 ? count(report.missing_runs, 'run') : '',
    report.missing_analyses > 0 ? count(report.missing_analyses, 'analys') + (report.missing_analyses === 1 ? 'is' : '') : '',
  ]
    .filter(Boolean)
    .join(' and ')
    .replace('analyss', 'analyses') +
  ' missing. What follows may change; the command it was started with continues the campaign.';

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

function redraw({ everything = false } = {}) {
  for (const [figure, place] of drawn) {
    if (figure.draw) {
      place.stale = true;
      reserve(figure);
    }
    if (everything || (place.seen && place.stale)) render(figure);
  }
}

// On paper: light colours, the width of the page, every figure and every table.
window.addEventListener('beforeprint', () => {
  document.documentElement.dataset.printing = '';
  redraw({ everything: true });
  for (const details of document.querySelectorAll('details.law')) details.print();
  for (const details of document.querySelectorAll('.warnings details, .steps.warned')) details.open = true;
});
window.addEventListener('afterprint', () => {
  delete document.documentElement.dataset.printing;
  for (const details of document.querySelectorAll('details.law')) details.restore();
  redraw();
  for (const [figure, place] of drawn) if (figure.caption) place.caption.textContent = figure.caption();
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
