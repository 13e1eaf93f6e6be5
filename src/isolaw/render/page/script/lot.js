import { assessedCycle } from './cycles.js';
import { report } from './report.js';
import { THIN, count, isNumber, mean, trimmed } from './text.js';
import { isConverted } from './units.js';
import { concerns, worstVerdict } from './verdicts.js';

// The quantities of the lot. The verdict of a quantity covers all limits on its mean; there is none if the rule set has
// no such limit.
export const lotQuantities = (report.assessment?.lot?.quantities ?? []).map(
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

// Returns the value of a device that the rule set assesses, as the mean over both sides of the loop. If the rule set
// assesses no value, returns that of the compression test, or of the cycle that stands for the device.
export function deviceValue(device, quantity) {
  const own = device.assessments.filter((a) => concerns(a, quantity) && isNumber(a.value));
  if (own.length > 0)
    return {
      value: mean(own.map((a) => a.value)),
      verdict: worstVerdict(own.map((a) => a.verdict)) ?? 'not assessed',
    };
  if (quantity === 'K_v') return isNumber(device.vertical?.K_v_kN_per_mm) ? { value: device.vertical.K_v_kN_per_mm, verdict: 'not assessed' } : null;
  const [key] = Object.entries(report.headings.cycles).find(([, [{ title }]]) => title === quantity) ?? [];
  const value = assessedCycle(device)?.[key];
  return isNumber(value) ? { value, verdict: 'not assessed' } : null;
}

// Returns the design values as text, with the digits that the user gave, or with five digits if the page converts them
// to other units. Returns an empty text if there are no design values.
export const designText = () =>
  (report.assessment?.design ?? []).map(({ name, value, unit }) => name + ' ' + (isConverted ? trimmed(value, 5) : value) + THIN + unit).join(', ');

export const sampleText = ({ value, limit, verdict, reason }) =>
  [count(value, 'device') + ' tested', limit, verdict].filter(Boolean).join(', ') + (reason ? ': ' + reason : '');
