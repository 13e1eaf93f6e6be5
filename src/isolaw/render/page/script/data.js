import { shownData } from './units.js';

export const data = shownData;
