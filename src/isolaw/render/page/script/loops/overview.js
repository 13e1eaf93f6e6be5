import { chosen } from '../choice.js';
import { panelHeading } from '../plotting.js';
import { devices, laws } from '../report.js';
import { fixed, plain } from '../text.js';
import { cutOff, loopData, shownLoops } from './fits.js';
import { inOrder, orderText } from './table.js';
import { KN, LOOP_HOVER, MM } from '../units.js';

export const loopOverviewFigure = {
  id: 'loop-overview',
  title: '',
  depends: ['device', 'order'],
  wanted: () => chosen.device !== null,
  caption: () =>
    'Best fit of each law (coloured) and measured loop of ' + devices[chosen.device].name +
    ' (grey), all to one scale, ' + orderText() + '.' + cutOff(laws),
  csv: () => loopData(laws),
  height: (width) => overviewGrid(shownLoops(laws).fits.length, width).height,
  draw: drawOverview,
};

// The layout of the panels in pixels. All panels have the same size and a heading. A row has as many panels as fit, at
// most four.
const OVERVIEW_MARGIN = { l: 50, r: 8, t: 8, b: 44 };

function overviewGrid(panels, width) {
  const columns = Math.max(1, Math.min(panels, width > 900 ? 4 : width > 560 ? 3 : 2));
  const rows = Math.max(1, Math.ceil(panels / columns)),
    wide = width / columns > 240;
  const panel = wide ? 190 : 150,
    heading = 22,
    between = 46;
  const height = OVERVIEW_MARGIN.t + heading + rows * panel + (rows - 1) * between + OVERVIEW_MARGIN.b;
  return { columns, wide, panel, heading, between, height };
}

function drawOverview(look, width) {
  const { measured, fits: all, range } = shownLoops(laws);
  const fits = inOrder(all);
  const { columns, wide, panel, heading, between, height } = overviewGrid(fits.length, width);
  const plotHeight = height - OVERVIEW_MARGIN.t - OVERVIEW_MARGIN.b;
  const layout = { margin: OVERVIEW_MARGIN, annotations: [] };
  const traces = [];
  fits.forEach(({ law, fit, force }, i) => {
    const column = i % columns,
      row = Math.floor(i / columns),
      suffix = i === 0 ? '' : String(i + 1);
    const gap = 0.035,
      w = (1 - gap * (columns - 1)) / columns;
    const left = column * (w + gap),
      h = panel / plotHeight,
      top = 1 - (heading + row * (panel + between)) / plotHeight;
    const lowest = i + columns >= fits.length;
    layout['xaxis' + suffix] = {
      domain: [left, left + w], anchor: 'y' + suffix, nticks: wide ? 6 : 4, tickangle: 0, title: lowest ? MM : '',
      matches: i > 0 ? 'x' : undefined, showticklabels: lowest,
    };
    layout['yaxis' + suffix] = {
      domain: [top - h, top], anchor: 'x' + suffix, nticks: 5, range, title: column === 0 ? KN : '',
      matches: i > 0 ? 'y' : undefined, showticklabels: column === 0,
    };
    layout.annotations.push(panelHeading(look, left, top, '<b>' + plain(law.name) + '</b>  OF ' + fixed(fit.objective.best, 4)));
    const axes = { xaxis: 'x' + suffix, yaxis: 'y' + suffix, mode: 'lines', showlegend: false };
    traces.push(
      {
        ...axes, x: measured.x, y: measured.F, hoverinfo: 'skip', opacity: 0.75,
        line: { color: look.colour('measured'), width: 2.6 },
      },
      {
        ...axes, x: measured.x, y: force, line: { color: look.law(law), width: 1.5 },
        hovertemplate: LOOP_HOVER + '<extra>' + plain(law.name) + '</extra>',
      },
    );
  });
  return { traces, layout };
}
