import { chosen } from '../choice.js';
import { laws } from '../report.js';

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
    open: row.open_range,
    ends: [row.open_below, row.open_above],
    linear: row.linear_interval,
    bootstrap: row.bootstrap_interval,
    values: row.profile.value,
    objectives: row.profile.objective,
  };
}

export const chosenExamination = () => examination(laws[chosen.examined], chosen.device, chosen.parameter);
