import { element, shortList } from '../dom.js';
import { sentence } from '../text.js';
import { bars, bounds, histogramData, spanOf } from './histogram.js';
import { axisTitle, first, quantityOf, spreadText, study, valueText } from './study.js';

const KEY = 'isolator_mm';

export const verdictSection = {
  id: 'verdict',
  title: 'Are the bound analyses enough?',
  short: 'Verdict',
  figures: [
    { id: 'verdict', title: '', build: band },
    {
      id: 'picture',
      title: 'Largest displacement of a bearing',
      caption: () => first.name + ': bars show the draws; shading marks the range between the bounds.',
      csv: () => histogramData([first], KEY),
      height: () => 320,
      draw: picture,
    },
    { id: 'warnings', title: '', wanted: () => study.warnings.length > 0, build: warnings },
  ],
};

function band() {
  const sufficient = study.bounds_are_enough;
  const tone = sufficient === null ? 'muted' : sufficient ? 'good' : 'poor';
  return element(
    'div',
    { class: 'band ' + tone },
    element('p', { class: 'headline' }, sentence(study.verdict)),
    element(
      'div',
      { class: 'numbers' },
      ...numbers().map(([value, what]) => element('div', {}, element('b', {}, value), element('span', {}, what))),
    ),
  );
}

function numbers() {
  const reached = (key, what) => {
    const of = first.quantities[key],
      quantity = quantityOf(key);
    const [low, high] = [of.lower, of.upper].sort((a, b) => a - b);
    return [valueText(of.p95, quantity), what + ', 95\u202f% of draws; bounds ' + valueText(low, { unit: '-' }) + ' to ' + valueText(high, quantity)];
  };
  const of = first.quantities[KEY];
  return [
    reached(KEY, 'displacement'),
    reached('shear_over_weight', 'base shear over weight'),
    [
      spreadText(of.lot_std_ln),
      'scatter from the lot; motions ' + spreadText(of.motion_std_ln) +
        (study.law_std_ln === null ? '' : ', laws ' + spreadText(study.law_std_ln)),
    ],
  ];
}

function picture(look) {
  const span = spanOf([first], KEY);
  const { shapes, annotations } = bounds(look, first, KEY, { labelled: true, span });
  return {
    traces: [bars(look, first, KEY)],
    layout: {
      shapes,
      annotations,
      margin: { l: 54, r: 12, t: 48, b: 44 },
      bargap: 0,
      xaxis: { title: axisTitle(quantityOf(KEY)), range: span },
      yaxis: { title: 'share of draws [%]', rangemode: 'tozero' },
    },
  };
}

function warnings() {
  return element(
    'div',
    { class: 'warnings' },
    element('h3', {}, study.warnings.length === 1 ? 'A warning' : 'Warnings'),
    ...shortList(study.warnings.map((text) => element('li', {}, sentence(text))), 4, 3),
  );
}
