// A small sign of [path, fill, stroke] in a field of 12 by 12.
export const ROUND = 'M6 .8 A5.2 5.2 0 1 1 5.99 .8 Z';

export function icon(...shapes) {
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
export function marker(role) {
  const dominated = role === 'dominated';
  const colour = 'var(--' + (dominated ? 'poor' : role === 'not ranked' ? 'muted' : 'good') + ')';
  const path = dominated ? 'M6 1 L11 6 L6 11 L1 6 Z' : 'M6 1 A5 5 0 1 1 5.99 1 Z';
  const svg = icon([path, dominated || role === 'not ranked' ? 'none' : colour, colour]);
  svg.firstChild.setAttribute('stroke-width', '1.8');
  return svg;
}
