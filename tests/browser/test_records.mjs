// Replaces the records in the data of a report by made-up ones with blocks, cycles, verdicts and a lot. The page must
// then show every kind of content that it can show. The formulas are simple and only good for clean records. This file
// itself checks nothing.

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

export function coded(values) {
  const low = Math.min(...values),
    step = (Math.max(...values) - low) / 20000 || 1;
  let before = 0;
  const d = values.map((value) => {
    const level = Math.round((value - low) / step);
    const difference = level - before;
    before = level;
    return difference;
  });
  return { o: low, s: step, d };
}

// Returns a record with one cycle of 20 mm, a block of 50 mm, a block of 100 mm at half the frequency, and half a cycle
// at the end. Its stiffness falls with the distance travelled, as that of rubber does in its first cycles (scragging).
export function made_up_record(scatter, perCycle = 80) {
  const disp = [],
    time = [];
  let t = 0;
  for (const [amplitude, frequency, cycles] of [
    [20, 0.5, 1],
    [50, 0.5, 3],
    [100, 0.25, 6],
    [20, 0.25, 0.5],
  ])
    for (let i = 0; i < cycles * perCycle; ++i, t += 1 / frequency / perCycle) {
      time.push(t);
      disp.push(amplitude * Math.sin((2 * Math.PI * i) / perCycle));
    }
  let hysteresis = 0,
    travel = 0;
  const force = disp.map((x, i) => {
    const dx = i > 0 ? x - disp[i - 1] : 0;
    travel += Math.abs(dx);
    hysteresis += dx / 9 - (Math.abs(dx) / 9) * hysteresis;
    const fading = 1 + 0.22 * Math.exp(-travel / 400);
    return (1 + scatter) * fading * (0.55 * x + 1e-6 * x ** 3) + (1 + scatter / 2) * (18 + 6 * fading) * hysteresis;
  });
  return { disp, force, time };
}

// Returns the places where the displacement crosses zero in the direction of its first motion, as fractional sample
// indices.
function cuts(disp) {
  const largest = Math.max(...disp.map(Math.abs)),
    band = 0.04 * largest;
  const direction = Math.sign(disp.find((x) => Math.abs(x) > band) ?? 1);
  const found = [0];
  let armed = false;
  for (let i = 1; i < disp.length; ++i) {
    if (direction * disp[i] < -band) armed = true;
    if (!armed || direction * disp[i - 1] > 0 || direction * disp[i] <= 0) continue;
    found.push(i - 1 + disp[i - 1] / (disp[i - 1] - disp[i]));
    armed = false;
  }
  found.push(disp.length - 1);
  return found;
}

function properties({ disp, force, time, load }, first, last, thickness, area) {
  const at = (values, index) => {
    const i = Math.min(Math.floor(index), values.length - 2);
    return values[i] + (index - i) * (values[i + 1] - values[i]);
  };
  const take = (values) => [
    at(values, first),
    ...values.slice(Math.floor(first) + 1, Math.ceil(last)),
    at(values, last),
  ];
  const x = take(disp),
    F = take(force);
  const high = x.indexOf(Math.max(...x)),
    low = x.indexOf(Math.min(...x));
  const D = (x[high] - x[low]) / 2,
    K = (F[high] - F[low]) / (2 * D);
  let twice = (F[F.length - 1] + F[0]) * (x[0] - x[x.length - 1]);
  for (let i = 1; i < x.length; ++i) twice += (F[i] + F[i - 1]) * (x[i] - x[i - 1]);
  const energy = Math.abs(twice) / 2;
  const atZero = [];
  for (let i = 1; i < x.length; ++i) if (x[i - 1] * x[i] <= 0 && x[i] !== x[i - 1]) atZero.push(F[i]);
  const Q = atZero.length > 1 ? (Math.max(...atZero) - Math.min(...atZero)) / 2 : null;
  const K_d = Q === null ? null : K - Q / D;
  const N = load ? take(load) : null;
  return {
    first,
    last,
    amplitude_mm: D,
    d_plus_mm: x[high],
    d_minus_mm: x[low],
    F_plus_kN: F[high],
    F_minus_kN: F[low],
    K_eff_kN_per_mm: K,
    K_plus_kN_per_mm: F[high] / x[high],
    K_minus_kN_per_mm: F[low] / x[low],
    energy_kN_mm: energy,
    damping_percent: (100 * energy) / (2 * Math.PI * K * D * D),
    Q_d_kN: Q,
    K_d_kN_per_mm: K_d,
    D_y_mm: Q === null ? null : D - energy / (4 * Q),
    K_1_kN_per_mm: null,
    F_y_kN: null,
    residual_plus_mm: Q === null ? null : 0.3 * D,
    residual_minus_mm: Q === null ? null : -0.3 * D,
    work_kN_mm: energy,
    K_eff_in_block: 1,
    K_eff_in_test: 1,
    period_s: time ? at(time, last) - at(time, first) : null,
    v_max_mm_s: time ? (2 * Math.PI * D) / (at(time, last) - at(time, first)) : null,
    N_mean_kN: N ? mean(N) : null,
    N_min_kN: N ? Math.min(...N) : null,
    N_max_kN: N ? Math.max(...N) : null,
    closure_mm: x[x.length - 1] - x[0],
    closure_kN: F[F.length - 1] - F[0],
    strain_percent: thickness ? (100 * D) / thickness : null,
    G_MPa: thickness && area ? (1000 * K * thickness) / area : null,
  };
}

function stability(values) {
  const third = values[2];
  const among = (from) => (values.length > from ? values.slice(from, 10).map((value) => value / third) : []);
  const extreme = (which, from) => (third && among(from).length > 1 ? which(...among(from)) : null);
  const least = (from) => (third && among(from).length > 1 ? Math.min(...among(from)) / Math.max(...among(from)) : null);
  return {
    ratio_to_third: third ? values.map((value) => value / third) : [],
    min_2_10: extreme(Math.min, 1),
    max_2_10: extreme(Math.max, 1),
    min_1_10: extreme(Math.min, 0),
    max_1_10: extreme(Math.max, 0),
    least_to_largest_2_10: least(1),
    least_to_largest_1_10: least(0),
    first_to_third: third ? values[0] / third : null,
    first_to_mean_1_3: third ? values[0] / mean(values.slice(0, 3)) : null,
  };
}

function blocks_of(test, device) {
  const ends = cuts(test.disp);
  const cycles = ends
    .slice(1)
    .map((last, i) => properties(test, ends[i], last, device.rubber_thickness_mm, device.rubber_area_mm2));
  const blocks = [];
  cycles.forEach((cycle, i) => {
    const partial = i === 0 && cycle.amplitude_mm < 0.9 * cycles[1]?.amplitude_mm ? 'start' : '';
    const ending = i === cycles.length - 1 && cycle.amplitude_mm < 0.9 * cycles[i - 1]?.amplitude_mm ? 'end' : '';
    const reason = partial
      ? 'start-up: smaller than the cycles that follow'
      : ending
        ? 'the record ends before the cycle is complete'
        : '';
    const block = blocks[blocks.length - 1];
    const starts = !block || (!reason && block.counts && Math.abs(cycle.amplitude_mm / block.amplitude_mm - 1) > 0.05);
    if (starts) blocks.push({ cycles: [], counts: false, amplitude_mm: cycle.amplitude_mm });
    const own = blocks[blocks.length - 1];
    if (!reason && !own.counts) Object.assign(own, { counts: true, amplitude_mm: cycle.amplitude_mm });
    const number = reason ? 0 : own.cycles.filter((c) => c.counts).length + 1;
    const whole = !reason.startsWith('the record ends');
    own.cycles.push({ number, counts: reason === '', partial: !whole, half: false, reason, ...cycle });
  });
  return blocks.map(({ cycles: own, amplitude_mm }, i) => {
    const good = own.filter((cycle) => cycle.counts);
    const period = good[0]?.period_s ?? null;
    const of = (key) => stability(good.map((cycle) => cycle[key]));
    return {
      number: i + 1,
      amplitude_mm,
      frequency_Hz: period ? 1 / period : null,
      waveform: period ? 'sine' : '',
      v_max_mm_s: good[0]?.v_max_mm_s ?? null,
      cycles: own,
      stability: { K_eff: of('K_eff_kN_per_mm'), energy: of('energy_kN_mm'), damping: of('damping_percent') },
    };
  });
}

const QUANTITIES = [
  { quantity: 'K_eff', key: 'K_eff_kN_per_mm', unit: 'kN/mm' },
  { quantity: 'damping', key: 'damping_percent', unit: '%' },
  { quantity: 'energy', key: 'energy_kN_mm', unit: 'kN mm' },
  { quantity: 'Q_d', key: 'Q_d_kN', unit: 'kN' },
  { quantity: 'K_d', key: 'K_d_kN_per_mm', unit: 'kN/mm' },
];
const LIMIT = 'a fifth to either side'; // the page must draw the limit of 20 % and show these words
const LIMITS = { lower_percent: -20, upper_percent: 20 };
const NO_LIMITS = { lower_percent: null, upper_percent: null };
const TOLERANCE_K = 2.752;
const NO_LOWER = 'too few devices for a lower bound: 114 % of the mean below it is no positive value';

function assessments_of(cycle, block, nominal, verified) {
  const judged = (property, side, value, key, unit) => {
    const quantity = side === 'both' ? property : `${property}, ${side} side`;
    const percent = 100 * (value / nominal[key] - 1);
    const verdict = !verified ? 'information' : Math.abs(percent) <= 20 ? 'pass' : 'fail';
    return {
      quantity,
      property,
      subject: 'device',
      side,
      block,
      clause: 'Table <b>1</b>, ' + quantity,
      formula: 'cycle 3',
      value,
      unit,
      nominal: nominal[key],
      deviation_percent: percent,
      deviation: percent.toFixed(1) + ' %',
      limit: LIMIT,
      ...LIMITS,
      verdict,
      reason: verified ? '' : 'the limits of this set are not verified',
    };
  };
  const plain = (quantity, unit, value, reason, verdict = 'not assessed') => ({
    quantity,
    property: quantity,
    subject: 'device',
    side: 'both',
    block,
    clause: '',
    formula: '',
    value,
    unit,
    nominal: null,
    deviation_percent: null,
    deviation: '',
    limit: '',
    ...NO_LIMITS,
    verdict,
    reason,
  });
  return [
    judged('K_eff', 'positive', cycle.K_plus_kN_per_mm, 'K_eff_kN_per_mm', 'kN/mm'),
    judged('K_eff', 'negative', cycle.K_minus_kN_per_mm, 'K_eff_kN_per_mm', 'kN/mm'),
    judged('damping', 'both', cycle.damping_percent, 'damping_percent', '%'),
    plain('Q_d', 'kN', cycle.Q_d_kN, 'no design value was given: --design Q_d=...', 'information'),
    plain('K_v', 'kN/mm', null, 'vertical stiffness needs a vertical displacement channel'),
  ];
}

function lot_of(devices, nominal, verified, assessed, hostile) {
  const reporting = devices.filter((device) => device.reported);
  const value = (device, key) =>
    device.blocks[device.reported.block - 1].cycles.find((cycle) => cycle.number === device.reported.number)[key];
  const outliers = [];
  const quantities = QUANTITIES.map(({ quantity, key, unit }) => {
    const measured = reporting.filter((device) => Number.isFinite(value(device, key)));
    const values = measured.map((device) => value(device, key));
    const middle = mean(values),
      sd =
        values.length > 1
          ? Math.sqrt(mean(values.map((v) => (v - middle) ** 2)) * (values.length / (values.length - 1)))
          : null;
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const given = nominal[key] ?? null;
    const median = [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
    values.forEach((v, i) => {
      if (values.length >= 5 && Math.abs(v / median - 1) > 0.2)
        outliers.push({
          device: measured[i].name,
          quantity,
          value: v,
          unit,
          why: `${(100 * (v / median - 1)).toFixed(0)} % from the median ${median.toPrecision(4)}: modified z above 3.5`,
        });
    });
    const off = (v) => (given === null ? null : 100 * (v / given - 1));
    const worst = given === null ? null : Math.abs(off(low)) > Math.abs(off(high)) ? off(low) : off(high);
    const open = given === null ? `no design value: give ${quantity}=... among the design values` : '';
    const none = sd !== null && middle - TOLERANCE_K * sd <= 0;
    return {
      quantity,
      unit,
      n: values.length,
      without: [],
      mean: middle,
      sd,
      cov_percent: sd === null ? null : (100 * sd) / middle,
      min: low,
      min_device: measured[values.indexOf(low)].name,
      max: high,
      max_device: measured[values.indexOf(high)].name,
      nominal: given,
      deviation_of_mean_percent: off(middle),
      worst_deviation_percent: worst,
      worst_device: worst === null ? '' : measured[values.indexOf(worst === off(low) ? low : high)].name,
      fractile_5: sd === null ? null : middle - 1.645 * sd,
      fractile_95: sd === null ? null : middle + 1.645 * sd,
      tolerance_k: sd === null ? null : TOLERANCE_K,
      tolerance_lower: sd === null || none ? null : middle - TOLERANCE_K * sd,
      tolerance_upper: sd === null ? null : middle + TOLERANCE_K * sd,
      no_lower_bound: none ? NO_LOWER : '',
      lambda_test: {
        min: 0.91,
        min_cycle: 6,
        min_device: measured[0].name,
        max: 1.12,
        max_cycle: 1,
        max_device: measured[0].name,
      },
      limit_individual: given === null ? '' : LIMIT,
      ...(given === null ? NO_LIMITS : LIMITS),
      // This rule set limits only two means, those of stiffness and damping.
      mean_limits: !assessed || !['K_eff', 'damping'].includes(quantity)
        ? []
        : [
            {
              quantity: `${quantity}, mean of ${values.length} devices`,
              property: quantity,
              subject: 'lot',
              side: 'both',
              block: null,
              clause: 'Table <b>1</b>, mean',
              formula: 'mean over the devices',
              value: middle,
              unit,
              nominal: given,
              deviation_percent: off(middle),
              deviation: given === null ? '' : off(middle).toFixed(1) + ' %',
              limit: '-10 % to +10 %',
              lower_percent: -10,
              upper_percent: 10,
              verdict:
                given === null
                  ? 'not assessed'
                  : !verified
                    ? 'information'
                    : Math.abs(off(middle)) <= 10
                      ? 'pass'
                      : 'fail',
              reason: open,
            },
          ],
      outlier_note: values.length < 4 ? `too few devices to name outliers: ${values.length}, at least 4 needed` : '',
    };
  });
  const factors = quantities
    .filter(({ quantity }) => quantity !== 'damping')
    .flatMap(({ quantity, unit, mean: middle, sd }) =>
      [
        ...(assessed ? [['contract band', 'contract', 0.85, 1.15, 'as agreed in the rule set']] : []),
        ...(sd === null
          ? []
          : [
              ['observed', 'device', 0.94, 1.06, 'lowest and highest device tested'],
              ['statistical, each device', 'device', -0.14, 1 + (TOLERANCE_K * sd) / middle, 'holds 95 % of the devices'],
              ['statistical, system', 'system', 0.974, 1.026, `mean of the devices ${hostile}`],
              ['statistical, system predicted', 'system', 0.95, 1.05, 'mean of the devices predicted'],
            ]),
      ].map(([source, spread, spec_min, spec_max, note]) => {
        const lower = spec_min > 0 ? spec_min : null; // a negative factor stands for no bound
        return {
          property: quantity,
          source,
          spread,
          spec_min: lower,
          spec_max,
          lambda_min: lower === null ? null : 0.91 * lower,
          lambda_max: 1.12 * spec_max,
          lower: lower === null ? null : middle * 0.91 * lower,
          upper: middle * 1.12 * spec_max,
          unit,
          note,
          no_lower_bound: lower === null ? NO_LOWER : '',
        };
      }),
    );
  const required = Math.max(4, Math.ceil(0.4 * devices.length));
  return {
    size: 2 * devices.length,
    tested: reporting.length,
    required: assessed ? required : null,
    sample: {
      quantity: 'sample size',
      property: null,
      subject: 'sample',
      side: 'both',
      block: null,
      clause: 'sample',
      formula: 'devices tested',
      value: reporting.length,
      unit: 'devices',
      nominal: null,
      deviation_percent: null,
      deviation: '',
      limit: assessed ? `${required} or more of ${2 * devices.length}` : '',
      ...NO_LIMITS,
      verdict: !assessed ? 'not assessed' : !verified ? 'information' : reporting.length >= required ? 'pass' : 'fail',
      reason: assessed ? '' : 'no rule set was asked for',
    },
    quantities,
    outliers,
    factors,
    mean_analysis: {
      permitted: true,
      sentence: "Largest deviation of a device from the lot's mean: K_eff 12.0 %.",
    },
    note: reporting.length === 1 ? 'one device is no lot: no spread over devices' : '',
  };
}

// Returns the verdict on the whole lot.
function result_of({ devices, assessment: { lot } }, verified, assessed) {
  const none = { word: null, as_corrected: false, failing: [], not_assessed: [], requirements: [], mark_is_red: false };
  if (!assessed) return { ...none, sentence: 'no verdict: no rule set', mark: null };
  if (!verified) return { ...none, sentence: 'no verdict, the limits of this set are not verified', mark: 'LIMITS NOT VERIFIED' };
  const failing = devices.filter(({ verdict }) => verdict === 'fail').map(({ name }) => ({ device: name, remark: 'K_eff +30.0 %' }));
  const of_lot = [lot.sample, ...lot.quantities.flatMap((quantity) => quantity.mean_limits)].filter(({ verdict }) => verdict === 'fail');
  failing.push(...of_lot.map(({ quantity }) => ({ device: null, remark: quantity })));
  const word = failing.length > 0 ? 'FAIL' : 'INCOMPLETE';
  return {
    word,
    as_corrected: false,
    sentence: failing.map(({ device, remark }) => (device ?? 'the lot') + ' ' + remark).join(', ') + '; not assessed: K_v',
    failing,
    not_assessed: devices.filter((device) => device.assessments.length === 0).map(({ name }) => ({ device: name, remark: 'refused' })),
    requirements: [
      { name: 'K_eff', verdict: failing.length > 0 ? 'fail' : 'pass' },
      { name: 'damping', verdict: 'pass' },
      { name: 'K_v', verdict: 'not assessed' },
    ],
    mark: word,
    mark_is_red: true,
  };
}

// Replaces the records in the data of a report. `tests` holds records {disp, force, time?, load?} by the name of the
// device. Every other device that was not refused gets a made-up record. A record with `cyclic: false` has no cycles.
export function extend(report, { tests = {}, verified = true, assessed = true, laws = true, scored = true } = {}) {
  const hostile = '<img src=x onerror=alert(2)>';
  report.devices.forEach((device, d) => {
    const read = device.status === 'ok';
    const test = !read ? null : (tests[device.name] ?? made_up_record(0.26 * (((d * 0.754878) % 1) ** 3 - 0.15)));
    delete device.cycles;
    Object.assign(device, {
      blocks: !test || test.cyclic === false ? [] : blocks_of(test, device),
      raw: null,
      scored: null,
      notes: [`128 samples per cycle ${hostile}`],
      corrections: d === 0 ? ['force moved back by 4 ms against displacement (--skew-ms 4)'] : [],
      assessments: [],
      doubts: [],
      verdict_brief: '',
      verdict_text: '',
      reported: null,
      counting_block: null,
      counting_block_choice: '',
      properties_refusal: read ? '' : device.message,
    });
    if (!test) return;
    const stride = Math.max(1, Math.ceil(test.disp.length / 2400));
    const kept = [...test.disp.keys()].filter((i) => i % stride === 0);
    if (kept[kept.length - 1] !== test.disp.length - 1) kept.push(test.disp.length - 1);
    const take = (values) => coded(kept.map((i) => values[i]));
    device.raw = { samples: test.disp.length, stride, disp_mm: take(test.disp), force_kN: take(test.force) };
    if (test.cyclic === false) device.properties_refusal = 'not cyclic: 12 % of the travel is in cycles that repeat';
    const largest = [...device.blocks].sort((a, b) => b.amplitude_mm - a.amplitude_mm)[0];
    const number = Math.min(3, largest?.cycles.filter((cycle) => cycle.counts).length ?? 0);
    if (number > 0) {
      device.reported = { block: largest.number, number };
      device.counting_block = largest.number;
    }
    const t = device.record.time_s;
    if (t) {
      // The page has the raw record without times and gives its cycles by the numbers of samples. The record that the
      // laws were fitted to has times, which are stretched here to the number of samples of the raw record.
      const steps = t.d.reduce((sum, difference) => sum + difference, 0);
      device.record.time_s = { o: 0, s: (test.disp.length - 1) / steps, d: t.d };
    }
    if (scored && laws && d === 1 && t) {
      const { o, s, d: steps } = device.record.time_s;
      const length = s * steps.reduce((sum, difference) => sum + difference, 0);
      device.scored = [{ from: o + 0.5 * length, to: o + 0.9 * length }];
    }
  });
  const first = report.devices.find((device) => device.reported);
  const value = (key) =>
    first?.blocks[first.reported.block - 1].cycles.find((c) => c.number === first.reported.number)[key];
  const nominal =
    first && assessed
      ? { K_eff_kN_per_mm: 1.05 * value('K_eff_kN_per_mm'), damping_percent: 0.95 * value('damping_percent') }
      : {};
  if (assessed && first)
    for (const device of report.devices) {
      if (!device.reported) continue;
      const block = device.blocks[device.reported.block - 1];
      const cycle = block.cycles.find((c) => c.number === device.reported.number);
      device.assessments = assessments_of(cycle, block.number, nominal, verified);
    }
  for (const device of report.devices)
  {
    device.verdict =
      ['fail', 'pass', 'information', 'not assessed'].find((verdict) => device.assessments.some((a) => a.verdict === verdict)) ??
      (assessed && device.properties_refusal ? 'not assessed' : null);
    device.verdict_brief = device.verdict_text = device.verdict ?? '';
  }
  report.assessment = {
    rule_set: !assessed
      ? null
      : {
          id: 'test',
          title: `A made-up rule set ${hostile}`,
          edition: '2024',
          verified_by: verified ? 'the tests' : '',
          source: 'tests',
          origin: 'rules.toml',
        },
    design:
      first && assessed
        ? [
            { name: 'K_eff', value: nominal.K_eff_kN_per_mm, unit: 'kN/mm' },
            { name: 'damping', value: nominal.damping_percent, unit: '%' },
          ]
        : [],
    lot: lot_of(report.devices, nominal, verified, assessed, hostile),
  };
  report.result = result_of(report, verified, assessed);
  if (!laws) {
    report.laws = [];
    report.published = null;
    report.by_objective = [];
    // The page of an inspection has only warnings about devices and records.
    const warnings = report.findings.warnings.filter(({ topic }) => ['refused', 'copies', 'record'].includes(topic));
    report.findings = { recommendation: null, headline: '', beta_note: '', verdicts: [], converged: [], warnings };
  }
  return report;
}

// Returns the HTML of a page after `change` has changed its data.
export function with_data(page, change) {
  const [, before, text, after] = page.match(
    /^(.*<script type="application\/json" id="isolaw-data">)(.*?)(<\/script>.*)$/s,
  );
  return before + JSON.stringify(change(JSON.parse(text))).replace(/</g, '\\u003c') + after;
}
