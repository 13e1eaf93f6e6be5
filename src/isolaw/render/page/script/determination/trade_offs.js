import { chosen } from '../choice.js';
import { element, empty, sentences } from '../dom.js';
import { devices, examinedLaws, laws } from '../report.js';
import { count, isNumber, percentText, sentence } from '../text.js';

export const tradeOffsFigure = {
  id: 'trade-offs',
  width: 'wide',
  title: 'Parameters that change together, and intervals',
  depends: ['examined', 'device'],
  wanted: () => examinedLaws.length > 0 && chosen.device !== null,
  build: tradeOffs,
};

function intervalSentence({ level, samples, block, replicates }) {
  if (!isNumber(level)) return null;
  return (
    'The bars under the profile are intervals of ' + percentText(level) + ': from linearisation' +
    (replicates > 0 ? ', and from ' + count(replicates, 'fit') + ' of the bootstrap' : '') +
    ', in blocks of ' + count(block, 'sample') + ' of ' + samples +
    ' because neighbouring residuals are alike. They show how far another record of the same device could move the fit if ' +
    'the law\u2019s misfit were noise. They do not show whether the law is true. A parameter at its bound stays there.'
  );
}

function tradeOffs() {
  const law = laws[chosen.examined],
    fit = law.fitOn.get(chosen.device);
  const name = devices[chosen.device].name;
  if (!fit?.determination) return empty(law.name + ' on ' + name + ' was not examined.');
  return element(
    'div',
    { class: 'prose' },
    fit.trade_offs.length === 0
      ? element('p', {}, 'On ' + name + ', no parameters of ' + law.name + ' can change together without a visible change of the loops.')
      : element(
          'div',
          {},
          element('p', {}, 'The loops of ' + law.name + ' on ' + name + ':'),
          sentences(fit.trade_offs.map(sentence)),
        ),
    law.reduced_form
      ? element(
          'p',
          {},
          element('code', {}, law.reduced_form),
          ' gives the same loops without the redundant parameter.',
        )
      : null,
    element('p', {}, intervalSentence(fit.intervals)),
  );
}
