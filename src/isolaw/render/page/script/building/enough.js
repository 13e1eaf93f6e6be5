import { element } from '../dom.js';
import { sentence } from '../text.js';
import { bars, bounds, histogramData, spanOf } from './histogram.js';
import { axisTitle, first, isDrawn, quantityOf, study } from './study.js';

const KEY = 'isolator_mm';

export const enoughSection = {
  id: 'enough',
  title: 'Are the bound analyses enough?',
  short: 'Bounds',
  figures: [
    { id: 'enough', title: '', build: band },
    {
      id: 'picture',
      title: 'Largest displacement of a bearing',
      wanted: () => isDrawn,
      caption: () => first.name + ': bars show the draws; shading marks the range between the bounds.',
      csv: () => histogramData([first], KEY),
      height: () => 320,
      draw: picture,
    },
  ],
};

function band() {
  const sufficient = study.bounds_are_enough;
  const tone = sufficient === null ? 'muted' : sufficient ? 'good' : 'poor';
  return element('div', { class: 'band ' + tone }, element('p', { class: 'said' }, sentence(study.about_bounds)));
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
