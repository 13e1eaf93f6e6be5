// The certificate: what a laboratory signs, on one or two pages of its own

section({ id: 'certificate', title: 'Certificate', controls: certificateControls }, [
  {
    id: 'certificate-head',
    title: '',
    build: certificateHead,
  },
  {
    id: 'certificate-devices',
    title: 'Devices',
    long: true,
    caption: certificateCaption,
    csv: certificateData,
    build: certificateTable,
  },
  {
    id: 'certificate-bounds',
    title: 'Lower and upper bound values',
    wanted: () => boundRows().length > 0,
    caption: boundsCaption,
    csv: () => ({
      columns: ['property', 'unit', 'design value', 'mean of the lot', 'lower bound', 'upper bound', 'of', 'from'],
      rows: boundRows().map((b) => [b.property, b.unit, b.nominal, b.mean, b.lower, b.upper, b.of, b.from]),
    }),
    build: boundsTable,
  },
  {
    id: 'certificate-signature',
    title: '',
    build: signatureBlock,
  },
  {
    id: 'certificate-records',
    title: 'Records',
    long: true,
    caption: () => 'SHA-256 of each file as it was read: a changed file is another record.',
    build: recordsTable,
  },
]);

// Prints this section alone.
function certificateControls() {
  const button = element('button', { type: 'button', class: 'action' }, 'Print the certificate alone');
  button.addEventListener('click', () => {
    document.documentElement.dataset.only = 'certificate';
    window.print();
  });
  window.addEventListener('afterprint', () => delete document.documentElement.dataset.only);
  return [button, element('span', { class: 'muted' }, 'The lines below can be filled in here before printing.')];
}

// A line to write on, here or on paper. It is kept nowhere but on the page.
function blank(label, text = '') {
  return element(
    'span',
    { class: 'blank', contenteditable: 'plaintext-only', role: 'textbox', spellcheck: 'false', 'aria-label': label },
    text,
  );
}

const reportedBlock = (device) => device.blocks.find((block) => block.number === device.reported?.block);
const allDevices = (key) => [...new Set(devices.map((device) => device[key]).filter(Boolean))];
const spanText = (values, decimals) => {
  const some = values.filter(isNumber);
  if (some.length === 0) return null;
  const [low, high] = [Math.min(...some), Math.max(...some)].map((value) => fixed(value, decimals));
  return low === high ? low : low + ' to ' + high;
};

function certificateHead() {
  const rules = report.assessment?.rule_set ?? null,
    lot = report.assessment?.lot ?? null;
  const lots = allDevices('lot'),
    dates = allDevices('test_date').sort(),
    temperature = spanText(
      devices.map((device) => device.temperature_C),
      1,
    );
  const tests = devices.map(reportedBlock),
    amplitude = spanText(
      tests.map((block) => block?.amplitude_mm),
      1,
    ),
    frequency = spanText(
      tests.map((block) => block?.frequency_Hz),
      2,
    );
  const conditions = [
    amplitude ? 'amplitude ' + amplitude + THIN + 'mm' : '',
    frequency ? frequency + THIN + 'Hz' : '',
  ].filter(Boolean);
  const steps = [...new Set(devices.flatMap((device) => device.blocks.map((block) => significant(block.amplitude_mm, 3))))];
  const load = spanText(
    devices.map((device) => reportedCycle(device)?.N_mean_kN),
    0,
  );
  const thickness = spanText(
      devices.map((device) => device.rubber_thickness_mm),
      1,
    ),
    area = spanText(
      devices.map((device) => device.rubber_area_mm2),
      0,
    );
  const rubber = [
    thickness ? 'thickness ' + thickness + THIN + 'mm' : '',
    area ? 'area ' + area + THIN + 'mm\u00b2' : '',
  ].filter(Boolean);
  const limits = limitSentences(),
    remarks = certificateRemarks();
  const facts = [
    ['Laboratory', blank('Laboratory')],
    ['Client, project', blank('Client, project')],
    ['Certificate no.', numberBlank()],
    ['Test', 'cyclic shear of ' + count(devices.length, 'device') + (isNumber(lot?.size) ? ' of a lot of ' + lot.size : '')],
    ...(lots.length > 0 ? [['Lot', enumerate(lots)]] : []),
    [
      'Tested',
      dates.length > 0 ? dates[0] + (dates.length > 1 ? ' to ' + dates[dates.length - 1] : '') : blank('Date of the tests'),
    ],
    ['Temperature', temperature ? temperature + THIN + '\u00b0C' : blank('Temperature')],
    ...(conditions.length > 0 ? [['Conditions', conditions.join(', ')]] : []),
    ...(steps.length > 1 ? [['Blocks tested', '\u00b1' + steps.join(', \u00b1') + THIN + 'mm']] : []),
    ...(load ? [['Vertical load', load + THIN + 'kN (mean of the cycle)']] : []),
    ...(rubber.length > 0 ? [['Rubber', rubber.join(', ')]] : []),
    [
      'Held to',
      rules
        ? rules.title + (rules.edition ? ', ' + rules.edition : '') + (rules.verified_by ? '' : ' (limits not verified: no verdict)')
        : 'no rule set: values, no verdict',
    ],
    ...(report.assessment?.design?.length > 0
      ? [
          [
            'Design values',
            report.assessment.design.map(({ name, value, unit }) => name + ' ' + trimmed(value) + THIN + unit).join(', '),
          ],
        ]
      : []),
    ...(limits.length > 0 ? [['Limits', limits.join('; ')]] : []),
    ['Result', certificateResult()],
    ...(remarks.length > 0 ? [['Remarks', listOf(remarks)]] : []),
  ];
  return element(
    'div',
    {},
    element('p', { class: 'certificate-title' }, 'Test certificate: ' + (report.title || 'isolation devices')),
    element(
      'dl',
      { class: 'facts-list' },
      ...facts.flatMap(([term, text]) => [
        element('dt', {}, term),
        element('dd', {}, typeof text === 'string' ? sentence(text) : text),
      ]),
    ),
  );
}

// What no device could be assessed for: said once, for all of them.
function commonlyOpen() {
  const judged = devices.filter((device) => device.assessments.length > 0);
  if (judged.length === 0 || judged.every((device) => deviceVerdict(device).verdict !== 'pass')) return [];
  const open = (device) => device.assessments.filter((a) => a.verdict === 'not assessed').map((a) => a.quantity);
  return [...new Set(open(judged[0]))].filter((quantity) => judged.every((device) => open(device).includes(quantity)));
}

// The worst of a device's verdicts, with what could not be assessed of it.
function deviceVerdict(device) {
  const verdict = worstVerdict(device.assessments.map((a) => a.verdict));
  const named = (wanted) => [
    ...new Set(device.assessments.filter((a) => a.verdict === wanted).map((a) => a.quantity)),
  ];
  return { verdict, failed: named('fail'), open: verdict === 'pass' ? named('not assessed') : [] };
}

const listOf = (sentences) =>
  element('ul', { class: 'plain-list' }, ...sentences.map((text) => element('li', {}, sentence(text))));

// The number is written once and stands beside the signatures too.
function numberBlank() {
  const line = blank('Certificate number');
  line.addEventListener('input', () => {
    for (const echo of document.querySelectorAll('.certificate-number')) echo.textContent = line.textContent;
  });
  return line;
}

// Limits with their clauses, each said once.
function limitSentences() {
  // Of a device, or of its two sides.
  const clauseOf = (quantity) =>
    devices
      .flatMap((device) => device.assessments)
      .find((a) => a.clause && (a.quantity === quantity || a.quantity.startsWith(quantity + ',')))?.clause;
  return lotQuantities
    .filter((quantity) => quantity.limit_individual || quantity.limit_mean)
    .map(
      (quantity) =>
        quantity.quantity +
        ' ' +
        [
          quantity.limit_individual ? limitText(quantity.limit_individual) + ' of the design value' : '',
          quantity.limit_mean ? 'mean of the lot ' + limitText(quantity.limit_mean) : '',
        ]
          .filter(Boolean)
          .join(', ') +
        (clauseOf(quantity.quantity) ? ' (' + clauseOf(quantity.quantity) + ')' : ''),
    );
}

// What a reader of the sheet must know of the records: doubts, corrections, what the program was told of them.
function certificateRemarks() {
  const topics = new Set(['copies', 'record', 'refused']);
  const grouped = (key) => {
    const found = new Map();
    for (const device of devices) for (const text of device[key]) found.set(text, [...(found.get(text) ?? []), device.name]);
    return [...found].map(
      ([text, names]) => (names.length === devices.length && names.length > 1 ? 'all devices' : enumerate(names)) + ': ' + text,
    );
  };
  const told = new Map();
  for (const device of devices)
    for (const text of device.recognised.filter((line) => /--dt|--units|as asked for|as given/.test(line)))
      told.set(text, [...(told.get(text) ?? []), device.name]);
  return [
    ...report.findings.warnings.filter((warning) => topics.has(warning.topic)).map((warning) => warning.sentence),
    ...grouped('corrections').map((text) => 'corrected, ' + text),
    ...[...told].map(([text, names]) => (names.length === devices.length ? 'all devices' : enumerate(names)) + ': ' + text),
  ];
}

function certificateResult() {
  if (!report.assessment?.rule_set) return 'values, no verdict';
  const { sample } = report.assessment.lot;
  const verdicts = devices.map((device) => deviceVerdict(device).verdict);
  const times = (verdict) => verdicts.filter((found) => found === verdict).length;
  const lot = lotQuantities
    .filter((quantity) => quantity.verdict)
    .map(({ quantity, verdict, reason }) => ({ what: 'mean ' + quantity + ' of the lot', verdict, reason }));
  if (sample?.verdict) lot.unshift({ what: 'size of the sample: ' + sampleText({ ...sample, verdict: '' }), verdict: sample.verdict, reason: '' });
  const open = commonlyOpen();
  const said = [
    ...lot.map(({ what, verdict, reason }) => what + ': ' + verdict + (reason ? ' (' + reason + ')' : '')),
    times('fail') > 0 ? count(times('fail'), 'device') + ' outside a limit' : '',
    times('pass') > 0 ? count(times('pass'), 'device') + ' within the limits that could be assessed' : '',
    times('information') > 0 ? count(times('information'), 'device') + ' compared, without verdict' : '',
    times('not assessed') + times(null) > 0 ? count(times('not assessed') + times(null), 'device') + ' not assessed' : '',
    open.length > 0 ? 'not assessed on any device: ' + open.join(', ') : '',
  ].filter(Boolean);
  const overall = worstVerdict([...verdicts.filter(Boolean), ...lot.map(({ verdict }) => verdict)]);
  return element('div', {}, overall ? verdictBadge(overall) : null, listOf(said));
}

// Properties of the certificate: those of the lot where a rule set says which, else of the reported cycle.
const certificateProperties = () =>
  lotQuantities.length > 0
    ? lotQuantities.map((quantity) => ({
        title: quantity.quantity,
        unit: quantity.unit,
        value: (device) => deviceValue(device, quantity.quantity)?.value,
      }))
    : [
        { title: 'K_eff', unit: 'kN/mm', value: (device) => reportedCycle(device)?.K_eff_kN_per_mm },
        { title: 'damping', unit: '%', value: (device) => reportedCycle(device)?.damping_percent },
      ];

// What sets a device apart, in its test and in the laws' misfits.
function apart(device) {
  const own = (outliers) => outliers.filter((outlier) => outlier.device === device.name);
  const tested = lotQuantities.length > 0;
  return [
    ...(tested ? own(report.assessment.lot.outliers).map((outlier) => outlier.quantity) : []),
    // Misfits have no unit; of the others the lot has spoken.
    ...own(report.outliers).filter((outlier) => !tested || outlier.unit === '').map((outlier) => outlier.property),
  ];
}

function certificateCaption() {
  const marked = devices.some((device) => apart(device).length > 0);
  const unjudged = [...new Set(lotQuantities.map((quantity) => quantity.outlier_note).filter(Boolean))];
  return (
    (report.assessment?.rule_set
      ? 'Values over the cycles that the rule set counts. '
      : 'Values of the third counted cycle of the largest amplitude. ') +
    (marked
      ? '\u25be: stands apart from the lot (modified z-score above 3.5).'
      : unjudged.length > 0 || lotQuantities.length === 0
        ? 'Outliers not judged' + (unjudged.length > 0 ? ': ' + unjudged.join('; ') : '') + '.'
        : 'No device stands apart from the lot.')
  );
}

function certificateColumns() {
  // What all devices share stands in the head.
  const known = (key) => new Set(devices.map((device) => device[key]).filter((value) => value !== null && value !== '')).size > 1;
  const given = (key) => devices.some((device) => device[key] !== null && device[key] !== '');
  return [
    { key: 'serial', column: { title: 'Serial' }, text: (d) => d.serial },
    { key: 'lot', column: { title: 'Lot' }, text: (d) => d.lot },
    { key: 'test_date', column: { title: 'Tested', tight: true }, text: (d) => d.test_date },
    { key: 'temperature_C', column: { title: 'Temp.', unit: '\u00b0C', number: true }, text: (d) => fixed(d.temperature_C, 1) },
  ].filter((fact) => given(fact.key) && (fact.key === 'serial' || known(fact.key)));
}

function certificateTable() {
  const facts = certificateColumns(),
    properties = certificateProperties(),
    common = commonlyOpen();
  const same = (digits) => (key) => new Set(devices.map((device) => fixed(reportedBlock(device)?.[key], digits))).size === 1;
  const sameAmplitude = same(1)('amplitude_mm'), // then it stands in the head
    sameFrequency = same(2)('frequency_Hz');
  const columns = [
    { title: 'Device', pinned: true },
    ...facts.map((fact) => fact.column),
    { title: 'Amplitude', unit: 'mm', number: true, screen: sameAmplitude },
    { title: 'Frequency', unit: 'Hz', number: true, screen: sameFrequency },
    ...properties.map(({ title, unit }) => ({ title, unit: unitText(unit), number: true })),
    { title: 'Verdict' },
    { title: 'File', screen: true },
  ];
  const rows = devices.map((device) => {
    const block = reportedBlock(device);
    const { verdict, failed, open } = deviceVerdict(device),
      outlying = apart(device),
      missing = open.filter((quantity) => !common.includes(quantity));
    const remark =
      device.status !== 'ok' ? 'refused: ' + device.message : [enumerate(failed), missing.length > 0 ? 'not assessed: ' + enumerate(missing) : '', outlying.length > 0 ? '\u25be ' + enumerate(outlying, 3) : ''].filter(Boolean).join('; ');
    return {
      cells: [
        element('b', { class: 'strong' }, device.name),
        ...facts.map((fact) => fact.text(device)),
        fixed(block?.amplitude_mm, 1),
        significant(block?.frequency_Hz, 2),
        ...properties.map(({ value }) => significant(value(device), 4)),
        element(
          'td',
          { class: 'reasoned' },
          verdict ? verdictBadge(verdict) : DASH,
          remark ? element('small', {}, remark) : null,
        ),
        element('span', { class: 'hash', title: device.sha256 }, device.sha256.slice(0, 8)),
      ],
    };
  });
  return table(columns, rows, 'The certificate: devices');
}

function certificateData() {
  const properties = certificateProperties();
  return {
    columns: [
      'device', 'serial', 'lot', 'tested', 'temperature [°C]', 'amplitude [mm]', 'frequency [Hz]',
      ...properties.map(({ title, unit }) => title + ' [' + (unit || '-') + ']'),
      'verdict', 'outside the limits', 'not assessed', 'stands apart by', 'file', 'sha256',
    ],
    rows: devices.map((device) => {
      const block = reportedBlock(device);
      const { verdict, failed, open } = deviceVerdict(device);
      return [
        device.name, device.serial, device.lot, device.test_date, device.temperature_C,
        block?.amplitude_mm ?? null, block?.frequency_Hz ?? null,
        ...properties.map(({ value }) => value(device) ?? null),
        verdict ?? '', device.status === 'ok' ? failed.join('; ') : device.message, open.join('; '), apart(device).join('; '), device.file, device.sha256,
      ];
    }),
  };
}

// Bounds by property modification factors; without them the smallest and largest value of the lot.
function boundRows() {
  const factors = report.assessment?.lot?.factors ?? [];
  const quantity = (name) => lotQuantities.find((q) => q.quantity === name);
  if (factors.length > 0)
    return factors.map((factor) => ({
      property: factor.property,
      unit: factor.unit,
      nominal: quantity(factor.property)?.nominal ?? null,
      mean: quantity(factor.property)?.mean ?? null,
      lower: factor.lower,
      upper: factor.upper,
      of: boundsOf(factor.source),
      from: [factor.source, factor.note, factor.no_lower_bound].filter(Boolean).join('; '),
    }));
  return lotQuantities
    .filter((q) => q.n > 1)
    .map((q) => ({
      property: q.quantity,
      unit: q.unit,
      nominal: q.nominal,
      mean: q.mean,
      lower: q.min,
      upper: q.max,
      of: 'the devices tested',
      from: 'smallest and largest',
    }));
}

const boundsOf = (source) =>
  source.startsWith('statistical, system') ? 'the isolation system' : source === 'contract band' ? 'by contract' : 'one device';

function boundsCaption() {
  if ((report.assessment?.lot?.factors?.length ?? 0) === 0)
    return 'No rule set gives modification factors: the smallest and the largest device that was tested. A lot has others beyond them.';
  const tested = report.assessment.lot.tested;
  return (
    'By property modification factors, on the design value, or on the mean where there is none. Those of one device hold 95' + THIN +
    '% of all devices with 95' + THIN + '% confidence, or what was observed; those of the system hold the mean of all devices of the lot.' +
    (tested < 5 ? ' From ' + count(tested, 'device') + ' alone: bounds by statistics are wide for that reason.' : '')
  );
}

function boundsTable() {
  const columns = [
    { title: 'Property', pinned: true },
    { title: 'Unit', tight: true },
    { title: 'Design value', number: true },
    { title: 'Mean of the lot', number: true },
    { title: 'Lower bound', number: true },
    { title: 'Upper bound', number: true },
    { title: 'Bounds', tight: true },
    { title: 'From' },
  ];
  const rows = boundRows().map((b, i, all) => {
    const first = i === 0 || all[i - 1].property !== b.property;
    return {
      className: first ? 'group' : null,
      cells: [
        element('b', { class: 'strong' }, first ? b.property : ''),
        first ? unitText(b.unit) : '',
        first ? significant(b.nominal, 4) : '',
        first ? significant(b.mean, 4) : '',
        significant(b.lower, 4),
        significant(b.upper, 4),
        b.of,
        element('td', { class: 'note text' }, b.from),
      ],
    };
  });
  return table(columns, rows, 'Lower and upper bound values');
}

function signatureBlock() {
  const signer = (role) =>
    element(
      'div',
      { class: 'signer' },
      element('b', {}, role),
      ...['Name', 'Place, date', 'Signature'].map((label) =>
        element('div', {}, element('span', { class: 'muted' }, label), blank(role + ': ' + label.toLowerCase())),
      ),
    );
  return element(
    'div',
    {},
    element(
      'p',
      { class: 'bound' },
      'Certificate ',
      element('span', { class: 'certificate-number' }),
      ' \u2013 ' + (report.title || 'isolation devices') + ', ' + count(devices.length, 'device'),
    ),
    element('div', { class: 'signers' }, signer('Tested by'), signer('Checked by'), signer('Accepted by')),
    element(
      'p',
      { class: 'fine' },
      'Values computed by isolaw ' + report.isolaw + ' from ' + count(devices.length, 'record') +
        '. They hold for the devices named here, as they were tested.',
    ),
  );
}

function recordsTable() {
  const columns = [{ title: 'Device', pinned: true }, { title: 'File' }, { title: 'SHA-256' }];
  const rows = devices.map((device) => ({
    cells: [
      element('b', { class: 'strong' }, device.name),
      device.file,
      element('td', { class: 'hash whole' }, device.sha256),
    ],
  }));
  return table(columns, rows, 'Records of the certificate');
}
