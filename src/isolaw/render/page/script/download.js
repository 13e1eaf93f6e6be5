function csvCell(value) {
  if (value === null || value === undefined) return '';
  if (typeof value === 'number') return String(Number(value.toPrecision(9)));
  let text = String(value);
  if (/^[=+\-@\t\r]./s.test(text) && !(text.trim() !== '' && Number.isFinite(Number(text)))) text = "'" + text;
  return /[",\r\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
}

export const csvText = ({ columns, rows }) => [columns, ...rows].map((row) => row.map(csvCell).join(',') + '\r\n').join('');

export function download(name, content, type = 'application/octet-stream') {
  const href = URL.createObjectURL(new Blob([content], { type }));
  const link = Object.assign(document.createElement('a'), { href, download: name, hidden: true });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(href), 60000);
}
