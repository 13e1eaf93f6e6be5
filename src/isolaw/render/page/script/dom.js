// Elements of the document, and whether it is on paper.

export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

export const isPrinting = () => 'printing' in document.documentElement.dataset;

// What a caption says of controls, columns and downloads that paper does not have.
export const onScreen = (text) => (isPrinting() ? '' : text);
