// isolaw's recommendation: which law to use, if it recommends one, and how all laws rank. A report of `isolaw inspect`
// has no recommendation.

import { laws, lawsByObjective, report } from './report.js';

export const recommendation = report.findings.recommendation;

const byId = new Map(laws.map((law) => [law.id, law]));
export const standings = (recommendation?.standings ?? []).map((standing) => ({ ...standing, law: byId.get(standing.law) }));

// The law that the page shows when it opens.
export const firstLaw = byId.get(recommendation?.law) ?? lawsByObjective[0] ?? laws[0] ?? null;
