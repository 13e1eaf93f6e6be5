import { element } from './dom.js';
import { DASH, MINUS } from './text.js';

const FEW_ROWS = 3; // a table of up to this many rows cannot be sorted

// The sort order of each table, by the table's label. A table that is built again keeps its order.
const orders = new Map();

// In a group of rows with a common value, only the first row shows the value. Screen readers read it in every row, and
// a sorted table shows it in every row.
export const said = (first, node) => {
  if (!first) node.classList.add('again');
  return node;
};

// Sorts from the smallest value, or from the largest with `down`. Items without a value always come last.
export function sortedBy(items, valueOf, down) {
  const direction = down ? -1 : 1;
  const compare = (a, b) => (typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b), 'en', { numeric: true }));
  return items
    .map((item) => ({ item, value: valueOf(item) }))
    .sort(({ value: a }, { value: b }) => (a === null || b === null ? Number(a === null) - Number(b === null) : direction * compare(a, b)))
    .map(({ item }) => item);
}

const POWERS = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';

// Reads the number at the start of a text as the page writes it: "−1.20·10⁻³ kN", "> 1000 %".
function numberIn(text) {
  const found = /^[\s>\u00b1+]*(-?\d+(?:\.\d+)?)(?:\u00b710(\u207b?)([\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+))?/.exec(text.replace(MINUS, '-'));
  if (!found) return null;
  const power = found[3] ? Number([...found[3]].map((digit) => POWERS.indexOf(digit)).join('')) : 0;
  return Number(found[1]) * 10 ** (found[2] ? -power : power);
}

// Returns the value by which a cell is sorted: the attribute data-sort, or else the cell's text without small print.
function valueIn(cell, { number, size }) {
  if (!cell || cell.colSpan > 1) return null;
  const parts = [...cell.childNodes].filter((node) => node.nodeName !== 'SMALL');
  const text = (cell.dataset.sort ?? parts.map((node) => node.textContent).join('')).trim();
  if (text === '' || text === DASH) return null;
  if (!number && cell.dataset.sort === undefined) return text;
  const value = numberIn(text);
  return size && value !== null ? Math.abs(value) : value;
}

// The first press on a heading sorts upwards, the second downwards, and the third restores the table's own order.
function sortHeads(body, columns, heads, { label, order, follow, byItem }) {
  const written = [...body.rows],
    keys = columns.map(keyOf);
  let current = order === undefined ? (orders.get(label) ?? null) : order;
  const show = () => {
    const place = keys.indexOf(current?.key);
    heads.forEach((head, i) => {
      if (i === place) head.setAttribute('aria-sort', current.down ? 'descending' : 'ascending');
      else head.removeAttribute('aria-sort');
    });
    const value = (row) =>
      columns[place].by ? (columns[place].by(byItem[written.indexOf(row)]) ?? null) : valueIn(row.cells[place], columns[place]);
    body.replaceChildren(...(place < 0 ? written : sortedBy(written, value, current.down)));
    body.parentNode.toggleAttribute('data-sorted', place >= 0);
  };
  heads.forEach((head, i) => {
    const key = keys[i];
    head.querySelector('button.sort')?.addEventListener('click', () => {
      current = current?.key !== key ? { key, down: false } : current.down ? null : { key, down: true };
      orders.set(label, current);
      show();
      follow?.(current);
    });
  });
  if (current) show();
}

export function keyOf({ title, unit = '' }, place = 0, columns = [{ title, unit }]) {
  const name = (column) => (column.title.textContent ?? column.title) + '\n' + (column.unit ?? '');
  const own = name({ title, unit });
  return columns.findIndex((column) => name(column) === own) === place ? own : own + '\n' + place;
}

// columns: [{title, unit, number, pinned, by, size, ...}]; rows: [{cells: [text or node], className, foot}]. `items`
// has an object for each row, and `by` returns the sort key of such an object; without `by` the cell's text is the key.
// `size` sorts by magnitude. A row with `foot` stays at the end. Without `sorts` the order is fixed. When the user
// sorts, `follow` is called with the new order, {key, down}, or with null for the table's own order.
export function table(columns, rows, label, { sorts = rows.length > FEW_ROWS, order, follow, items = [] } = {}) {
  const align = (column) =>
    [
      column.number ? 'number' : '', column.pinned ? 'pinned' : '', column.tight ? 'tight' : '',
      column.name ? 'name' : '', column.mark ? 'mark' : '',
    ]
      .filter(Boolean)
      .join(' ') || null;
  const head = columns.map((column) =>
    element(
      'th',
      { scope: 'col', class: align(column), title: column.full ?? null },
      sorts ? element('button', { type: 'button', class: 'sort' }, column.title) : column.title,
      column.unit ? element('small', {}, column.unit) : null,
    ),
  );
  const rowOf = (row) =>
    element(
      'tr',
      { class: row.className ?? null },
      ...row.cells.map((cell, i) => {
        if (cell instanceof HTMLTableCellElement) return cell;
        return element(i === 0 ? 'th' : 'td', { scope: i === 0 ? 'row' : null, class: align(columns[i]) }, cell);
      }),
    );
  const body = element('tbody', {}, ...rows.filter((row) => !row.foot).map(rowOf)),
    foot = rows.filter((row) => row.foot).map(rowOf);
  const whole = element(
    'table',
    {},
    element('thead', {}, element('tr', {}, ...head)),
    body,
    foot.length > 0 ? element('tfoot', {}, ...foot) : null,
  );
  if (sorts) sortHeads(body, columns, head, { label, order, follow, byItem: items });
  // tabindex makes the table focusable, so that the keyboard can scroll it.
  return element('div', { class: rows.length > 60 ? 'scroll long' : 'scroll', tabindex: '0', role: 'region', 'aria-label': label }, whole);
}

export function tableOf(columns, items, label, { className = () => null, ...more } = {}) {
  const rows = items.map((item, i) => ({
    className: className(item, i),
    cells: columns.map(({ cell }) => cell(item, i)),
  }));
  return table(columns, rows, label, { items, ...more });
}

function rowOfColumns(row, places) {
  const copy = row.cloneNode(false);
  let column = 0;
  for (const cell of row.cells) {
    const covered = places.filter((place) => place >= column && place < column + cell.colSpan).length;
    column += cell.colSpan;
    if (covered === 0) continue;
    const own = cell.cloneNode(true);
    own.colSpan = covered;
    copy.append(own);
  }
  return copy;
}

// Divides each table that is wider than the paper into parts, because a printed table cannot be scrolled. Every part
// repeats the first column.
export function partTables() {
  for (const whole of document.querySelectorAll('.scroll > table')) {
    const room = whole.parentNode.clientWidth;
    if (room === 0 || whole.offsetWidth <= room) continue;
    const widths = [...whole.tHead.rows[0].cells].map((head) => head.getBoundingClientRect().width);
    const groups = [[]];
    let used = widths[0];
    widths.slice(1).forEach((width, i) => {
      if (used + width > room && groups[groups.length - 1].length > 0) {
        groups.push([]);
        used = widths[0];
      }
      used += width;
      groups[groups.length - 1].push(i + 1);
    });
    for (const group of groups) {
      const part = whole.cloneNode(false);
      part.classList.add('part');
      for (const of of whole.children) {
        const share = of.cloneNode(false);
        share.append(...[...of.rows].map((row) => rowOfColumns(row, [0, ...group])));
        part.append(share);
      }
      whole.parentNode.append(part);
    }
    whole.hidden = true;
  }
}

export function joinTables() {
  for (const part of document.querySelectorAll('table.part')) part.remove();
  for (const whole of document.querySelectorAll('.scroll > table[hidden]')) whole.hidden = false;
}
