// Compares what one page shows in two systems of units: every number of its tables and every axis of its plots. A
// number changes by the factor of its unit; a share, a count and a number without a unit do not change.

// Returns the tables and plots of the page, after it has scrolled to every figure. This function runs in the page.
async function shownOnPage() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  for (const figure of document.querySelectorAll('figure')) {
    figure.scrollIntoView();
    await wait(60);
  }
  await wait(300);
  const text = (node) => [...node.childNodes].map((child) => child.textContent.trim()).join(' ').trim();
  const tables = [...document.querySelectorAll('figure table')].map((table) => ({
    figure: table.closest('figure').id,
    head: [...(table.tHead?.rows[0]?.cells ?? [])].map(text),
    rows: [...table.tBodies].flatMap((body) => [...body.rows].map((row) => [...row.cells].map(text))),
  }));
  const captions = [...document.querySelectorAll('figcaption')].map((node) => ({ figure: node.closest('figure').id, text: text(node) }));
  const numbers = (values) => (values === undefined ? [] : Array.from(values).filter((value) => typeof value === 'number' && Number.isFinite(value)).slice(0, 50));
  const plots = [...document.querySelectorAll('.plot')].filter((plot) => plot.data).map((plot) => ({
    figure: plot.closest('figure').id,
    axes: plot.data.filter(({ visible }) => visible !== false).flatMap((trace) =>
      ['x', 'y'].map((letter) => ({
        title: plot.layout[(trace[letter + 'axis'] ?? letter).replace(letter, letter + 'axis')]?.title?.text ?? '',
        values: numbers(trace[letter]),
      }))),
  }));
  const { units } = JSON.parse(document.getElementById('isolaw-data').textContent);
  return { tables, captions, plots, systems: units.systems };
}

export async function shownInUnits(browser, url, units) {
  const page = await browser.open(url + '#?units=' + units, { width: 1366, height: 900 });
  try {
    return { ...(await page.evaluate(`(${shownOnPage})()`)), errors: page.errors };
  } finally {
    await page.close();
  }
}

// Returns for each number in a text: its value, half a unit of its last digit, whether it is a percentage, and the text
// that follows.
function numbersIn(text) {
  const plain = text.replace(/[\u2212\u2013]/g, '-');
  const found = plain.matchAll(/(?<![\w.])(-?\d+(?:\.\d+)?)(?:\u00b710([\u207b\u2070-\u2079\u00b9\u00b2\u00b3]+))?/g);
  return [...found].map((match) => {
    const [whole, digits, power] = match;
    const exponent = [...(power ?? '')].map((c) => (c === '\u207b' ? '-' : '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'.indexOf(c))).join('');
    const scale = 10 ** Number(exponent);
    const last = digits.includes('.') ? -digits.split('.')[1].length : digits.match(/0*$/)[0].length;
    const after = plain.slice(match.index + whole.length).replace(/^[\s\u00a0\u202f]/, '');
    return { value: Number(digits) * scale, half: 0.5 * 10 ** last * scale, isShare: after.startsWith('%'), after };
  });
}

// Texts that stay in kN and mm, as docs/report.md says: the reason why a device is refused, and values of parameters.
const KEPT = /^refused: |is held at each point and all others are fitted again/;

// Returns a line for each contradiction between what a page shows in kN and mm and what it shows in other units, and
// how many numbers were compared.
export function compareUnits(stored, other, id) {
  const { units } = stored.systems.find((system) => system.id === id);
  const names = Object.keys(units).sort((a, b) => b.length - a.length);
  const failures = [];
  let compared = 0;
  const word = (unit) => unit.replace(/[/()^]/g, '\\$&') + '(?![\\w/\u00b2\u00b3-])';
  // Returns the factors of the units in the heading `here`, such as "K_eff [kN/mm]", if the heading `there` has the
  // converted units. A unit that follows a number is left out.
  const factorsOf = (here, there) =>
    names
      .filter((name) => {
        // The 1 of K_1 is no number.
        const heading = (unit) => new RegExp('(?<![\\w/-]|(?<![A-Za-z_])\\d[\\s\u202f])' + word(unit));
        return heading(name).test(here) && heading(units[name].unit).test(there);
      })
      .map((name) => units[name].factor);
  // In "0.79 to 0.81 kN/mm" the first number may have the unit of the second, or none.
  const anyOf = (text) => [1, ...names.filter((name) => new RegExp(word(name)).test(text)).map((name) => units[name].factor)];
  const unitAfter = (text) => names.find((name) => new RegExp('^' + word(name)).test(text));
  const compareTexts = (about, here, there, factors) => {
    if (KEPT.test(here) && here === there) return;
    const numbers = numbersIn(here), others = numbersIn(there);
    const differ = () => failures.push(`${about}: "${here}" in ${id} is "${there}"`);
    if (numbers.length !== others.length) {
      differ();
      return;
    }
    for (const [k, { value, half, isShare, after }] of numbers.entries()) {
      ++compared;
      const unit = unitAfter(after);
      if (unit && !new RegExp('^' + word(units[unit].unit)).test(others[k].after)) differ();
      const allowed = isShare ? [1] : unit ? [units[unit].factor] : factors;
      if (!allowed.some((factor) => Math.abs(value * factor - others[k].value) <= 1.01 * (half * factor + others[k].half))) differ();
    }
  };
  for (const [i, table] of stored.tables.entries()) {
    const inOther = other.tables[i];
    const unitColumn = table.head.findIndex((title) => /^Unit\b/.test(title));
    const heading = (cells) => [cells[0], cells[unitColumn] ?? ''].join('\n');
    for (const [r, row] of table.rows.entries())
      for (const [c, cell] of row.entries()) {
        const otherRow = inOther.rows[r] ?? [''];
        const inHead = factorsOf(table.head[c] ?? '', inOther.head[c] ?? '');
        const inRow = factorsOf(heading(row), heading(otherRow));
        // A cell may have the unit that the row states, or no unit at all, such as a number of devices.
        const factors = inHead.length > 0 ? inHead : [...inRow, ...anyOf(cell)];
        compareTexts(`${table.figure}, ${table.head[c] ?? 'column ' + c}, ${row[0]}`, cell, otherRow[c] ?? '', factors);
      }
  }
  for (const [i, { figure, text }] of stored.captions.entries())
    compareTexts(figure + ', its caption', text, other.captions[i].text, anyOf(text));
  for (const [i, plot] of stored.plots.entries())
    for (const [k, { title, values }] of plot.axes.entries()) {
      const axis = other.plots[i].axes[k];
      if (title === '' || values.length === 0) continue;
      ++compared;
      const allowed = factorsOf(title, axis.title);
      if (allowed.length === 0) allowed.push(1);
      const largest = Math.max(...values.map(Math.abs));
      if (!allowed.some((factor) => values.every((value, j) => Math.abs(value * factor - axis.values[j]) <= 1e-3 * largest * factor)))
        failures.push(`${plot.figure}, ${title}: ${values.slice(0, 3)} in ${id} are ${axis.values.slice(0, 3)} (${axis.title})`);
    }
  return { failures, compared };
}
