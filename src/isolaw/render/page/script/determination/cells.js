import { chosen, onChoice } from '../choice.js';
import { chooseDevice } from '../choosers.js';

export function chooseCell(button) {
  if (button) chooseDevice(Number(button.dataset.device), { parameter: Number(button.dataset.parameter) });
}

export function cellBeside(button, key) {
  const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key] ?? [0, 0];
  if (!button || (dx === 0 && dy === 0)) return null;
  let row = button.closest('tr'),
    column = button.closest('td').cellIndex;
  for (;;) {
    column += dx;
    if (dy !== 0) row = dy > 0 ? row.nextElementSibling : row.previousElementSibling;
    const cell = row?.cells[column];
    if (!cell) return null;
    if (cell.querySelector('button')) return cell.querySelector('button');
  }
}

// Marks the button of the chosen device and parameter. The Tab key reaches this button, and arrow keys lead to others.
export function markChosenCell(body) {
  if (!body) return;
  for (const button of body.querySelectorAll('td button[tabindex="0"]')) {
    button.tabIndex = -1;
    button.setAttribute('aria-pressed', 'false');
  }
  const own = body.querySelector(
    'button[data-device="' + chosen.device + '"][data-parameter="' + chosen.parameter + '"]',
  );
  own?.setAttribute('aria-pressed', 'true');
  const reached = own ?? body.querySelector('td button');
  if (reached) reached.tabIndex = 0;
}

onChoice(() => markChosenCell(document.querySelector('#figure-determined .marks')));
