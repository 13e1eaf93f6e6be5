import { chosen } from '../choice.js';
import { FOLLOWED, chosenBlocks, counted } from '../cycles.js';
import { onScreen } from '../dom.js';
import { designOf, followedPanels, followedText, framePanel } from '../followed.js';
import { SYMBOLS, emptyPlot } from '../plotting.js';
import { devices, resultColumns } from '../report.js';
import { fixed, isNumber } from '../text.js';
import { CYCLES_HEIGHT } from './loops.js';

export const stabilityFigure = {
  id: 'stability',
  width: 'narrow',
  title: 'Stability from cycle to cycle',
  depends: ['tested', 'block'],
  wanted: () => chosen.tested !== null,
  caption: stabilityCaption,
  csv: stabilityData,
  height: () => CYCLES_HEIGHT,
  draw: drawStability,
};

function stabilityCaption() {
  const device = devices[chosen.tested];
  // A caption has room for three blocks. If there are more, it describes only the block of the reported cycle.
  const blocks = chosenBlocks(device);
  const said = (blocks.length > 3 ? blocks.filter((block) => block.number === device.reported?.block) : blocks)
    .map((block) => {
      const [K, E] = [block.stability?.K_eff, block.stability?.energy];
      if (!isNumber(K?.first_to_third)) return null;
      const late =
        isNumber(K.min_2_10) && isNumber(K.max_2_10)
          ? '; cycles 2\u201310: K_eff ' + fixed(K.min_2_10, 2) + ' to ' + fixed(K.max_2_10, 2)
          : '';
      return (
        'Block ' + block.number + ': first cycle ' + fixed(K.first_to_third, 2) + ' in K_eff' +
        (isNumber(E?.first_to_third) ? ', ' + fixed(E.first_to_third, 2) + ' in energy' : '') + late + '.'
      );
    })
    .filter(Boolean);
  const held = device.assessments.some(
    (a) => FOLLOWED.some(({ name }) => a.property === name) && isNumber(a.nominal),
  );
  return (
    (said.length > 0
      ? 'Against cycle 3. ' +
        said.join(' ') +
        (blocks.length > 3 ? onScreen(' Choose a block above for the others.') : '')
      : 'No block has a third cycle to compare with.') + (held ? ' Dashed: design value; band: its limits.' : '')
  );
}

function stabilityData() {
  const { columns, cells } = resultColumns('stability');
  return {
    columns: ['device', 'block', 'property', 'cycle', 'value', 'ratio to cycle 3', ...columns],
    rows: devices[chosen.tested].blocks.flatMap((block) =>
      FOLLOWED.flatMap((property) =>
        counted(block).map((cycle, k) => {
          const stability = block.stability?.[property.name];
          return [
            devices[chosen.tested].name, block.number, property.title, cycle.number, cycle[property.key],
            stability?.ratio_to_third?.[k], ...cells(stability ?? {}),
          ];
        }),
      ),
    ),
  };
}

function drawStability(look) {
  const device = devices[chosen.tested],
    blocks = chosenBlocks(device).filter((block) => counted(block).length > 0);
  if (blocks.length === 0) return emptyPlot(look, 'no cycle that counts');
  const layout = followedPanels(true, Math.max(...blocks.flatMap(counted).map((cycle) => cycle.number)));
  const traces = FOLLOWED.flatMap((property, i) =>
    blocks.map((block) => {
      const cycles = counted(block),
        suffix = i === 0 ? '' : String(i + 1),
        place = device.blocks.indexOf(block);
      return {
        name: 'block ' + block.number, legendgroup: String(block.number), showlegend: i === 0, mode: 'lines+markers',
        xaxis: 'x' + suffix, yaxis: 'y' + suffix, x: cycles.map((cycle) => cycle.number),
        y: cycles.map((cycle) => cycle[property.key]),
        text: cycles.map((cycle, k) => followedText(property, block, cycle, k)),
        line: { color: look.law({ index: place }), width: 1.4 },
        marker: { color: look.law({ index: place }), symbol: SYMBOLS[place % SYMBOLS.length], size: 6 },
        hovertemplate: 'cycle %{x}: %{text}<extra>block ' + block.number + '</extra>',
      };
    }),
  );
  const held = device.assessments.filter((a) => blocks.some((block) => a.block === block.number));
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      held.length > 0 ? designOf(property.name, held) : { nominal: null, band: null },
      blocks.flatMap(counted).map((cycle) => cycle[property.key]),
    ),
  );
  return {
    traces,
    layout: { ...layout, showlegend: blocks.length > 1 && blocks.length <= 6, margin: { l: 58, r: 8, t: 6, b: 40 } },
  };
}
