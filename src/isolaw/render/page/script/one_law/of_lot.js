import { chosen } from '../choice.js';
import { laws } from '../report.js';
import { isNumber } from '../text.js';

export const ofLot = () => laws[chosen.lotLaw];
export const fitsInLot = (law) => law.devices.filter((fit) => isNumber(fit.lot_objective));
