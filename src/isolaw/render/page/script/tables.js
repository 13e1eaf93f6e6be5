import { element } from './dom.js';

// columns: [{title, unit, number, pinned}]; rows: [{cells: [text or node], className}]
export function table(columns, rows, label) {
  const align = (column) =>
    [
      column.number ? 'number' : '', column.pinned ? 'pinned' : '', column.tight ? 'tight' : '',
      column.name ? 'name' : '', column.screen ? 'screen' : '', column.mark ? 'mark' : '',
    ]
      .filter(Boolean)
      .join(' ') || null;
  const head = columns.map((column) =>
    element(
      'th',
      { scope: 'col', class: align(column), title: column.full ?? null, 'aria-sort': column.sorted ? 'ascending' : null },
      column.title,
      column.unit ? element('small', {}, column.unit) : null,
    ),
  );
  const body = rows.map((row) =>
    element(
      'tr',
      { class: row.className ?? null },
      ...row.cells.map((cell, i) => {
        if (cell instanceof HTMLTableCellElement) return cell;
        return element(i === 0 ? 'th' : 'td', { scope: i === 0 ? 'row' : null, class: align(columns[i]) }, cell);
      }),
    ),
  );
  // Focusable, so that the keyboard can scroll it.
  return element(
    'div',
    { class: rows.length > 60 ? 'scroll long' : 'scroll', tabindex: '0', role: 'region', 'aria-label': label },
    element('table', {}, element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...body)),
  );
}

// One row an item; each column has its `cell` of it. `className` gives the class of an item's row.
export function tableOf(columns, items, label, className = () => null) {
  const rows = items.map((item, i) => ({
    className: className(item, i),
    cells: columns.map(({ cell }) => cell(item, i)),
  }));
  return table(columns, rows, label);
}
