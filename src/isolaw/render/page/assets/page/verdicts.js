// Verdicts

const isVerified = () => Boolean(report.assessment?.rule_set?.verified_by);
const worstVerdict = (verdicts) =>
  ['fail', 'pass', 'information', 'not assessed'].find((verdict) => verdicts.includes(verdict)) ?? null;
// With one verdict of the limits on the mean, none where the set has no such limit.
const lotQuantities = (report.assessment?.lot?.quantities ?? []).map(
  ({ mean_limits: limits, lambda_test: test, without, ...quantity }) => ({
    ...quantity,
    without: without.join('; '),
    lambda_test_min: test?.min ?? null,
    lambda_test_min_cycle: test?.min_cycle ?? null,
    lambda_test_max: test?.max ?? null,
    lambda_test_max_cycle: test?.max_cycle ?? null,
    limit_mean: limits.map(({ limit }) => limit).join('; '),
    verdict: worstVerdict(limits.map(({ verdict }) => verdict)),
    reason: [...new Set(limits.map(({ reason }) => reason).filter(Boolean))].join('; '),
  }),
);

// Word and shape say the same, so that neither colour nor sight of the shape is needed.
const VERDICTS = {
  pass: {
    tone: 'good',
    filled: true,
    path: ROUND,
    mark: 'M3.4 6.2 L5.3 8 L8.6 4',
    symbol: 'circle',
  },
  fail: {
    tone: 'poor',
    filled: true,
    path: 'M1 1 H11 V11 H1 Z',
    mark: 'M3.6 3.6 L8.4 8.4 M8.4 3.6 L3.6 8.4',
    symbol: 'square',
  },
  information: {
    tone: 'muted',
    filled: false,
    path: 'M6 .9 L11.1 6 L6 11.1 L.9 6 Z',
    mark: 'M6 5.4 V8.2 M6 3.4 V4.2',
    symbol: 'diamond-open',
  },
  'not assessed': { tone: 'muted', filled: false, path: 'M1.5 6 H10.5', mark: '', symbol: 'line-ew-open' },
};

function verdictBadge(verdict) {
  const known = VERDICTS[verdict] ?? VERDICTS['not assessed'];
  const colour = 'var(--' + known.tone + ')';
  const shapes = [[known.path, known.filled ? colour : 'none', colour]];
  if (known.mark) shapes.push([known.mark, 'none', known.filled ? 'var(--paper)' : colour]);
  return element('span', { class: 'verdict ' + known.tone }, icon(...shapes), verdict);
}

const withUnit = (value, unit, digits = 4) =>
  significant(value, digits) + (isNumber(value) && unit && unit !== '-' ? THIN + unit : '');
const limitText = (limit) => (limit ? sentence(limit).replace(/-(?=\d)/g, MINUS) : DASH);
const deviation = (percent, decimals = 1) => (isNumber(percent) ? signed(percent, decimals) + THIN + '%' : DASH);

function assessmentTable() {
  const device = devices[chosen.tested];
  if (device.assessments.length === 0)
    return element(
      'p',
      { class: 'empty' },
      device.name + ' was not assessed' + (device.properties_refusal ? ': ' + device.properties_refusal : '.'),
    );
  const columns = [
    { title: 'Quantity', pinned: true },
    { title: 'Verdict' },
    { title: 'Block', number: true, screen: true },
    { title: 'Value', number: true },
    { title: 'Design value', number: true },
    { title: 'Deviation', number: true },
    { title: 'Limits' },
    { title: 'Formula', screen: true },
    { title: 'Clause' },
  ];
  const rows = device.assessments.map((a) => ({
    cells: [
      element('b', { class: 'strong' }, a.quantity),
      element('td', { class: 'reasoned' }, verdictBadge(a.verdict), a.reason ? element('small', {}, a.reason) : null),
      isNumber(a.block) && a.block > 0 ? String(a.block) : DASH,
      withUnit(a.value, a.unit),
      withUnit(a.nominal, a.unit),
      deviation(a.deviation_percent),
      element('td', { class: 'tight' }, limitText(a.limit)),
      a.formula,
      element('td', { class: 'note clause' }, a.clause),
    ],
  }));
  return table(columns, rows, 'Assessment of the chosen device');
}

const ASSESSMENT_COLUMNS = [
  'device',
  'quantity',
  'block',
  'clause',
  'formula',
  'value',
  'unit',
  'design value',
  'deviation [%]',
  'limits',
  'verdict',
  'reason',
];

function assessmentData(among) {
  return {
    columns: ASSESSMENT_COLUMNS,
    rows: among.flatMap((device) =>
      device.assessments.map((a) => [
        device.name,
        a.quantity,
        a.block,
        a.clause,
        a.formula,
        a.value,
        a.unit,
        a.nominal,
        a.deviation_percent,
        a.limit,
        a.verdict,
        a.reason,
      ]),
    ),
  };
}

function verdictTable() {
  const key = (a) => a.quantity + '\n' + (a.limit || '');
  const quantities = [...new Map(devices.flatMap((d) => d.assessments).map((a) => [key(a), a])).entries()];
  const columns = [
    { title: 'Device', pinned: true },
    ...quantities.map(([, a]) => ({
      title: a.quantity,
      unit: a.limit ? limitText(a.limit) : 'no limit',
      full: a.clause || null,
    })),
  ];
  const failing = (device) => device.assessments.some((a) => a.verdict === 'fail');
  const rows = [...devices.filter(failing), ...devices.filter((device) => !failing(device))].map((device) => {
    const own = new Map(device.assessments.map((a) => [key(a), a]));
    const name = element('b', { class: 'strong' }, device.name);
    if (own.size === 0)
      return {
        cells: [
          name,
          element(
            'td',
            { class: 'note text', colspan: quantities.length },
            device.status !== 'ok' ? 'refused: ' + device.message : noCycles(device),
          ),
        ],
      };
    return {
      cells: [
        name,
        ...quantities.map(([id]) => {
          const a = own.get(id);
          if (!a) return element('td', { class: 'note' }, DASH);
          const number = isNumber(a.deviation_percent)
            ? deviation(a.deviation_percent)
            : isNumber(a.value)
              ? withUnit(a.value, a.unit, 3)
              : null;
          return element(
            'td',
            { class: 'judged', title: a.reason || null },
            verdictBadge(a.verdict),
            number === null ? null : element('small', {}, number),
          );
        }),
      ],
    };
  });
  return table(columns, rows, 'Verdicts, device by device');
}
