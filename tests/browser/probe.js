// Looks at the report from inside, a while after it was opened, and leaves what it saw where the test can read it.
// Runs in a copy of the page, in a frame of the size under test.
setTimeout(async () => {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  // What comes into sight is noticed when a frame is painted, so frames are waited for as well as time.
  const frame = () => Promise.race([new Promise(requestAnimationFrame), wait(100)]);
  const settled = async () => { for (let i = 0; i < 8; ++i) { await frame(); await wait(30); } };
  const plots = [...document.querySelectorAll('.plot')];
  for (const plot of plots) {  // as a reader does: scroll to it
    plot.scrollIntoView();
    await settled();
  }
  for (const details of document.querySelectorAll('details')) details.open = true;
  for (const select of document.querySelectorAll('select')) {  // and try the controls
    select.selectedIndex = select.options.length - 1;
    select.dispatchEvent(new Event('change'));
  }
  for (const box of document.querySelectorAll('input[type=checkbox]')) box.click();
  await settled();
  // Only tables may be wider than the page, inside their own scroller.
  const width = document.documentElement.clientWidth;
  const wide = [...document.querySelectorAll('body *')].filter((node) =>
    !node.closest('.scroll, nav, .skip, svg') && node.getBoundingClientRect().right > width + 1);
  const seen = {
    errors: document.body.dataset.errors,
    plots: plots.length,
    drawn: plots.filter((plot) => plot.querySelector('svg.main-svg .trace')).length,
    captions: [...document.querySelectorAll('figcaption')].filter((caption) => caption.textContent.trim() !== '').length,
    tables: document.querySelectorAll('table').length,
    wide: wide.slice(0, 3).map((node) => node.tagName + '.' + node.className),
    scrolls: document.documentElement.scrollWidth > width,
    images: document.querySelectorAll('img').length,
    requests: performance.getEntriesByType('resource').map((entry) => entry.name).filter((name) => /^https?:/.test(name)),
    paper: getComputedStyle(document.body).backgroundColor,
  };
  window.dispatchEvent(new Event('beforeprint'));
  await settled();
  seen.printed = plots.filter((plot) => plot.querySelector('svg.main-svg .trace')).length;
  window.dispatchEvent(new Event('afterprint'));
  await settled();
  seen.errors += document.body.dataset.errors.slice(seen.errors.length);
  parent.postMessage(JSON.stringify(seen), '*');
}, 300);
