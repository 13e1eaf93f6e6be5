// Measures the layout of the report in a browser: the labels of figures, the table of contents, tables on screen and on
// paper, the order of their rows, bars that are cut off, and what the page shows before the reader chooses anything.
//   node report_layout.mjs MAKE_PAGE [CHROMIUM]
import { withBrowser } from './page_of.mjs';

const [makePage, program] = process.argv.slice(2);
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// Returns the labels and markers of the laws in the plot of accuracy against robustness, with their boxes. This
// function runs in the page.
async function look_at_front() {
  document.getElementById('figure-front').scrollIntoView();
  await new Promise((done) => setTimeout(done, 300));
  const plot = document.querySelector('#figure-front .plot');
  const box = (node) => {
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return { left, top, right, bottom };
  };
  return {
    laws: reportAsShown().laws.map(({ id }) => id).sort(),
    labels: [...plot.querySelectorAll('.annotation-text')].map((node) => ({ text: node.textContent, ...box(node) })),
    markers: [...plot.querySelectorAll('.scatterlayer .point')].map(box),
    // The plot joins each label to its marker by a line. These are 21 points along each line.
    leaders: [...plot.querySelectorAll('.annotation')].flatMap((node) => {
      const line = node.querySelector('.annotation-arrow-g path');
      if (!line || getComputedStyle(line).stroke === 'rgba(0, 0, 0, 0)') return [];
      const along = Array.from({ length: 21 }, (_, k) => line.getPointAtLength((k / 20) * line.getTotalLength()).matrixTransform(line.getScreenCTM()));
      return [{ text: node.querySelector('.annotation-text').textContent, points: along.map(({ x, y }) => [x, y]) }];
    }),
    plot: box(plot.querySelector('.bglayer .bg') ?? plot.querySelector('.draglayer .nsewdrag')),
  };
}

function check_front(expect, name, { laws, labels, markers, leaders, plot }) {
  const meet = (a, b) => a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5;
  expect(same(labels.map(({ text }) => text).sort(), laws), name, 'labels ' + labels.map(({ text }) => text));
  expect(markers.length === laws.length, name, `${markers.length} markers of ${laws.length} laws`);
  labels.forEach((a, i) => {
    for (const b of labels.slice(0, i)) expect(!meet(a, b), name, `${a.text} lies on ${b.text}`);
    expect(!markers.some((marker) => meet(a, marker)), name, a.text + ' lies on a marker');
    const inside = a.left >= plot.left && a.right <= plot.right && a.top >= plot.top && a.bottom <= plot.bottom;
    expect(inside, name, a.text + ' leaves the plot');
  });
  for (const { text, points } of leaders)
    for (const label of labels.filter((one) => one.text !== text)) {
      const crossed = points.some(([x, y]) => x > label.left + 1 && x < label.right - 1 && y > label.top + 2 && y < label.bottom - 2);
      expect(!crossed, name, `the line of ${text} crosses ${label.text}`);
    }
}

// Returns the bars of errors in the table of laws: the width of each, and its error. This function runs in the page.
function look_at_errors() {
  const { standings } = reportAsShown().findings.recommendation;
  const rows = [...document.querySelectorAll('#figure-laws tbody tr')];
  return rows.map((row, i) => {
    const bars = [...row.querySelectorAll('.bar')];
    return {
      law: row.querySelector('b').textContent, place: standings[i].place,
      bars: bars.map((bar) => ({ width: bar.getBoundingClientRect().width, error: Number(bar.closest('td').dataset.sort), cut: bar.matches('.cut') })),
    };
  });
}

function check_errors(expect, name, rows) {
  const columns = rows[0].bars.length;
  expect(columns > 0, name, 'no bar');
  for (let k = 0; k < columns; ++k) {
    const bars = rows.map(({ bars }) => bars[k]).filter(Boolean);
    const whole = bars.filter(({ cut }) => !cut),
      scales = whole.map(({ width, error }) => width / error),
      largest = Math.max(...bars.map(({ width }) => width));
    expect(Math.max(...scales) < 1.05 * Math.min(...scales), name, `error ${k}: widths ${bars.map(({ width }) => width)}`);
    for (const { width, error } of bars.filter(({ cut }) => cut))
      expect(width === largest && whole.every((other) => other.error < error), name, `error ${k}: cut at ${width}`);
  }
  expect(rows.some(({ bars }) => bars.some(({ cut }) => cut)), name, 'no bar is cut');
}

// Returns the column heads of all visible tables, by the label of the table. On paper a wide table is printed in
// several parts, whose heads are joined here. This function runs in the page.
function heads() {
  const found = {};
  for (const region of document.querySelectorAll('.scroll')) {
    // Pages of single devices are printed only together with the certificate, so they are left out here.
    if (region.getClientRects().length === 0 || region.closest('.device-page')) continue;
    const tables = [...region.querySelectorAll('table')].filter((table) => table.getClientRects().length > 0);
    const texts = tables.flatMap((table) =>
      [...table.tHead.rows[0].cells].filter((head) => head.getClientRects().length > 0).map((head) => head.textContent),
    );
    const own = (found[region.getAttribute('aria-label')] ??= { columns: [], wide: 0, broken: [] });
    own.columns = [...new Set([...own.columns, ...texts])].sort();
    own.wide = Math.max(own.wide, ...tables.map((table) => table.getBoundingClientRect().width - region.clientWidth));
    // Collects the words in a column head that the browser broke over two lines.
    for (const head of tables.flatMap((table) => [...table.querySelectorAll('thead th')])) {
      const texts = document.createTreeWalker(head, window.NodeFilter.SHOW_TEXT);
      while (texts.nextNode())
        for (const word of texts.currentNode.textContent.matchAll(/[\p{L}\d_]{2,}/gu)) {
          const range = document.createRange();
          range.setStart(texts.currentNode, word.index);
          range.setEnd(texts.currentNode, word.index + word[0].length);
          if (new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1) own.broken.push(word[0]);
        }
    }
  }
  return found;
}

function check_paper(expect, name, screen, paper) {
  expect(Object.keys(screen).length > 5, name, `${Object.keys(screen).length} tables`);
  for (const [label, { columns, broken }] of Object.entries(screen)) {
    expect(paper[label], name, label + ' is not printed');
    const missing = columns.filter((column) => !paper[label]?.columns.includes(column));
    expect(missing.length === 0, name, `${label}: not printed ${missing.join(', ')}`);
    expect(broken.length === 0, name, `${label}: words broken ${broken}`);
  }
  for (const [label, { wide, broken }] of Object.entries(paper)) {
    expect(wide <= 1, name, `${label} is ${wide.toFixed(0)} pixels wider than the paper`);
    expect(broken.length === 0, name, `${label}: words broken on paper ${broken}`);
  }
}

// Returns which links of the table of contents the window cuts off, and on how many lines the links stand. This
// function runs in the page.
function look_at_contents() {
  const { width } = document.documentElement.getBoundingClientRect();
  const links = [...document.querySelectorAll('nav a')];
  scrollTo(0, 0);
  return {
    sections: document.querySelectorAll('main > section').length,
    cut: links.filter((link) => link.getBoundingClientRect().right > width || link.getBoundingClientRect().left < 0).map((link) => link.textContent),
    links: links.length,
    lines: new Set(links.map((link) => Math.round(link.getBoundingClientRect().top))).size,
  };
}

// Sorts every table by each of its columns and returns what went wrong, such as rows in the wrong order. This function
// runs in the page.
async function look_at_sorting() {
  const number = (text) => Number(text.replace('\u2212', '-').replace(/^[+\u00b1>]/, '').split(/[^\d.-]/)[0]);
  const seen = [];
  for (const table of document.querySelectorAll('.scroll table')) {
    const rows = () => [...table.tBodies[0].rows].map((row) => row.textContent);
    const label = table.parentNode.getAttribute('aria-label'),
      buttons = [...table.tHead.querySelectorAll('button.sort')],
      heads = table.tHead.rows[0].cells.length,
      before = rows();
    const one = { label, rows: before.length, heads, buttons: buttons.length, wrong: [] };
    seen.push(one);
    for (const button of buttons) {
      const head = button.closest('th'),
        place = head.cellIndex;
      const values = () => [...table.tBodies[0].rows].map((row) => row.cells[place]).filter((cell) => cell && cell.colSpan === 1 && !cell.querySelector('small')).map((cell) => cell.textContent.trim());
      button.focus();
      for (const wanted of ['ascending', 'descending', null]) {
        if (wanted === 'ascending' && head.getAttribute('aria-sort') === 'ascending') continue;
        button.click();
        if (head.getAttribute('aria-sort') !== wanted) one.wrong.push(`${button.textContent}: ${head.getAttribute('aria-sort')}, not ${wanted}`);
        if (table.tHead.querySelectorAll('[aria-sort]').length !== (wanted ? 1 : 0)) one.wrong.push(button.textContent + ': several sort');
        const numbers = values().filter((text) => /^[\u2212+]?[\d.]+$/.test(text)).map(number);
        const size = /error|Deviation/.test(button.textContent) ? Math.abs : (value) => value;
        const [low, high] = wanted === 'descending' ? [1, 0] : [0, 1];
        const fine = numbers.every((_, i) => i === 0 || size(numbers[i - 1 + low]) <= size(numbers[i - 1 + high]));
        if (wanted && head.matches('.number') && !fine) one.wrong.push(`${button.textContent} ${wanted}: ${numbers}`);
        if (document.activeElement !== button) one.wrong.push(button.textContent + ' loses the focus');
      }
      if (JSON.stringify([...rows()].sort()) !== JSON.stringify([...before].sort())) one.wrong.push(button.textContent + ' changes the rows');
    }
  }
  return seen;
}

// Returns what the figures show before the reader chooses anything. This function runs in the page.
async function look_at_first() {
  const report = reportAsShown();
  const loop = document.getElementById('figure-loop');
  loop.scrollIntoView();
  await new Promise((done) => setTimeout(done, 400));
  const device = Number(document.getElementById('device').value);
  const axis = loop.querySelector('.plot').layout.yaxis.range;
  const measured = loop.querySelector('.plot').data.find(({ name }) => name === 'measured').y.filter((value) => value !== null);
  const ticked = [...document.querySelectorAll('#loops input:checked')].map((box) => box.closest('label').textContent);
  // The reader chooses a law that computes huge forces. The axis must still show the record at a readable size.
  const away = report.laws.find(({ prediction_grade: grade }) => grade === 'unusable');
  const box = [...document.querySelectorAll('#loops input')].find((one) => one.closest('label').textContent === away.id);
  box.click();
  await new Promise((done) => setTimeout(done, 300));
  const withAway = loop.querySelector('.plot').layout.yaxis.range;
  const figure = document.getElementById('figure-predicted-loops');
  figure.scrollIntoView();
  await new Promise((done) => setTimeout(done, 400));
  const panels = figure.querySelector('.plot').data.length;
  const chooser = document.getElementById('predicted-law');
  const names = () => figure.querySelector('.plot').layout.annotations.map(({ text }) => text.replace(/<[^>]*>/g, ''));
  const first = names();
  chooser.value = String(report.laws.indexOf(away));
  chooser.dispatchEvent(new Event('change'));
  await new Promise((done) => setTimeout(done, 300));
  const best = report.laws.filter((law) => law.predicted_objective !== null).sort((a, b) => a.predicted_objective - b.predicted_objective)[0].id;
  return {
    device, typical: report.typical_device, axis, extent: [Math.min(...measured), Math.max(...measured)], ticked,
    bad: report.laws.filter(({ prediction_grade: grade }) => ['poor', 'unusable'].includes(grade)).map(({ id }) => id),
    taken: report.findings.recommendation.law, withAway, away: away.id, said: loop.querySelector('figcaption').textContent,
    panels, first, best, chosen: names(), predicted: figure.querySelector('figcaption').textContent,
    byObjective: report.by_objective.map((i) => report.laws[i].id),
    accuracy: document.querySelector('#figure-objective-devices .plot').data?.filter(({ mode }) => mode === 'markers').map(({ name }) => name),
    symbols: document.querySelector('#figure-objective-devices .plot').data?.filter(({ mode }) => mode === 'markers').map(({ marker }) => marker.symbol),
    wantedSymbols: report.by_objective.map((i) => report.symbols[i % report.symbols.length]),
  };
}

function check_first(expect, name, seen) {
  const [low, high] = seen.extent;
  expect(seen.device === seen.typical, name, `device ${seen.device}, typical ${seen.typical}`);
  expect(seen.ticked.length > 0 && seen.ticked.includes(seen.taken), name, 'ticked ' + seen.ticked);
  expect(seen.ticked.every((law) => !seen.bad.includes(law)), name, `ticked ${seen.ticked}, of them poor ${seen.bad}`);
  for (const [bottom, top] of [seen.axis, seen.withAway])
    expect(top - bottom < 2.3 * (high - low), name, `the record has ${high - low} kN of an axis of ${top - bottom}`);
  expect(seen.said.includes('Off the scale: ' + seen.away), name, 'caption of the loops ' + seen.said);
  expect(seen.panels === 4 && seen.first[0] === seen.best, name, `panels of the prediction ${seen.first}`);
  expect(same(seen.chosen, [seen.best, seen.away]), name, 'panels of the prediction chosen ' + seen.chosen);
  expect(seen.predicted.includes('left out of the fit') && seen.predicted.includes(seen.best + ': OF'), name, seen.predicted);
  expect(same(seen.accuracy, seen.byObjective), name, 'order of the laws ' + seen.accuracy);
  expect(same(seen.symbols, seen.wantedSymbols), name, 'symbols ' + seen.symbols);
}

await withBrowser(program, makePage, async ({ open, expect }) => {
  for (const laws of [3, 5, 7, 9, 12]) {
    const page = await open({ devices: 4, laws, state: laws > 4 ? 'crowded' : 'analysed', width: 1366 });
    for (const width of [1366, 390]) {
      await page.resize(width);
      check_front(expect, `${laws} laws at ${width}`, await page.evaluate(`(${look_at_front})()`));
      if (laws > 4) check_errors(expect, `errors of ${laws} laws at ${width}`, await page.evaluate(`(${look_at_errors})()`));
    }
    await page.print();
    check_front(expect, `${laws} laws on paper`, await page.evaluate(`(${look_at_front})()`));
    await page.close();
  }

  for (const one of [
    { name: 'calibration', devices: 10, laws: 7, state: 'predicted' },
    { name: 'inspection', devices: 10, laws: 3, records: { laws: false } },
  ]) {
    const page = await open({ ...one, width: 1366 });
    for (const width of [1366, 1024, 390]) {
      await page.resize(width);
      const seen = await page.evaluate(`(${look_at_contents})()`);
      // A telephone shows the contents in one line, which scrolls.
      const scrolls = width < 640 && (await page.evaluate("getComputedStyle(document.getElementById('contents')).overflowX")) === 'auto';
      expect(seen.links === seen.sections && (scrolls || seen.cut.length === 0), one.name, `contents at ${width}: cut ${seen.cut}`);
      expect(width < 1366 || seen.lines === 1, one.name, `contents in ${seen.lines} lines at ${width}`);
    }
    await page.resize(1366);
    await page.evaluate("for (const details of document.querySelectorAll('details')) details.open = true; new Promise((done) => setTimeout(done, 200))");
    for (const table of await page.evaluate(`(${look_at_sorting})()`)) {
      const matrix = table.label.startsWith('Correlation of the parameters');
      expect(table.buttons === (table.rows > 3 && !matrix ? table.heads : 0), one.name, `${table.label}: ${table.buttons} of ${table.heads} heads sort ${table.rows} rows`);
      expect(table.wrong.length === 0, one.name, `${table.label}: ${table.wrong.slice(0, 3).join('; ')}`);
    }
    const screen = await page.evaluate(`(${heads})()`);
    await page.print();
    check_paper(expect, one.name, screen, await page.evaluate(`(${heads})()`));
    await page.evaluate("dispatchEvent(new Event('afterprint'))");
    await page.send('Emulation.setEmulatedMedia', { media: 'screen' });
    expect((await page.evaluate("document.querySelectorAll('table.part, table[hidden]').length")) === 0, one.name, 'tables stay in parts');
    await page.close();
  }

  const page = await open({ devices: 4, laws: 7, state: 'predicted', width: 1366 });
  await page.evaluate("document.getElementById('figure-objective-devices').scrollIntoView(); new Promise((done) => setTimeout(done, 400))");
  check_first(expect, 'first', await page.evaluate(`(${look_at_first})()`));
  expect(page.errors.length === 0, 'first', page.errors.join('; '));
  await page.close();
});
