export const data = JSON.parse(document.getElementById('isolaw-data').textContent);
