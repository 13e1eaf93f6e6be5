import { chosen } from '../choice.js';
import { laws } from '../report.js';

// What is known of a parameter on a device; null where it was not examined.
export function examination(law, device, place) {
  const fit = law?.fitOn.get(device);
  const row = fit?.determination?.[place];
  if (!row) return null;
  return {
    law,
    fit,
    parameter: law.parameters[place],
    verdict: row.identifiability,
    optimum: row.optimum,
    open: [row.open_lower, row.open_upper],
    ends: [row.open_below, row.open_above],
    linear: [row.linear_lower, row.linear_upper],
    bootstrap: [row.bootstrap_lower, row.bootstrap_upper],
    values: row.profile_value,
    objectives: row.profile_objective,
  };
}

export const chosenExamination = () => examination(laws[chosen.examined], chosen.device, chosen.parameter);
