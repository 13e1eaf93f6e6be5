// Redraws a view by changing only the elements that differ. Elements that stay keep the focus, their open details and
// the scroll position, and a button does not vanish under the pointer.

// A frame is always replaced by a new element. If only its address changed, the browser would add a step to its
// history.
const alike = (old, next) =>
  old.nodeType === next.nodeType && old.nodeName === next.nodeName && (old.id ?? '') === (next.id ?? '') && old.type === next.type && old.nodeName !== 'IFRAME';

function patch(old, next) {
  if (old.nodeType !== Node.ELEMENT_NODE) {
    if (old.nodeValue !== next.nodeValue) old.nodeValue = next.nodeValue;
    return;
  }
  const isText = old.nodeName === 'TEXTAREA' || (old.nodeName === 'INPUT' && old.type === 'text');
  const isTyped = isText && old === document.activeElement && old.value !== old.defaultValue;
  // Only the user opens and closes <details> elements, so their attribute `open` stays as it is.
  for (const { name } of [...old.attributes]) if (name !== 'open' && !next.hasAttribute(name)) old.removeAttribute(name);
  for (const { name, value } of [...next.attributes]) if (name !== 'open' && old.getAttribute(name) !== value) old.setAttribute(name, value);
  Object.assign(old, { onclick: next.onclick, onchange: next.onchange }); // the views use no other events
  patchChildren(old, next);
  if (isText && !isTyped && old.value !== next.value) old.value = next.value;
  if (old.nodeName === 'SELECT' && old.value !== next.value) old.value = next.value;
  if ((old.type === 'checkbox' || old.type === 'radio') && old.checked !== next.checked) old.checked = next.checked;
}

// Makes the children of `old` equal to the children of `next`. New elements are moved from `next` to `old`.
export function patchChildren(old, next) {
  const wanted = new Set([...next.childNodes].map(({ id }) => id).filter(Boolean));
  const mayGo = (node) => !wanted.has(node.id) && !node.contains(document.activeElement);
  let at = old.firstChild;
  for (const one of [...next.childNodes]) {
    let same = at;
    while (same && !alike(same, one)) same = one.id || mayGo(same) ? same.nextSibling : null;
    if (same) {
      while (at !== same) {
        const gone = at;
        at = at.nextSibling;
        gone.remove();
      }
      at = at.nextSibling;
      patch(same, one);
    } else old.insertBefore(one, at);
  }
  while (at) {
    const gone = at;
    at = at.nextSibling;
    gone.remove();
  }
}
