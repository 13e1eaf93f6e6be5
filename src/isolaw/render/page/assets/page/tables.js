// Tables

// columns: [{title, unit, number, pinned}]; rows: [{cells: [text or node], className}]
function table(columns, rows, label) {
  const align = (column) =>
    [
      column.number ? 'number' : '',
      column.pinned ? 'pinned' : '',
      column.tight ? 'tight' : '',
      column.name ? 'name' : '',
      column.screen ? 'screen' : '',
      column.mark ? 'mark' : '',
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

function lawKey(law) {
  return element('span', { class: 'key', style: 'border-color: var(--law-' + ((law.index % 8) + 1) + ')' });
}

// A small sign of [path, fill, stroke] in a field of 12 by 12.
const ROUND = 'M6 .8 A5.2 5.2 0 1 1 5.99 .8 Z';
function icon(...shapes) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  for (const [d, fill, stroke] of shapes) {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', d);
    path.style.fill = fill;
    path.style.stroke = stroke;
    svg.append(path);
  }
  return svg;
}

// The front's markers, as in the plot: filled circle, or open diamond for a dominated law.
function marker(role) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  const shape = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  const dominated = role === 'dominated';
  shape.setAttribute('d', dominated ? 'M6 1 L11 6 L6 11 L1 6 Z' : 'M6 1 A5 5 0 1 1 5.99 1 Z');
  shape.setAttribute('stroke-width', '1.8');
  const colour = 'var(--' + (dominated ? 'poor' : role === 'not ranked' ? 'muted' : 'good') + ')';
  shape.style.stroke = colour;
  shape.style.fill = dominated || role === 'not ranked' ? 'none' : colour;
  svg.append(shape);
  return svg;
}
