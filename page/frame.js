// Shows a report in a frame. The frame has an origin of its own, so that the report's scripts cannot reach this page.
// The page's security policy applies in the frame too.

import { button, element } from './dom.js';
import { download } from '../src/isolaw/render/page/script/download.js';
import { text } from './text.js';

const addresses = new Set();

// Returns an address that shows the report with one script added. This script prints the report when it gets a message,
// because the page itself cannot print a frame of another origin.
function addressOf(bytes) {
  const script = document.getElementById('isolaw-frame').textContent;
  const url = URL.createObjectURL(new Blob([bytes, '<script>', script, '</script>'], { type: 'text/html;charset=utf-8' }));
  addresses.add(url);
  return url;
}

const print = (frame) => frame.contentWindow.postMessage('isolaw: print', '*');

// Prints the report that a view shows. Returns false if the view shows none.
export function printFrame(view) {
  const frame = view.querySelector('iframe');
  if (frame) print(frame);
  return frame !== null;
}

export const isFrame = (source) => [...document.querySelectorAll('iframe')].some(({ contentWindow }) => contentWindow === source);

export function reportFrame(id, title, bytes, name, extra = []) {
  const url = addressOf(bytes);
  const frame = element('iframe', { id, title, src: url, sandbox: 'allow-scripts allow-downloads allow-modals' });
  // The report asks to be opened again in other units, which it cannot do itself.
  window.addEventListener('message', ({ source, data }) => {
    const [, address] = /^isolaw: open (#[^]*)$/.exec(data) ?? [];
    if (address && source === frame.contentWindow) frame.src = addressOf(bytes) + address;
  });
  const tools = element(
    'div',
    { class: 'tools' },
    extra,
    button(text.print, () => print(frame), { class: 'action' }),
    element('a', { class: 'action', href: url, target: '_blank', rel: 'noopener' }, text.newTab),
    button(text.savePage, () => download(name, bytes, 'text/html'), { class: 'action' }),
  );
  return { tools, frame };
}

// Frees the memory of reports that are no longer shown. A report that was opened in a new tab stays open.
export function forgetFrames() {
  for (const url of addresses) URL.revokeObjectURL(url);
  addresses.clear();
}
