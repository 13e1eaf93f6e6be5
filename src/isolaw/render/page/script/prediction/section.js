import { element, strong } from '../dom.js';
import { devices, predictedByFit, predictedLaws, report, resultColumns } from '../report.js';
import { tableOf } from '../tables.js';
import { DASH, THIN, enumerate, fixed, mean, short, significant } from '../text.js';
import { predictedLoopsFigure } from './loops.js';
import { MM } from '../units.js';

const predictionsFigure = {
  id: 'predictions',
  title: 'Objective per block',
  wanted: () => predictedLaws.length > 0,
  caption: predictionCaption,
  csv: predictionData,
  build: predictionTable,
};

export const predictionSection = {
  id: 'prediction',
  title: 'Prediction across the record',
  short: 'Prediction', // title in the table of contents
  laws: true,
  figures: [predictionsFigure, predictedLoopsFigure],
};

function scoredBlocks() {
  const found = new Map();
  for (const law of predictedLaws)
    for (const fit of law.devices)
      for (const { block, fitted } of fit.blocks) {
        const shown = devices[fit.device].blocks.find((one) => one.number === block);
        const amplitudes = found.get(block + ' ' + fitted)?.amplitudes ?? [];
        if (shown) amplitudes.push(shown.amplitude_mm);
        found.set(block + ' ' + fitted, { block, fitted, amplitudes });
      }
  return [...found.values()].sort((a, b) => a.block - b.block || Number(b.fitted) - Number(a.fitted));
}

const scoresOf = (law, { block, fitted }) =>
  law.devices.filter((fit) => fit.counts).flatMap((fit) =>
    fit.blocks
      .filter((score) => score.block === block && score.fitted === fitted)
      .map((score) => ({ device: devices[fit.device].name, objective: score.objective })),
  );

const GRADE_TONES = { good: 'good', fair: '', poor: 'care', unusable: 'badge' };

const missText = (objective) => (objective < 10 ? fixed(objective, 4) : significant(objective, 3));

function predictionCaption() {
  const { good_prediction: good, fair_prediction: fair, poor_prediction: poor, ...limits } = report.thresholds;
  const [best] = predictedByFit,
    closest = [...predictedLaws].sort((a, b) => a.fitted_objective - b.fitted_objective)[0];
  const unusable = predictedLaws.filter((law) => law.prediction_grade === 'unusable').map((law) => law.name);
  return (
    'Every law runs through the whole record but was fitted only to the blocks marked \u201cfitted\u201d. ' +
    (best === closest
      ? best.name + ' is closest both to the blocks it was fitted to and to the others.'
      : closest.name + ' is closest to the blocks it was fitted to, ' + best.name + ' to the others.') +
    (unusable.length > 0
      ? ' Unusable at other amplitudes or frequencies than those of the fit: ' +
        enumerate(unusable) + '.'
      : ' No prediction is unusable.') +
    ' Good: OF up to ' + good + ' on the blocks predicted; fair: up to ' + fair + '; poor: up to ' + poor +
    '; unusable: above that, or a block with an OF above ' + limits.collapsed_objective +
    ', or a mean of ' + limits.collapsed_least + ' or more that exceeds ' + limits.collapsed_ratio +
    ' times the mean of the fitted blocks.'
  );
}

function predictionTable() {
  const blocks = scoredBlocks();
  const score = (law, block) => {
    const scores = scoresOf(law, block);
    if (scores.length === 0) return element('td', { class: 'number note' }, DASH);
    const worst = scores.reduce((a, b) => (b.objective > a.objective ? b : a));
    return element(
      'td',
      { class: 'number' },
      missText(mean(scores.map(({ objective }) => objective))),
      scores.length > 1
        ? element('small', { title: worst.device }, 'worst ' + missText(worst.objective) + ', ' + short(worst.device))
        : null,
    );
  };
  const verdict = (law) =>
    element('span', { class: GRADE_TONES[law.prediction_grade] }, law.prediction_grade);
  const ratio = (law) =>
    law.fitted_objective > 0 ? significant(law.predicted_objective / law.fitted_objective, 2) : DASH;
  const columns = [
    { title: 'Law', pinned: true, tight: true, cell: (law) => strong(law.name) },
    { title: 'Prediction', tight: true, cell: verdict },
    ...blocks.map((block) => ({
      title: 'Block ' + block.block,
      unit:
        (block.amplitudes.length > 0 ? '±' + significant(mean(block.amplitudes), 3) + THIN + MM + ', ' : '') +
        (block.fitted ? 'fitted' : 'predicted'),
      number: true,
      cell: (law) => score(law, block),
    })),
    { title: 'Fitted', unit: 'mean', number: true, cell: (law) => fixed(law.fitted_objective, 4) },
    { title: 'Predicted', unit: 'mean', number: true, cell: (law) => missText(law.predicted_objective) },
    { title: 'Predicted', unit: '/ fitted', number: true, cell: ratio },
    { title: 'Worst', unit: 'predicted', number: true, cell: (law) => missText(law.worst_predicted) },
  ];
  return tableOf(columns, predictedLaws, 'Objective of every law on every block');
}

function predictionData() {
  const ofBlock = resultColumns('scores');
  const ofLaw = resultColumns('laws', ['prediction_grade']);
  return {
    columns: ['law', 'device', ...ofBlock.columns, ...ofLaw.columns],
    rows: predictedLaws.flatMap((law) =>
      law.devices.flatMap((fit) =>
        fit.blocks.map((score) => [law.id, devices[fit.device].name, ...ofBlock.cells(score), ...ofLaw.cells(law)]),
      ),
    ),
  };
}
