// Opens the report of a made-up lot in headless Chromium and fails on everything that would disturb a reader: script
// errors, figures that are not drawn, a page wider than its window, requests to the network, and HTML in names that the
// browser executes.
//   node report_page.mjs fit|inspection|analysis|large MAKE_PAGE [CHROMIUM]
// The first argument chooses the cases: pages with laws that were only fitted, pages without laws, pages of a campaign
// with its analyses, or pages of 160 devices, which take the longest.
// ISOLAW_SCREENSHOTS=DIR saves pictures of every case, screen by screen, and its PDF.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Chromium } from './chromium.mjs';
import { extend, with_data } from './test_records.mjs';

const [group, makePage, program] = process.argv.slice(2);
if (!program || !existsSync(program)) {
  console.log('skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)');
  process.exit(77);
}

// `records` are the options of extend() in test_records.mjs, which replaces the records in the data of the page. With
// `false` the page stays as isolaw wrote it.
const LETTERHEAD = Array.from({ length: 12 }, (_, i) => 'Line ' + (i + 1) + ' of the beta laboratory, K_eff 1e+05').join('\n');
const CASES = [
  { name: 'laptop', devices: 3, laws: 3, width: 1366, height: 768 },
  { name: 'dark', devices: 10, laws: 7, width: 1366, height: 768, dark: true },
  { name: 'phone', devices: 10, laws: 7, width: 390, height: 844 },
  { name: 'one-device', devices: 1, laws: 7, width: 1366, height: 768 },
  { name: 'large-lot', devices: 160, laws: 7, width: 1366, height: 768 },
  { name: 'inspection', devices: 10, laws: 3, width: 1366, height: 768, records: { laws: false }, letterhead: LETTERHEAD },
  {
    name: 'inspection-phone',
    devices: 10,
    laws: 3,
    width: 390,
    height: 844,
    records: { laws: false, verified: false },
  },
  { name: 'inspection-one-device', devices: 1, laws: 0, width: 1366, height: 768, records: false, state: 'failing' },
  { name: 'inspection-passing', devices: 10, laws: 0, width: 1366, height: 768, records: false, state: 'passing' },
  { name: 'inspection-failing', devices: 10, laws: 0, width: 1366, height: 768, records: false, state: 'failing' },
  { name: 'inspection-failing-phone', devices: 40, laws: 0, width: 390, height: 844, records: false, state: 'failing' },
  { name: 'unverified', devices: 10, laws: 3, width: 1366, height: 768, records: { verified: false } },
  { name: 'no-rule-set', devices: 3, laws: 3, width: 1366, height: 768, dark: true, records: { assessed: false } },
  { name: 'as-written', devices: 3, laws: 3, width: 1366, height: 768, records: false },
  { name: 'inadequate', devices: 10, laws: 7, width: 1366, height: 768, records: false, inadequate: true },
  { name: 'analysed', devices: 10, laws: 7, width: 1366, height: 768, records: false, analysed: true },
  { name: 'analysed-phone', devices: 10, laws: 7, width: 390, height: 844, records: false, analysed: true, dark: true },
  { name: 'analysed-one-device', devices: 1, laws: 3, width: 1366, height: 768, records: false, analysed: true },
  { name: 'analysed-large-lot', devices: 160, laws: 7, width: 1366, height: 768, records: false, analysed: true },
];
const group_of = ({ name, analysed, devices }) =>
  name.startsWith('inspection') ? 'inspection' : devices > 100 ? 'large' : analysed ? 'analysis' : 'fit';
const FIRST_SCREEN_MS = 2000;
const SOURCES = [
  'contract band',
  'observed',
  'statistical, each device',
  'statistical, system',
  'statistical, system predicted',
];

// Returns the keys of those parts of the data that extend() replaces. The parts that extend() writes must have the same
// keys as those that isolaw writes.
function shape(report) {
  const lot = report.assessment?.lot;
  const device = report.devices[0];
  const keys = (object) => (object ? Object.keys(object).sort().join(' ') : '');
  const cycle = device.blocks[0]?.cycles[0];
  return {
    device: keys(device),
    block: keys(device.blocks[0]),
    cycle: keys(cycle),
    stability: keys(device.blocks[0]?.stability.K_eff),
    assessment: keys(device.assessments[0]),
    result: keys(report.result),
    'rule set': keys(report.assessment?.rule_set),
    lot: keys(lot),
    sample: keys(lot?.sample),
    quantity: keys(lot?.quantities[0]),
    'mean limit': keys(lot?.quantities.find((quantity) => quantity.mean_limits.length > 0)?.mean_limits[0]),
    lambda_test: keys(lot?.quantities.find((quantity) => quantity.lambda_test)?.lambda_test),
    factor: keys(lot?.factors[0]),
    mean_analysis: keys(lot?.mean_analysis),
  };
}

// Looks at the second device of a page whose records extend() has replaced. The data in the page tell which blocks,
// cycles and verdicts it must show; the document tells what it shows. This function runs in the page.
async function look_at_records() {
  const report = reportAsShown();
  const place = Math.min(1, report.devices.filter((device) => device.raw).length - 1);
  const device = report.devices[place];
  const cycles = device.blocks.flatMap((block) => block.cycles);
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const select = async (id, value) => {
    const node = document.getElementById(id);
    node.value = value;
    node.dispatchEvent(new Event('change'));
    for (const figure of ['loop', 'history', 'cycles', 'stability', 'cycle-history', 'cycle-table', 'lot-strips']) {
      document.getElementById('figure-' + figure)?.scrollIntoView();
      await wait(120);
    }
  };
  const said = (id) => document.querySelector('#figure-' + id)?.textContent ?? '';
  const labels = () => {
    const boxes = [...document.querySelectorAll('#figure-cycles .annotation-text')].map((node) => ({
      text: node.textContent,
      box: node.getBoundingClientRect(),
    }));
    const plot = document.querySelector('#figure-cycles .plot').getBoundingClientRect();
    const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    return {
      texts: boxes.map(({ text }) => text).sort(),
      overlapping: boxes.filter((a, i) => boxes.some((b, k) => k < i && meet(a.box, b.box))).length,
      outside: boxes.filter(
        ({ box }) => box.left < plot.left || box.right > plot.right || box.top < plot.top || box.bottom > plot.bottom,
      ).length,
    };
  };
  // Returns the number of loops whose drawn line ends before or beyond the extreme displacements of its cycle.
  const misdrawn = () =>
    [...document.querySelector('#figure-cycles .plot').data].filter(({ x }) => {
      const [low, high] = [Math.min(...x), Math.max(...x)];
      return !cycles.some((cycle) => Math.abs(high - cycle.d_plus_mm) < 0.3 && Math.abs(low - cycle.d_minus_mm) < 0.3);
    }).length;
  const lines = () => {
    const paths = [...document.querySelectorAll('#figure-cycles .js-line')];
    return {
      dashed: paths.filter((path) => getComputedStyle(path).strokeDasharray !== 'none').length,
      colours: new Set(paths.map((path) => getComputedStyle(path).stroke)).size,
      count: paths.length,
    };
  };

  await select('block', 'all');
  await select('tested', String(place));
  const all = { labels: labels(), lines: lines(), misdrawn: misdrawn() };
  const bars = document.querySelector('#figure-cycle-history .plot').layout.shapes.filter(({ y1 }) => y1 === 0.03);
  const texts = [];
  const create = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    texts.push(blob.text());
    return create(blob);
  };
  for (const id of ['cycle-table', 'cycles', 'verdict-table', 'lot'])
    document.querySelector('#figure-' + id + ' button.csv')?.click();
  URL.createObjectURL = create;
  const csv = await Promise.all(texts);
  const follows = ['device', 'tested'].map((id) => document.getElementById(id)?.value).filter(Boolean);
  const rows = [...document.querySelectorAll('#figure-cycle-table tbody tr')];
  const table = { rows: rows.length, uncounted: rows.filter((row) => row.matches('.uncounted')).length };
  const judged = document.querySelectorAll('#figure-history .shapelayer path').length;
  const limited = device.assessments.filter((a) => a.limit !== '' && a.nominal !== null).map((a) => a.quantity);
  const bands = {
    drawn: document.querySelector('#figure-stability .plot').layout.shapes?.filter(({ type }) => type === 'rect').length,
    limited: ['K_eff', 'damping', 'energy'].filter((name) => limited.some((quantity) => quantity.startsWith(name))).length,
  };
  const last = device.blocks[device.blocks.length - 1];
  await select('block', String(last.number));
  const one = { labels: labels(), lines: lines() };

  const badges = [...document.querySelectorAll('section:not(#certificate) figure:not(#figure-verdict) .verdict')].map((badge) => ({
    word: badge.textContent,
    shape: badge.querySelector('path').getAttribute('d'),
  }));
  return {
    all,
    one,
    csv,
    follows: new Set(follows).size,
    table,
    judged,
    bands,
    scored: device.scored?.length ?? 0,
    barsRight: JSON.stringify(bars.map(({ x0, x1 }) => ({ from: x0, to: x1 }))) === JSON.stringify(device.scored ?? []),
    drawnRows: device.raw.disp_mm.d.length,
    cycles: cycles.length,
    counted: cycles.filter((cycle) => cycle.counts).length,
    uncounted: cycles.filter((cycle) => !cycle.counts).length,
    ofLastBlock: last.cycles.filter((cycle) => cycle.counts).map((cycle) => String(cycle.number)),
    reasonsShown: cycles.every((cycle) => said('cycle-table').includes(cycle.reason)),
    words: [...new Set(badges.map(({ word }) => word))].sort(),
    shapes: new Set(badges.map(({ shape }) => shape)).size,
    badges: badges.length,
    verdicts:
      device.assessments.length +
      report.devices.reduce((sum, one) => sum + one.assessments.length, 0) +
      (report.assessment?.lot.quantities.filter((quantity) => quantity.mean_limits.length > 0).length ?? 0),
    ruleSet: said('rule-set'),
    held: report.assessment,
    factorText: said('factors'),
    care: said('warnings'),
    warnings: report.findings.warnings.map((warning) => warning.sentence),
    notVerified: document.body.innerText.includes('The limits of this set are not verified'),
    kind: document.getElementById('kind').textContent,
    sections: [...document.querySelectorAll('main > section')].map((section) => section.id),
    outliers: report.assessment?.lot.outliers.length ?? 0,
    outlierRows: document.querySelectorAll('#figure-outliers tbody tr').length,
    lotRows: document.querySelectorAll('#figure-lot tbody tr').length,
    lotQuantities: report.assessment?.lot.quantities.length ?? 0,
    factorRows: document.querySelectorAll('#figure-factors tbody tr').length,
    factors: report.assessment?.lot.factors.length ?? 0,
    verdictRows: document.querySelectorAll('#figure-verdict-table tbody tr').length,
    corrections: report.devices.every((one) =>
      [...one.corrections, ...one.notes, ...one.warnings].every((text) => said('steps').includes(text)),
    ),
    names: report.devices.length,
    images: document.querySelectorAll('img').length,
    errors: document.body.dataset.errors,
  };
}

function check_records(name, seen, { laws = true, verified = true, assessed = true }) {
  const { all, one } = seen;
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  expect(seen.errors === '' && seen.images === 0, name, 'errors: ' + seen.errors);
  expect(
    all.labels.texts.length === seen.counted,
    name,
    `${all.labels.texts.length} of ${seen.counted} loops numbered`,
  );
  expect(new Set(all.labels.texts).size === seen.counted, name, 'numbers of loops repeat');
  for (const [what, { labels }] of Object.entries({ all, one }))
    expect(labels.overlapping + labels.outside === 0, name, `numbers of loops of ${what}: ${JSON.stringify(labels)}`);
  expect(all.lines.count === seen.cycles, name, `${all.lines.count} loops drawn of ${seen.cycles}`);
  expect(all.misdrawn === 0, name, `${all.misdrawn} loops drawn wrong`);
  expect(seen.barsRight, name, 'the judged part is not where it is in the history');
  expect(all.lines.dashed === seen.uncounted && seen.uncounted > 0, name, `${all.lines.dashed} loops dashed`);
  expect(one.lines.colours >= 4, name, `${one.lines.colours} colours in a block`);
  expect(same(one.labels.texts, seen.ofLastBlock), name, 'one block shows ' + one.labels.texts);
  expect(seen.table.rows === seen.cycles && seen.table.uncounted === seen.uncounted, name, 'rows of the cycle table');
  expect(seen.reasonsShown, name, 'the reason of a cycle that does not count is not shown');
  expect(seen.follows === 1, name, 'the choosers of the device differ');
  expect(seen.judged === seen.scored, name, `${seen.judged} of ${seen.scored} judged parts marked`);
  expect(
    (seen.bands.drawn ?? 0) === seen.bands.limited && seen.bands.limited > 0 === assessed,
    name,
    `${seen.bands.drawn} bands of ${seen.bands.limited} limits on a device`,
  );
  expect(seen.corrections, name, 'a note, warning or correction is not in how it was made');

  const [cycleTable, raw] = seen.csv.map((text) => text.trimEnd().split('\r\n'));
  for (const column of ['d+', 'K_eff', 'D_y', 'N mean', 'closure', 'G', 'why not', 'damping / cycle 3'])
    expect(cycleTable[0].includes(column), name, column + ' is not in the CSV of the cycles');
  expect(cycleTable.length === seen.cycles + 1, name, 'rows of the CSV of the cycles');
  expect(raw.length === seen.drawnRows + 1, name, 'rows of the CSV of the loops');

  const words = !assessed
    ? []
    : verified
      ? ['fail', 'information', 'not assessed', 'pass']
      : ['information', 'not assessed'];
  // In a small lot all devices may pass, so the page need not say "fail".
  expect(
    words.every((word) => word === 'fail' || seen.words.includes(word)),
    name,
    'verdicts ' + seen.words,
  );
  expect(
    seen.words.every((word) => words.includes(word)),
    name,
    'verdicts ' + seen.words,
  );
  expect(seen.badges === seen.verdicts, name, `${seen.badges} verdicts shown of ${seen.verdicts}`);
  expect(seen.shapes === seen.words.length, name, 'verdicts share a shape');
  expect(seen.notVerified === (assessed && !verified), name, 'whether the set is verified is not said');
  expect(seen.outlierRows === seen.outliers, name, 'rows of outliers');
  expect(
    seen.lotRows === seen.lotQuantities && seen.factorRows === seen.factors,
    name,
    'rows of the lot or its factors',
  );
  if (assessed) {
    const { lot, design } = seen.held;
    expect(seen.ruleSet.includes(lot.sample.limit), name, 'the sample is not said');
    expect(seen.ruleSet.includes(lot.note), name, 'what the lot is not, is not said');
    expect(
      design.every(({ value }) => seen.ruleSet.includes(' ' + value + '\u202f')),
      name,
      'design values are not as given: ' + seen.ruleSet,
    );
    expect(
      lot.factors.every(
        (factor) => seen.factorText.includes(factor.source) && seen.factorText.includes(factor.no_lower_bound),
      ),
      name,
      'a source of factors, or why there is no lower bound, is not said',
    );
  }
  expect(
    laws ? seen.care === '' : seen.warnings.length > 0 && seen.warnings.every((text) => seen.care.includes(text)),
    name,
    'warnings at the top of the properties: ' + seen.care,
  );
  expect(seen.verdictRows === (assessed ? seen.names : 0), name, `${seen.verdictRows} devices with verdicts`);

  expect((seen.kind === 'Test records') === !laws, name, 'the page calls itself ' + seen.kind);
  const sections = laws
    ? ['decision', 'front', 'objective', 'loops', 'parameters', 'published', 'properties', 'devices', 'certificate', 'provenance']
    : ['verdict', 'properties', 'devices', 'certificate', 'provenance'];
  expect(same(seen.sections, sections), name, 'sections ' + seen.sections);
}

// Returns the text of the first screen and its number of words, what the page shows after the reader has chosen another
// law and another device there, and the views of accuracy against robustness. This function runs in the page.
async function look_at_answer() {
  const report = reportAsShown();
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  for (const details of document.querySelectorAll('#decision details')) details.open = false;
  scrollTo(0, 0);
  await wait(200);
  const texts = document.createTreeWalker(document.querySelector('main'), window.NodeFilter.SHOW_TEXT);
  let words = 0;
  while (texts.nextNode()) {
    const range = document.createRange();
    range.selectNode(texts.currentNode);
    const box = range.getBoundingClientRect();
    if (box.height > 0 && box.left >= 0 && box.bottom <= window.innerHeight && !texts.currentNode.parentNode.closest('svg, button, select, table, code, .warnings'))
      words += texts.currentNode.textContent.split(/\s+/).filter((word) => /\w/.test(word)).length;
  }
  const name = (node) => node.querySelector('b').textContent;
  const text = (selector) => document.querySelector(selector)?.textContent.replace(/\s/g, '') ?? '';
  const loop = () => document.querySelector('#figure-answer-loop .plot').data.map((trace) => trace.name ?? '').filter((trace) => trace.includes('fitted'));
  const rows = [...document.querySelectorAll('#figure-laws tbody tr')];
  const first = {
    headline: text('#figure-answer .headline').replace(report.findings.recommendation.sure, ''),
    explanation: text('#figure-answer .explanation'),
    numbers: document.querySelectorAll('#figure-answer .numbers b').length,
    warned: document.querySelectorAll('#figure-answer .warnings > ul > li').length,
    hidden: document.querySelectorAll('#figure-answer .warnings details li').length,
    command: document.querySelector('#figure-answer code')?.textContent ?? '',
    laws: rows.map(name),
    chosen: rows.filter((row) => row.matches('.chosen')).map(name),
    loop: loop(),
  };

  // The reader chooses the last law that has a loop, then the last device. Every section must follow.
  const drawn = [...rows].reverse().find((row) => {
    const law = report.laws[row.querySelector('input').value];
    return law.devices.some((fit) => fit.force_kN);
  });
  drawn.querySelector('input').click();
  const law = report.laws[drawn.querySelector('input').value];
  await wait(150);
  const device = document.getElementById('answer-device');
  if (device) {
    device.selectedIndex = device.options.length - 1;
    device.dispatchEvent(new Event('change'));
  }
  [...document.querySelectorAll('.tile')].at(-1)?.click();
  await wait(150);
  const slider = document.getElementById('answer-time');
  const said = () => document.querySelector('#figure-answer-loop output').textContent;
  const before = said();
  slider.value = 800;
  slider.dispatchEvent(new Event('input'));
  await wait(50);
  const value = (id) => document.getElementById(id)?.selectedOptions[0]?.textContent;
  return {
    words, first,
    then: {
      wanted: law.id, id: JSON.parse(document.getElementById('isolaw-data').textContent).laws[drawn.querySelector('input').value].id, loop: loop(), moved: said() !== before,
      law: ['law', 'examined', 'lotLaw'].map(value).filter(Boolean),
      ticked: [...document.querySelectorAll('#loops input:checked')].map((box) => box.closest('label').textContent),
      devices: ['answer-device', 'device', 'predicted-device'].map(value).filter(Boolean),
      address: decodeURIComponent(location.hash),
      tiles: [...document.querySelectorAll('.tile')].filter((tile) => tile.getAttribute('aria-pressed') === 'true').map((tile) => tile.querySelector('span').textContent),
    },
    recommendation: report.findings.recommendation,
    warnings: report.findings.warnings.length,
    examined: report.laws.filter((one) => one.devices.some((fit) => fit.determination)).map(({ id }) => id),
    ofLot: report.laws.filter((one) => one.lot).map(({ id }) => id),
  };
}

function check_answer(name, { words, first, then, recommendation, warnings, examined, ofLot }, { width, devices }) {
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  const packed = (text) => text.replace(/\s/g, '');
  expect(width < 1000 || words <= 140, name, `${words} words besides warnings and tables on the first screen`);
  expect(first.headline === packed(recommendation.headline), name, 'headline ' + first.headline);
  expect(first.explanation.startsWith(packed(recommendation.explanation)), name, 'explanation ' + first.explanation);
  expect(first.numbers === 3 || (first.numbers === 2 && recommendation.valid_mm === null), name, first.numbers + ' numbers');
  expect(first.warned <= 3 && first.warned + first.hidden === warnings, name, `${first.warned} and ${first.hidden} warnings of ${warnings}`);
  expect(first.command === recommendation.export_command, name, 'command ' + first.command);
  expect(same(first.laws, recommendation.standings.map(({ law }) => law)), name, 'laws ' + first.laws);
  expect(first.chosen.length === 1 && (!recommendation.law || first.chosen[0] === recommendation.law), name, 'chosen is ' + first.chosen);
  expect(first.loop.length >= 1 && first.loop.every((trace) => trace.startsWith(first.chosen[0])), name, 'loop of ' + first.loop);
  expect(then.loop.every((trace) => trace.startsWith(then.wanted)), name, `loop of ${then.loop}, chosen ${then.wanted}`);
  const shows = [then.wanted, ...(examined.includes(then.wanted) || examined.length === 0 ? [then.wanted] : []), ...(ofLot.includes(then.wanted) ? [then.wanted] : [])];
  expect(then.law.length > 0 && then.law.filter((law) => law === then.wanted).length >= Math.min(shows.length, then.law.length), name, `sections show ${then.law}`);
  expect(same(then.ticked, [then.wanted]), name, 'loops of ' + then.ticked);
  expect(new Set(then.devices).size <= 1 && (devices === 1 || then.devices.length > 0), name, 'devices ' + then.devices);
  expect(then.tiles.length === 0 || same(then.tiles, [then.devices[0]]), name, 'tile of ' + then.tiles);
  expect(then.moved, name, 'the slider moves nothing');
  expect(then.address.includes('law=' + then.id), name, 'address ' + then.address);
}

// A law that does not describe the devices must have its own mark, which must be the same in the plot and in the list.
// This function runs in the page.
async function look_at_inadequate() {
  const report = reportAsShown();
  document.querySelector('#figure-front button[value=runs]')?.click();
  document.getElementById('figure-front').scrollIntoView();
  await new Promise((done) => setTimeout(done, 200));
  const { data } = document.querySelector('#figure-front .plot');
  const named = (name) => (data.find((trace) => trace.name === name)?.text ?? []).map((text) => text.replace(/<[^>]*>/g, ''));
  const rows = [...document.querySelectorAll('.verdicts li')].map((item) => ({
    law: item.querySelector('b').textContent,
    mark: item.querySelector('path').getAttribute('d'),
  }));
  const wanted = report.findings.verdicts
    .filter((verdict) => verdict.role === 'not adequate')
    .map((verdict) => report.laws[verdict.law].id);
  const marks = (among) => [...new Set(rows.filter(among).map(({ mark }) => mark))];
  return {
    wanted,
    crossed: named('not adequate'),
    filled: named('not dominated').sort(),
    standing: report.findings.verdicts
      .filter((verdict) => !['dominated', 'not adequate', 'not ranked'].includes(verdict.role))
      .map((verdict) => report.laws[verdict.law].id)
      .sort(),
    own: marks(({ law }) => wanted.includes(law)),
    others: marks(({ law }) => !wanted.includes(law)),
    caption: document.querySelector('#figure-front figcaption').textContent,
  };
}

function check_inadequate(name, seen) {
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  expect(seen.wanted.length === 1 && same(seen.crossed, seen.wanted), name, 'crossed are ' + seen.crossed);
  expect(same(seen.filled, seen.standing), name, 'filled are ' + seen.filled);
  expect(seen.own.length === 1 && !seen.others.includes(seen.own[0]), name, 'marks of the list ' + seen.own);
  expect(seen.caption.includes('does not describe the devices: ' + seen.wanted[0]), name, 'caption ' + seen.caption);
}

// Looks at the contents and the controls of the report of an analysed campaign. This function runs in the page.
async function look_at_analysis() {
  const report = reportAsShown();
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const figure = (id) => document.getElementById('figure-' + id);
  const see = async (id) => {
    figure(id)?.scrollIntoView();
    await wait(200);
  };
  const plot = (id) => figure(id).querySelector('.plot').data;
  const caption = (id) => figure(id).querySelector('figcaption').textContent;

  const converged = figure('converged').cloneNode(true);
  for (const badge of converged.querySelectorAll('.badge')) badge.remove();
  const said = converged.textContent.replace(/\s/g, '');
  const badged = [...document.querySelectorAll('#figure-ranking tbody tr')].filter((row) => row.querySelector('.badge'));
  await see('front');
  const views = [];
  for (const button of document.querySelectorAll('#figure-front .choice button')) {
    button.click();
    await wait(50);
    views.push({
      names: plot('front').filter((trace) => trace.name !== 'published').flatMap((trace) => trace.text ?? []),
      ghosts: plot('front').find((trace) => trace.name === 'published')?.text ?? [],
      front: plot('front').find((trace) => trace.name === 'not dominated').text,
      caption: caption('front'),
      pressed: document.querySelectorAll('#figure-front .choice [aria-pressed=true]').length,
    });
  }

  const chooser = document.getElementById('examined');
  const law = report.laws[report.laws.length - 1];
  chooser.value = String(report.laws.length - 1);
  chooser.dispatchEvent(new Event('change'));
  await see('determined');
  const cells = [...document.querySelectorAll('#figure-determined td button')];
  const examined = (cell) => law.devices.find((fit) => fit.device === Number(cell.dataset.device)).determination;
  const verdictOf = (cell) => examined(cell).identifiability[cell.dataset.parameter];
  const shapes = {};
  for (const cell of cells) (shapes[verdictOf(cell)] ??= new Set()).add(cell.innerHTML.replace(/var\([^)]*\)/g, ''));
  const profile = () => {
    const [cell] = document.querySelectorAll('#figure-determined [aria-pressed=true]');
    const { profile: curves, identifiability } = examined(cell);
    const place = cell.dataset.parameter;
    const points = plot('profile').find((trace) => trace.mode === 'markers' && trace.y.length > 1);
    return {
      cell: cell.dataset.device + ' ' + cell.dataset.parameter,
      focused: document.activeElement === cell,
      right: JSON.stringify(points.y) === JSON.stringify(curves[place].objective),
      caption:
        caption('profile').includes(law.parameters[place].name + ' is held') &&
        caption('profile').includes(identifiability[place]),
    };
  };
  cells[0].click();
  await see('profile');
  const profiles = [profile()];
  for (const key of ['ArrowRight', 'ArrowDown']) {
    document
      .querySelector('#figure-determined [aria-pressed=true]')
      .dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    await wait(150);
    profiles.push(profile());
  }
  await see('trade-offs');
  const fit = law.devices.find((one) => profiles[2].cell.startsWith(one.device + ' '));
  const lower = (law.population?.correlation ?? []).flatMap((row, i) => row.slice(0, i));
  if (document.getElementById('lotLaw')) {
    document.getElementById('lotLaw').value = chooser.value;
    document.getElementById('lotLaw').dispatchEvent(new Event('change'));
    await see('lot-devices');
    await see('lot-correlation');
  }
  const collapsing = report.laws.filter((one) => one.prediction_collapses).map((one) => one.id);
  return {
    views,
    placed: [
      report.laws.filter((one) => one.beta !== null),
      report.laws.filter((one) => one.beta_converged !== null),
      report.laws.filter((one) => one.loo_objective !== null),
    ].map((some) => some.map((one) => one.id).sort()),
    fronts: ['on_front', 'on_front_converged', 'on_front_loo'].map((key) =>
      report.laws
        .filter((one) => one[key])
        .map((one) => one.id)
        .sort(),
    ),
    sentences: report.findings.converged.every(({ sentence }) => said.includes(asSet(sentence).replace(/\s/g, ''))),
    cells: cells.length,
    examined: law.devices.flatMap((one) => one.determination?.identifiability ?? []).filter(Boolean).length,
    reached: cells.filter((cell) => cell.tabIndex === 0).length,
    shapes: Object.values(shapes).map((some) => [...some]),
    named: cells.every((cell) => cell.getAttribute('aria-label').includes(verdictOf(cell))),
    profiles,
    tradeOffs: fit.trade_offs.every((text) =>
      figure('trade-offs').textContent.replace(/\s/g, '').includes(text.replace(/(^|[\s(])-(?=\d)/g, '$1\u2212').replace(/\s/g, '')),
    ),
    intervals: ['95', '42 samples', '100 fits'].every((text) => figure('trade-offs').textContent.includes(text)),
    posterior: /posterior/i.test(document.querySelector('main').textContent),
    lot: report.laws.filter((one) => one.lot).length,
    lotRows: document.querySelectorAll('#figure-lot-laws tbody tr').length,
    lotPoints: document.querySelector('#figure-lot-devices')
      ? plot('lot-devices')
          .slice(1)
          .map((trace) => trace.y)
      : [],
    lotValues: ['optimum', 'lot_objective', 'left_out_objective'].map((key) => law.devices.map((one) => one[key])),
    parameterRows: document.querySelectorAll('#figure-lot-parameters tbody tr').length,
    parameters: law.parameters.length,
    note: law.population ? caption('lot-parameters').toLowerCase().includes(law.population.note) : true,
    heat: document.querySelectorAll('#figure-lot-correlation .heat').length,
    correlations: lower.filter((value) => value !== null).length,
    apart: document.querySelectorAll('#figure-lot-outliers li').length,
    outliers: new Set(report.outliers.map((one) => one.device)).size,
    predictedRows: document.querySelectorAll('#figure-predictions tbody tr').length,
    predicted: report.laws.filter((one) => one.predicted_objective !== null).length,
    collapsing,
    badged: badged.map((item) => item.querySelector('b').textContent),
    flagged: [...document.querySelectorAll('#figure-predictions tbody tr')]
      .filter((row) => row.querySelector('.badge')?.textContent === 'unusable')
      .map((row) => row.querySelector('b').textContent),
  };
}

function check_analysis(name, seen, { devices }) {
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  const several = devices > 1;
  expect(seen.views.length === (several ? 3 : 0), name, `${seen.views.length} views of accuracy against robustness`);
  seen.views.forEach((view, i) => {
    expect(same([...view.names].sort(), seen.placed[i]), name, `view ${i} shows ${view.names}`);
    expect(same([...view.front].sort(), seen.fronts[i]), name, `view ${i} has the front ${view.front}`);
    expect(view.ghosts.length === (i === 0 ? 6 : 0), name, `view ${i} shows ${view.ghosts.length} published laws`);
    expect(/Open circles/.test(view.caption) === (i === 0), name, `view ${i} says nothing of the published laws`);
    expect(view.pressed === 1, name, `view ${i} has ${view.pressed} buttons pressed`);
  });
  expect(new Set(seen.views.map((view) => view.caption)).size === seen.views.length, name, 'views share a caption');
  expect(seen.sentences, name, 'a sentence on the laws without noise is not shown');
  expect(seen.cells === seen.examined, name, `${seen.cells} of ${seen.examined} examined parameters shown`);
  expect(seen.reached === 1, name, `${seen.reached} cells stop the tabulator`);
  expect(seen.named, name, 'a cell does not say its verdict');
  expect(
    seen.shapes.every((some) => some.length === 1) && new Set(seen.shapes.flat()).size === seen.shapes.length,
    name,
    'verdicts on parameters share a shape',
  );
  expect(
    seen.profiles.every((one) => one.right && one.caption),
    name,
    'profiles ' + JSON.stringify(seen.profiles),
  );
  expect(
    new Set(seen.profiles.map((one) => one.cell)).size === (several ? 3 : 2) && seen.profiles[1].focused,
    name,
    'arrow keys lead to ' + seen.profiles.map((one) => one.cell),
  );
  expect(seen.tradeOffs && seen.intervals, name, 'a trade-off, or what the intervals are, is not said');
  expect(!seen.posterior, name, 'the page speaks of a posterior');
  expect(seen.lotRows === seen.lot && seen.lot > 0 === several, name, 'rows of the one law for the lot');
  if (several) expect(same(seen.lotPoints, seen.lotValues), name, 'objectives per device of the one law');
  expect(seen.parameterRows === (several ? seen.parameters : 0), name, "rows of the lot's parameters");
  expect(seen.note, name, 'what the population does not cover is not said');
  expect(seen.heat === seen.correlations, name, `${seen.heat} of ${seen.correlations} correlations shown`);
  expect(seen.apart === seen.outliers, name, `${seen.apart} of ${seen.outliers} devices that stand apart`);
  expect(seen.predictedRows === seen.predicted, name, 'rows of the prediction');
  expect(
    seen.collapsing.length > 0 && same([...seen.badged].sort(), [...seen.collapsing].sort()) && same(seen.flagged, seen.collapsing),
    name,
    'predictions that collapse: ' + seen.badged + '; ' + seen.flagged,
  );
}

// Scrolls through the page as a reader does, uses all controls and returns what the page then showed. This function
// runs in the page.
async function look() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (condition) => {
    for (let i = 0; i < 100 && !condition(); ++i) await wait(30);
  };
  const isDrawn = (plot) => plot.querySelector('svg.main-svg .trace') !== null;
  const plots = [...document.querySelectorAll('.plot')];
  const drawnAtFirst = plots.filter(isDrawn).length;
  for (const plot of plots) {
    plot.scrollIntoView();
    await until(() => isDrawn(plot));
  }
  const drawn = plots.filter(isDrawn).length;
  const fitting = plots.filter(
    (plot) => plot.querySelector('svg.main-svg')?.getBoundingClientRect().width === plot.clientWidth,
  ).length;
  const titles = () =>
    plots.map((plot) => plot.querySelector('.main-svg')?.textContent ?? '').join('|') +
    document.querySelector('#figure-loop figcaption, #figure-cycles figcaption')?.textContent;
  const before = titles();
  for (const details of document.querySelectorAll('details')) details.open = true;
  // The certificate's list of devices repeats the list in the section on properties, so it is left out here.
  for (const select of document.querySelectorAll('select:not(#certificate-of)')) {
    const last = select.options.length - 1;
    select.selectedIndex = select.selectedIndex === last ? 0 : last;
    select.dispatchEvent(new Event('change'));
  }
  for (const box of document.querySelectorAll('input[type=checkbox]')) box.click();
  document.querySelector('#figure-loop, #figure-cycles').scrollIntoView(); // only visible figures are drawn again
  await wait(300);
  for (const button of document.querySelectorAll('button.csv')) button.click();
  await wait(100);
  // Tables and the table of contents may be wider than the page, because they scroll by themselves. Nothing else may be
  // wider, except the skip link and what lies inside a figure.
  const width = document.documentElement.clientWidth;
  const wide = [...document.querySelectorAll('body *')].filter(
    (node) => !node.closest('.scroll, nav, .skip, svg') && node.getBoundingClientRect().right > width + 1,
  );
  return {
    plots: plots.length,
    drawnAtFirst,
    drawn,
    fitting,
    controlsDoSomething: titles() !== before,
    errors: document.body.dataset.errors,
    uncaptioned: [...document.querySelectorAll('figcaption')].filter((caption) => caption.textContent.trim() === '')
      .length,
    tables: document.querySelectorAll('table').length,
    wide: wide.slice(0, 3).map((node) => node.tagName + ' ' + node.className),
    scrolls: document.documentElement.scrollWidth > width,
    images: document.querySelectorAll('img').length,
    nastyName: document.body.innerText.includes('<img src=x onerror=alert(1)>'),
    unlabelled: [...document.querySelectorAll('select, input')].filter((control) => control.labels.length === 0).length,
    paper: getComputedStyle(document.body).backgroundColor,
    published: look_at_published(),
  };

  // Returns whether the comparison with the published study shows every row that the data have.
  function look_at_published() {
    const { published, laws } = reportAsShown();
    const section = document.getElementById('published');
    if (!published || !section) return { missing: Boolean(published) !== Boolean(section), laws: laws.length };
    const rows = (id) => [...section.querySelectorAll(`#figure-${id} tbody tr`)].map((row) => row.textContent);
    const tones = { true: 'holds', false: 'does not', null: 'open' };
    const said = rows('published-statements');
    const lawRows = rows('published-laws');
    return {
      missing: false,
      laws: laws.length,
      verdict: section.querySelector('.headline').textContent === asSet(published.verdict),
      statements:
        said.length === published.statements.length &&
        published.statements.every(({ text, here, found }, i) => [text, tones[here], found].every((word) => said[i].includes(asSet(word)))),
      byLaw:
        lawRows.length === published.laws.length &&
        published.laws.every((law, i) => lawRows[i].startsWith(law.number + law.law) && lawRows[i].includes(law.published_objective.toFixed(4))),
    };
  }
}

// Sorts the table of laws by each column. Returns for each column the order of the laws in the table and in the figure
// of loops, which must be the same. This function runs in the page.
async function look_at_order() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const seen = [];
  for (const head of document.querySelectorAll('#figure-fits button.sort')) {
    document.getElementById('figure-fits').scrollIntoView(); // only visible figures are drawn again
    await wait(150);
    head.click();
    document.querySelector('#figure-loop-overview').scrollIntoView();
    await wait(250);
    seen.push({
      head: head.textContent,
      laws: [...document.querySelectorAll('#figure-fits tbody tr')].map((row) => row.children[0].querySelector('b').textContent),
      loops: document.querySelector('#figure-loop-overview .plot').layout.annotations.map((a) => /<b>(.*)<\/b>/.exec(a.text)[1]),
      caption: document.querySelector('#figure-loop-overview figcaption').textContent,
    });
  }
  return seen;
}

// Returns the areas of the drawn loops and the number of cycles of the record. report_numbers.mjs checks the values.
// This function runs in the page.
async function look_at_energy() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const report = reportAsShown();
  const figure = document.getElementById('figure-loop-energy');
  figure.scrollIntoView();
  for (let tries = 0; tries < 100 && !figure.querySelector('.plot')?.data; ++tries) await wait(100);
  await wait(300);
  const device = report.devices[document.getElementById('device').value];
  const cycles = device.blocks.flatMap((block) => block.cycles.filter((cycle) => cycle.counts));
  const [measured, ...computed] = figure.querySelector('.plot').data;
  return {
    cycles: cycles.length,
    bars: measured.y.length,
    laws: computed.map(({ name, y }) => ({ name, energies: [...y] })),
    chosen: [...document.querySelectorAll('#loops input:checked')].map((box) => box.parentNode.textContent),
  };
}

function check_energy(name, { cycles, bars, laws, chosen }) {
  expect(cycles > 0 && bars === cycles, name, `${cycles} cycles, energies of ${bars}`);
  expect(JSON.stringify(laws.map((law) => law.name).sort()) === JSON.stringify(chosen.sort()), name, 'energies of ' + laws.map((law) => law.name));
  for (const law of laws)
    expect(law.energies.length === bars && law.energies.every(Number.isFinite), name, `energies of ${law.name}: ${law.energies}`);
}

function check_order(name, seen, { laws: rows }) {
  expect(rows > 3 ? seen.length >= 7 : seen.length === 0, name, `${seen.length} heads sort`);
  for (const { head, laws, loops, caption } of seen) {
    expect(loops.every((law, i) => laws.filter((one) => loops.includes(one))[i] === law), name, `${head}: ${laws}; loops ${loops}`);
    expect(caption.includes(`by ${head}, `), name, `${head}: ${caption}`);
  }
}

// Returns how many bands of limits the figures of the lot draw, and how many properties the rule set limits. The two
// must be equal. This function runs in the page.
function look_at_bands() {
  const { assessment } = reportAsShown();
  const limited = (assessment?.lot.quantities ?? [])
    .filter((quantity) => quantity.limit_individual !== '' && quantity.nominal !== null)
    .map((quantity) => quantity.quantity);
  const drawn = (figure) =>
    (document.querySelector('#figure-' + figure + ' .plot')?.layout.shapes ?? []).filter(({ type }) => type === 'rect')
      .length;
  return {
    strips: [drawn('lot-strips'), limited.length],
    stability: [
      drawn('lot-stability'),
      limited.filter((quantity) => ['K_eff', 'damping', 'energy'].includes(quantity)).length,
    ],
  };
}

function check_bands(name, seen) {
  for (const [figure, [drawn, limited]] of Object.entries(seen))
    expect(drawn === limited, name, `${drawn} bands of ${limited} limits on the lot: ${figure}`);
}

// Looks at the first screen of a lot with a rule set. The verdict and the list of failures must end within 600 px, and
// no loop may come before the verdict. This function runs in the page.
function look_at_verdict() {
  scrollTo(0, 0);
  const { result } = reportAsShown();
  const bottom = (node) => node.getBoundingClientRect().bottom;
  const band = document.querySelector('.band');
  const order = [...document.querySelectorAll('figure')].map(({ id }) => id.replace('figure-', ''));
  return {
    word: band?.querySelector('.word')?.textContent ?? null,
    chip: document.querySelector('#facts .word')?.textContent ?? null,
    wordEnds: band ? bottom(band.querySelector('.word') ?? band) : null,
    saidEnds: band ? bottom(band.querySelector('.said')) : null,
    said: band?.textContent ?? '',
    order: order.filter((id) => ['verdict', 'lot-strips', 'assessments', 'cycles'].includes(id)),
    result,
  };
}

function check_verdict(name, seen, { devices, width, inspects }) {
  const { result } = seen;
  expect(seen.word === result.word, name, `the band says ${seen.word}, the result ${result.word}`);
  expect(inspects || seen.chip === result.word, name, `the head says ${seen.chip}`);
  for (const { device } of result.failing.slice(0, 10))
    expect(seen.said.toLowerCase().includes((device ?? 'the lot').toLowerCase()), name, (device ?? 'the lot') + ' fails and is not named');
  if (!inspects) return;
  expect(seen.wordEnds < 600 && (width < 1000 || seen.saidEnds < 600), name, `the verdict ends at ${seen.saidEnds} px`);
  const opens = devices > 1 ? 'verdict,lot-strips,' : 'verdict,assessments,';
  expect(seen.order.join().startsWith(opens), name, 'the page opens with ' + seen.order);
}

// Fills in lines of the certificate and of the page of the chosen device, chooses another device and presses the button
// that prints the certificate. This function runs in the page.
function fill_in_and_print() {
  const type = (line, text) => {
    if (!line) return;
    line.textContent = text;
    line.dispatchEvent(new Event('input'));
  };
  type(document.querySelector('.device-page .blank'), 'A. Tester');
  type(document.querySelector('#figure-certificate-head [aria-label="Certificate number"]'), 'C-17');
  const device = document.getElementById('certificate-of');
  if (device) {
    device.selectedIndex = (device.selectedIndex + 1) % device.options.length;
    device.dispatchEvent(new Event('change'));
  }
  window.print = () => {};
  [...document.querySelectorAll('#certificate button')].find(({ textContent }) => textContent.startsWith('Print')).click();
}

// The certificate can be printed alone. The paper must then show all parts of the certificate and nothing else.
async function check_certificate(page, name, pictures, { state, letterhead = '' }) {
  await page.evaluate(`(${fill_in_and_print})()`);
  const seen = await page.evaluate(`(() => {
    const report = reportAsShown();
    const { rule_set, lot } = report.assessment ?? {};
    const judged = [...report.devices.flatMap((device) => device.assessments), lot?.sample,
      ...(lot?.quantities ?? []).flatMap((quantity) => quantity.mean_limits)].filter((one) => rule_set && one);
    const shown = (node) => node.getClientRects().length > 0;
    return {
      sections: [...document.querySelectorAll('#report > section')].filter(shown).map((section) => section.id),
      devices: document.querySelectorAll('#figure-certificate-devices tbody tr').length,
      limits: [...document.querySelectorAll('#figure-certificate-limits tbody tr')].map((row) => row.cells[0].textContent + ': ' + row.querySelector('.verdict').textContent),
      requirements: report.result.requirements.map(({ name, verdict }) => asSet(name) + ': ' + verdict),
      blanks: [...document.querySelectorAll('#certificate .blank')].filter(shown).length,
      masthead: shown(document.querySelector('.masthead')),
      names: report.devices.length,
      hashes: [...document.querySelectorAll('#figure-certificate-records .hash')].map((hash, i) => hash.textContent === report.devices.flatMap(({ tests, sha256 }) => (tests.length > 0 ? tests.map((test) => test.sha256) : [sha256]))[i]),
      mark: document.getElementById('certificate').dataset.mark ?? null,
      wanted: report.result.mark,
      word: report.result.word,
      result: document.querySelector('#figure-certificate-head').textContent.includes(asSet(report.result.sentence).replace(/(\\d) %/g, '$1\\u202f%')),
      isRed: report.result.mark_is_red,
      signatures: [...document.querySelectorAll('#certificate .page-foot')].filter(shown).length,
      signers: [...document.querySelectorAll('#certificate .signer')].filter(shown).length,
      height: document.querySelector('#figure-certificate-signature').getBoundingClientRect().bottom - document.getElementById('certificate').getBoundingClientRect().top,
      misfits: /misfit/.test(document.getElementById('certificate').textContent),
      alone: [...document.querySelectorAll('#certificate figure:not(#figure-certificate-limits, #figure-certificate-device) .verdict')].filter((badge) => badge.textContent === 'pass').length,
      open: report.devices.flatMap((device) => device.assessments).some(({ verdict, limit }) => limit && verdict === 'not assessed'),
      failsWithTheLot: judged.some(({ verdict }) => verdict === 'fail') === (document.querySelector('#figure-certificate-head .verdict')?.textContent === 'FAIL'),
    };
  })()`);
  expect(JSON.stringify(seen.sections) === '["certificate"]', name, 'printed with the certificate: ' + seen.sections);
  expect(seen.devices === seen.names, name, `${seen.devices} devices on the certificate`);
  expect(JSON.stringify(seen.limits) === JSON.stringify(seen.requirements), name, 'requirements on the certificate: ' + seen.limits);
  // Nobody may sign a certificate with a grey mark. Otherwise three people sign a pass and two people any other result,
  // both on the page of the lot and on the page of the shown device.
  const signers = (seen.mark && !seen.isRed ? 0 : seen.word === 'PASS' ? 3 : 2) * seen.signatures;
  const signed = 3 * signers;
  expect(seen.mark === seen.wanted, name, `the certificate is marked ${seen.mark}, not ${seen.wanted}`);
  const lines = seen.blanks - signed - (letterhead ? 2 : 3);
  expect(lines >= 0 && lines <= 2 && !seen.masthead, name, `${seen.blanks} lines to fill in`);
  expect(seen.signers === signers, name, `${seen.signers} may sign what is marked ${seen.mark}`);
  expect(seen.result, name, 'the certificate does not say what was shown');
  expect(!seen.misfits, name, 'a law is on the certificate');
  // A4 paper has 271 mm between its upper and lower margins, which is 1024 px. With up to 12 devices, values and
  // signatures must fit on one page.
  expect(seen.names > 12 || seen.height < 1024, name, `values and signatures take ${Math.round(seen.height)} px of paper`);
  expect(!(seen.open && state) || seen.alone === 0, name, `${seen.alone} bare passes on a certificate with open requirements`);
  expect(seen.hashes.length > 0 && seen.hashes.every(Boolean), name, 'a file of the certificate is not its own');
  expect(seen.failsWithTheLot, name, 'the certificate has another verdict than the lot');
  // Every device with a record has a page of its own, which fits on one sheet and shows the loop, the SHA-256, the
  // number of the certificate, and what was filled in.
  const sheets = await page.evaluate(`(() => {
    const found = [...document.querySelectorAll('.device-page')].map((sheet) => ({
      height: sheet.getBoundingClientRect().height,
      loops: sheet.querySelectorAll('.loop-drawing .all').length,
      hash: /[0-9a-f]{64}/.test(sheet.textContent),
      number: sheet.textContent.includes('C-17'),
      letterhead: sheet.querySelector('.letterhead')?.innerHTML ?? '',
    }));
    const { devices } = reportAsShown();
    return { found, wanted: devices.length > 1 ? devices.filter((device) => device.raw?.samples > 0).length : 0 };
  })()`);
  expect(sheets.found.length === sheets.wanted, name, `${sheets.found.length} pages of devices, ${sheets.wanted} expected`);
  for (const sheet of sheets.found) {
    const { height, loops, hash, number } = sheet;
    expect(height < 1024 && loops === 1 && hash && number, name, `the page of a device: ${height} px, ${loops} loops, SHA-256 ${hash}, number ${number}`);
    expect(sheet.letterhead === letterhead, name, 'letterhead ' + sheet.letterhead);
  }
  const filledIn = () => page.evaluate("[...document.querySelectorAll('.device-page .blank')].filter(({ textContent }) => textContent === 'A. Tester').length");
  expect((await filledIn()) === (sheets.wanted > 0 && signers > 0 ? 1 : 0), name, 'what was filled in is not printed');
  if (pictures) {
    const { data } = await page.send('Page.printToPDF', { preferCSSPageSize: true, printBackground: true });
    writeFileSync(join(pictures, name + '-certificate.pdf'), Buffer.from(data, 'base64'));
  }
}

// The units stand in the address. If the user enters an address with other units, the page must load again with them. A
// link of the table of contents must keep the units. If the address names unknown units, the page must use the report's
// own.
async function check_units(browser, url, name, size) {
  const page = await browser.open(url, size);
  // Returns null while the page loads.
  const shown = () => page.evaluate("document.querySelector('.units [aria-pressed=true]')?.value").catch(() => null);
  const address = () => page.evaluate('decodeURIComponent(location.hash)');
  const become = async (units, change) => {
    await page.evaluate(change);
    for (let i = 0; i < 100 && (await shown()) !== units; ++i) await new Promise((done) => setTimeout(done, 50));
    expect((await shown()) === units, name, `${change} shows ${await shown()}, address ${await address()}`);
  };
  await become('kip-in', "document.querySelector('.units [value=kip-in]').click()");
  await page.evaluate("document.querySelector('#contents a:last-child').click(); new Promise((done) => setTimeout(done, 100))");
  expect(/^#provenance.*units=kip-in/.test(await address()), name, 'after a link of the contents the address is ' + (await address()));
  await become('N-m', "location.hash = '#certificate?units=N-m'");
  await become('N-m', "location.hash = '#certificate?units=unknown'");
  await become('kN-mm', "location.hash = '#certificate?units=kN-mm'");
  expect(page.errors.length === 0, name, 'errors in other units: ' + page.errors.join('; '));
  await page.close();
  const unknown = await browser.open(url + '#certificate?units=unknown', size);
  const units = await unknown.evaluate("document.querySelector('.units [aria-pressed=true]').value");
  expect(units === 'kN-mm', name, 'unknown units show ' + units);
  await unknown.close();
}

const failures = [];
function expect(holds, name, what) {
  if (!holds) failures.push(`${name}: ${what}`);
}

async function photograph(page, { name, width, height }, directory) {
  await page.evaluate('scrollTo(0, 0)');
  const length = Math.min(await page.evaluate('document.documentElement.scrollHeight'), 20000);
  for (let top = 0, part = 1; top < length; top += 2 * height, ++part) {
    await page.evaluate(`scrollTo(0, ${top}); new Promise((done) => setTimeout(done, 300))`);
    const { data } = await page.send('Page.captureScreenshot', {
      captureBeyondViewport: true,
      clip: { x: 0, y: top, width, height: Math.min(2 * height, length - top), scale: 1 },
    });
    writeFileSync(join(directory, `${name}-${String(part).padStart(2, '0')}.png`), Buffer.from(data, 'base64'));
  }
}

async function check(browser, directory, one) {
  const { name, devices, laws, dark, records = {} } = one;
  const out = join(directory, name);
  execFileSync(makePage, [out, String(devices), String(laws), ...['analysed', 'inadequate'].filter((state) => one[state]), ...(one.state ? [one.state] : [])], {
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  const file = join(out, 'report.html');
  if (records)
    writeFileSync(
      file,
      with_data(readFileSync(file, 'utf8'), (report) => {
        const written = shape(report);
        const made_up = { ...extend(report, records), letterhead: one.letterhead ?? '' };
        for (const [what, keys] of Object.entries(shape(made_up)))
          expect(
            !keys || !written[what] || keys === written[what],
            name,
            `made-up ${what}: ${keys}, the program writes ${written[what]}`,
          );
        for (const { source } of made_up.assessment?.lot.factors ?? [])
          expect(SOURCES.includes(source), name, 'the program writes no factor of ' + source);
        return made_up;
      }),
    );
  const page = await browser.open(pathToFileURL(file).href, one);
  await page
    .send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: join(out, 'downloads') })
    .catch(() => {});
  const firstScreen = await page.evaluate(`new Promise((done) => {
    const look = () => document.querySelector('.plot svg.main-svg .trace') ? done(performance.now()) : setTimeout(look, 20);
    look();
  })`);
  const pictures = process.env.ISOLAW_SCREENSHOTS;
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await photograph(page, one, pictures);
  }
  const { laws: identified = laws > 0 } = records || {}; // without `records` the page keeps its `laws` laws
  if (identified) check_answer(name, await page.evaluate(`(${look_at_answer})()`), one);
  const seen = await page.evaluate(`(${look})()`);
  console.log(name, JSON.stringify({ firstScreen: Math.round(firstScreen), ...seen }));

  expect(page.errors.length === 0 && seen.errors === '', name, 'errors: ' + [...page.errors, seen.errors].join('; '));
  expect(page.requests.length === 0, name, 'requested ' + page.requests.join(', '));
  // The inspection of a single device lacks the figures of the lot. A record with one block lacks the figure of its
  // history.
  const ofTests = identified ? 5 : 5 - (devices > 1 ? 0 : 2) - (one.state ? 1 : 0);
  const expected = (identified ? (devices > 24 ? 13 : devices > 1 ? 12 : 9) : 0) + ofTests + (one.analysed ? (devices > 1 ? 2 : 1) : 0);
  expect(
    seen.plots === expected && seen.drawn === expected,
    name,
    `${seen.drawn} of ${seen.plots} figures drawn, ${expected} expected`,
  );
  expect(seen.fitting === seen.plots, name, `${seen.plots - seen.fitting} figures do not fill their place`);
  expect(seen.controlsDoSomething || (one.state && devices === 1), name, 'choosing another device and other laws changed nothing');
  expect(seen.uncaptioned === 0, name, 'a caption is empty');
  expect(!seen.scrolls && seen.wide.length === 0, name, 'wider than the window: ' + seen.wide.join(', '));
  const { published } = seen;
  expect(!published.missing && (published.verdict ?? true), name, 'the published study is missing, or its verdict is');
  expect((published.statements ?? true) && (published.byLaw ?? true), name, 'a row of the published study is not shown');
  expect(!identified || published.laws < 2 || published.verdict, name, 'no section of the published study');
  expect(seen.images === 0 && (seen.nastyName || one.state), name, 'a name from the input is not shown as text');
  expect(seen.unlabelled === 0, name, 'a control has no label');
  expect(seen.paper === (dark ? 'rgb(20, 25, 29)' : 'rgb(255, 255, 255)'), name, 'paper is ' + seen.paper);

  const megabytes = readFileSync(file).length / 1e6;
  expect(megabytes < 30, name, `${megabytes.toFixed(1)} MB`);
  if (identified) check_order(name, await page.evaluate(`(${look_at_order})()`), one);
  if (identified) check_energy(name, await page.evaluate(`(${look_at_energy})()`));

  const inspects = !identified;
  check_verdict(name, await page.evaluate(`(${look_at_verdict})()`), { ...one, inspects });
  if (devices > 1 || !inspects) check_bands(name, await page.evaluate(`(${look_at_bands})()`));
  if (one.inadequate) check_inadequate(name, await page.evaluate(`(${look_at_inadequate})()`));
  if (one.analysed) check_analysis(name, await page.evaluate(`(${look_at_analysis})()`), one);
  if (records) check_records(name, await page.evaluate(`(${look_at_records})()`), records);

  // On paper the report must be light even if the screen is dark, and nothing may be cut off at the right edge.
  await page.send('Emulation.setDeviceMetricsOverride', {
    width: 681,
    height: 960,
    deviceScaleFactor: 1,
    mobile: false,
  }); // 180 mm, the width between the margins of A4
  await page.send('Emulation.setEmulatedMedia', { media: 'print' });
  const cut = await page.evaluate(`(async () => {
    dispatchEvent(new Event('beforeprint'));
    await new Promise((done) => setTimeout(done, 500));
    return [...document.querySelectorAll('main *')].filter((node) => !node.closest('svg') && node.getClientRects().length > 0
      && node.getBoundingClientRect().right > 684).slice(0, 3).map((node) => node.tagName + ' ' + node.className + ' ' + node.textContent.slice(0, 30));
  })()`);
  expect(cut.length === 0, name, 'cut off on paper: ' + cut.join(', '));
  const captions = () =>
    page.evaluate("[...document.querySelectorAll('figcaption, #colophon')].map((node) => node.innerText).join(' ')");
  const onPaper = await captions();
  for (const absent of ['CSV', 'Choose a'])
    expect(!onPaper.includes(absent), name, 'paper speaks of what it has not: ' + absent);
  if (pictures) {
    await photograph(page, { name: name + '-print', width: 681, height: 960 }, pictures);
    const { data } = await page.send('Page.printToPDF', { preferCSSPageSize: true, printBackground: true });
    writeFileSync(join(pictures, name + '.pdf'), Buffer.from(data, 'base64'));
  }
  await check_certificate(page, name, pictures, one);
  await page.evaluate("dispatchEvent(new Event('afterprint'))");
  expect(await page.evaluate("document.querySelectorAll('.device-page').length <= 1 && !document.querySelector('table.part, table[hidden]') && !('only' in document.documentElement.dataset)"), name, 'after printing the page is that of paper');
  await page.send('Emulation.setEmulatedMedia', { media: 'screen' });
  expect((await captions()).includes('CSV'), name, 'after printing the captions are those of paper');
  await page.close();
  if (name === 'laptop' || name === 'inspection') await check_units(browser, pathToFileURL(file).href, name, one);
  return firstScreen;
}

const directory = mkdtempSync(join(tmpdir(), 'isolaw-browser-'));
const browser = new Chromium(program);
try {
  for (const one of CASES.filter((one) => group_of(one) === group)) {
    const firstScreen = await check(browser, directory, one);
    // A slow first screen is only noted, because machines differ in speed.
    if (firstScreen > FIRST_SCREEN_MS)
      console.log(`note: ${one.name} took ${Math.round(firstScreen)} ms to its first figure`);
  }
} finally {
  await browser.close();
  rmSync(directory, { recursive: true, force: true });
}
for (const failure of failures) console.log('FAILED ' + failure);
if (failures.length === 0) console.log('the report opens, draws, fits and prints in every case');
process.exit(failures.length === 0 ? 0 : 1);
