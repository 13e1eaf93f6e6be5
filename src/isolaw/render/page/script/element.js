// Creates elements of the HTML document, also for the web page that runs isolaw (page/). A text becomes text and is
// never read as HTML. If the value of an attribute is a function, it is called at the event of that name.

const isThere = (value) => value !== null && value !== undefined && value !== false;

export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

// Returns a function that creates an element. `set` typesets a child that is a text: it returns nodes, such as a symbol
// with its subscript. `unset` returns the same text without typesetting, for attributes, which cannot hold nodes.
export const elementsWith = (set, unset) => (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') node['on' + name] = value;
    else if (isThere(value)) node.setAttribute(name, value === true ? '' : unset(String(value)));
  }
  node.append(...children.flat(Infinity).filter(isThere).flatMap((child) => (typeof child === 'string' ? set(child, tag) : [child])));
  return node;
};
