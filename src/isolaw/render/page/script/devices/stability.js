import { chosen } from '../choice.js';
import { FOLLOWED, counted, countedCycles, cycleData } from '../cycles.js';
import { designOf, followedPanels, followedText, framePanel } from '../followed.js';
import { lotQuantities } from '../lot.js';
import { NARROW, emptyPlot } from '../plotting.js';
import { devices } from '../report.js';
import { count, isNumber, plain } from '../text.js';

export const lotStabilityFigure = {
  id: 'lot-stability',
  title: 'Stability of all devices',
  depends: ['tested', 'block'],
  wanted: () => devices.some((device) => countedCycles(device).length > 0),
  caption: lotStabilityCaption,
  csv: () => cycleData(devices),
  height: (width) => (width < NARROW ? 3 * 190 : 270),
  draw: drawLotStability,
};

function comparedBlock(device) {
  const number = chosen.block === 'all' ? device.reported?.block : chosen.block;
  return device.blocks.find((block) => block.number === number) ?? null;
}

function lotStabilityCaption() {
  const shown = devices.filter((device) => comparedBlock(device));
  return (
    'One line per device, ' +
    (chosen.block === 'all' ? 'its reported block (the largest amplitude)' : 'block ' + chosen.block + ' of each') +
    '; bold: ' +
    (chosen.tested === null ? 'none' : devices[chosen.tested].name) + '. ' + count(shown.length, 'device') + '.' +
    (lotQuantities.some((quantity) => isNumber(quantity.nominal))
      ? ' Dashed: design value; band: limits of one device.'
      : '')
  );
}

function drawLotStability(look, width) {
  const entries = devices
    .map((device) => ({ device, block: comparedBlock(device) }))
    .filter(({ block }) => block && counted(block).length > 0);
  if (entries.length === 0) return emptyPlot(look, 'no device has this block');
  const layout = followedPanels(
    width < NARROW,
    Math.max(...entries.flatMap(({ block }) => counted(block).map((cycle) => cycle.number))),
  );
  const traces = FOLLOWED.flatMap((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1);
    // All thin lines are one trace with gaps between devices, so that 160 devices are drawn quickly.
    const line = (among, bold) => {
      const x = [],
        y = [],
        text = [];
      for (const { device, block } of among) {
        counted(block).forEach((cycle, k) => {
          x.push(cycle.number);
          y.push(cycle[property.key]);
          text.push('<b>' + plain(device.name) + '</b><br>' + followedText(property, block, cycle, k));
        });
        x.push(null);
        y.push(null);
        text.push('');
      }
      return {
        mode: bold ? 'lines+markers' : 'lines', showlegend: false, xaxis: 'x' + suffix, yaxis: 'y' + suffix, x, y, text,
        opacity: bold ? 1 : entries.length > 40 ? 0.5 : 0.75,
        line: { color: look.colour(bold ? 'accent' : 'measured'), width: bold ? 2.6 : 0.9 },
        marker: { color: look.colour('accent'), size: 6 }, hovertemplate: '%{text}<extra>cycle %{x}</extra>',
      };
    };
    return [
      line(entries.filter(({ device }) => device.index !== chosen.tested), false),
      line(entries.filter(({ device }) => device.index === chosen.tested), true),
    ];
  });
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      designOf(property.name, []),
      entries.flatMap(({ block }) => counted(block).map((c) => c[property.key])),
    ),
  );
  return { traces, layout: { ...layout, margin: { l: 54, r: 8, t: 8, b: 44 } } };
}
