import { lawChooser } from '../choosers.js';
import { namedAxis } from '../plotting.js';
import { devices, fitData, lotLaws } from '../report.js';
import { fixed, isNumber, plain, short } from '../text.js';
import { fitsInLot, ofLot } from './of_lot.js';

export const lotDevicesFigure = {
  id: 'lot-devices',
  title: 'Own law, the lot\u2019s law, and the law of all other devices',
  depends: ['lotLaw'],
  wanted: () => lotLaws.length > 0,
  controls: () => [lawChooser('lotLaw', lotLaws)],
  caption: lotDevicesCaption,
  csv: () => fitData(['optimum', 'lot_objective', 'worst_objective', 'left_out_objective'], lotLaws, fitsInLot),
  height: () => 360,
  draw: drawLotDevices,
};

function lotDevicesCaption() {
  const law = ofLot();
  const cost = fitsInLot(law)
    .filter((fit) => isNumber(fit.left_out_objective) && isNumber(fit.optimum))
    .sort((a, b) => b.left_out_objective - b.optimum - (a.left_out_objective - a.optimum));
  return (
    law.name +
    ': from circle to square, the cost of sharing one law; from circle to diamond, the cost of not testing the device.' +
    (cost.length > 1
      ? ' The second is largest for ' +
        devices[cost[0].device].name +
        ' (' + fixed(cost[0].optimum, 4) + ' with its own law, ' + fixed(cost[0].left_out_objective, 4) +
        ' left out), smallest for ' + devices[cost[cost.length - 1].device].name + '.'
      : '')
  );
}

function drawLotDevices(look, width) {
  const law = ofLot(),
    fits = fitsInLot(law),
    size = fits.length > 60 ? 6 : 9;
  const kinds = [
    { name: 'own law', key: 'optimum', symbol: 'circle', colour: 'law-1' },
    { name: 'the lot\u2019s law', key: 'lot_objective', symbol: 'square', colour: 'law-5' },
    { name: 'left out', key: 'left_out_objective', symbol: 'diamond', colour: 'law-2' },
  ];
  const names = fits.map((fit) => short(devices[fit.device].name));
  const spans = fits.flatMap((fit, i) => {
    const values = kinds.map(({ key }) => fit[key]).filter(isNumber);
    return [
      [i, Math.min(...values)],
      [i, Math.max(...values)],
      [null, null],
    ];
  });
  return {
    traces: [
      {
        mode: 'lines', x: spans.map(([x]) => x), y: spans.map(([, y]) => y), showlegend: false, hoverinfo: 'skip',
        line: { color: look.colour('measured'), width: 1.4 },
      },
      ...kinds.map(({ name, key, symbol, colour }) => ({
        name, mode: 'markers', x: fits.map((_, i) => i), y: fits.map((fit) => fit[key]),
        text: fits.map((fit) => plain(devices[fit.device].name)), marker: { symbol, size, color: look.colour(colour) },
        hovertemplate: '<b>%{text}</b>, ' + name + '<br>OF %{y:.4f}<extra></extra>',
      })),
    ],
    layout: {
      showlegend: true,
      xaxis: namedAxis(names, Math.max(4, Math.min(24, Math.floor(width / 60)))),
      yaxis: { title: 'objective OF [-]', rangemode: 'tozero' },
    },
  };
}
