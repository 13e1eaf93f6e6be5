// The data block of the page.

export const data = JSON.parse(document.getElementById('isolaw-data').textContent);
