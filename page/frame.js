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

const reports = new WeakMap(); // frame -> {bytes, url}: its report, and the address that the link to a new tab has
const frameOf = (source) => [...document.querySelectorAll('iframe')].find(({ contentWindow }) => contentWindow === source);
export const isFrame = (source) => frameOf(source) !== undefined;

// A report in a frame sends this message if it wants to be opened again in other units, since it cannot change its own
// address. The address `url` stays valid, because the link to a new tab uses it.
window.addEventListener('message', ({ source, data }) => {
  const [, hash] = /^isolaw: open (#[^]*)$/.exec(data) ?? [];
  const frame = frameOf(source);
  if (!hash || !reports.has(frame)) return;
  const { bytes, url } = reports.get(frame);
  const [before] = frame.src.split('#');
  frame.src = addressOf(bytes) + hash;
  if (before === url) return;
  URL.revokeObjectURL(before);
  addresses.delete(before);
});

export function reportFrame(id, title, bytes, name, extra = []) {
  const url = addressOf(bytes);
  const frame = element('iframe', { id, title, src: url, sandbox: 'allow-scripts allow-downloads allow-modals' });
  reports.set(frame, { bytes, url });
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
