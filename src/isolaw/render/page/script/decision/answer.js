import { choiceButtons, chosen } from '../choice.js';
import { element } from '../dom.js';
import { withBadges } from '../laws.js';
import { PURPOSES, TONES, answerOf, answering, numbersOf, purposeOf } from '../purposes.js';
import { sentence } from '../text.js';

export const answerFigure = { id: 'answer', title: '', depends: ['purpose', 'view'], controls: PURPOSES.length > 1 ? purposeControl : null, build: answer };

function answer() {
  const purpose = purposeOf(chosen.purpose);
  const { recommendation } = purpose;
  const numbers = numbersOf(purpose, chosen.view).map(([value, what]) =>
    element('div', {}, element('b', {}, value), element('span', {}, what)),
  );
  const sure = recommendation?.law
    ? element('span', { class: 'sure ' + TONES[recommendation.sure] }, recommendation.sure)
    : null;
  const reach = recommendation?.reach.map((one) => one.sentence).join(' ');
  const surer = recommendation?.surer.map((one) => one.sentence).join('; ');
  return element(
    'div',
    { class: 'answer' },
    element('p', { class: 'headline' }, ...withBadges(sentence(answerOf(purpose, chosen.view)), answering(purpose, chosen.view)), ...(sure ? [' ', sure] : [])),
    element('div', { class: 'numbers' }, ...numbers),
    recommendation ? element('p', { class: 'why' }, reasons(recommendation)) : null,
    reach ? element('p', { class: 'why' }, sentence(reach)) : null,
    surer ? element('p', { class: 'why' }, 'To be surer: ' + sentence(surer) + '.') : null,
    recommendation?.programs ? element('p', { class: 'why' }, recommendation.programs + '.') : null,
  );
}

function reasons({ law, reasons: all, weak }) {
  const told = all.filter(({ kind }) => !law || kind === 'why-better-refused').map((one) => one.sentence);
  const doubts = weak.map((one) => one.sentence).join('; ');
  return [...told, doubts && 'Low confidence: ' + doubts + '.'].filter(Boolean).map(sentence).join(' ');
}

function purposeControl() {
  return [
    element('span', { id: 'purpose-label' }, 'Show'),
    choiceButtons('purpose', PURPOSES.map(({ id, title }) => [id, title]), { 'aria-labelledby': 'purpose-label' }),
  ];
}
