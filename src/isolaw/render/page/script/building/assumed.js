import { sentences, termList } from '../dom.js';
import { fixed, sentence, significant } from '../text.js';
import { BOUNDS, grouped, isDrawn, laws, study } from './study.js';
import { KN } from '../units.js';

const facts = () => [
  ['weight', grouped(Math.round(study.weight_kN)) + ' ' + KN],
  ['periods on a fixed base', study.fixed_base_periods_s.slice(0, 3).map((s) => fixed(s, 3)).join(', ') + ' s'],
  ['factors of the bounds', BOUNDS],
  ['draws', isDrawn ? grouped(study.draws) + ', seed ' + study.seed : 'none: no bearing is a draw of the lot'],
  ['runs without finite numbers', laws.map((law) => law.failed).reduce((a, b) => a + b, 0)],
  ['largest energy error', significant(Math.max(...laws.map((law) => law.energy_error)), 2)],
  ...study.motions.map(({ name, peak_g: g, samples, step_s: step, components }) => [
    name, fixed(g, 3) + ' g, ' + fixed((samples - 1) * step, 1) + ' s, ' + (components === 2 ? 'two components' : 'one component'),
  ]),
];

export const assumedSection = {
  id: 'assumed',
  title: 'What was assumed',
  short: 'Assumed',
  figures: [
    { id: 'assumed', title: 'The model', width: 'wide', build: () => sentences(study.assumed.map(sentence)) },
    {
      id: 'settings',
      title: 'Building and motions',
      width: 'narrow',
      csv: () => ({ columns: ['setting', 'value'], rows: facts() }),
      build: () => termList('facts-list', facts().map(([term, text]) => [term, String(text)])),
    },
  ],
};
