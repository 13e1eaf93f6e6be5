import { element } from './dom.js';

function csvCell(value) {
  if (value === null || value === undefined) return '';
  if (typeof value === 'number') return String(Number(value.toPrecision(9)));
  let text = String(value);
  if (/^[=+\-@\t\r]./s.test(text) && !(text.trim() !== '' && Number.isFinite(Number(text)))) text = "'" + text;
  return /[",\r\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
}

export function download(name, { columns, rows }) {
  const text = [columns, ...rows].map((row) => row.map(csvCell).join(',') + '\r\n').join('');
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv;charset=utf-8' }));
  const link = element('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
