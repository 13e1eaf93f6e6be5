import { inFigure } from './symbols.js';
import { isNumber, plain, significant } from './text.js';
import { data } from './units.js';

// Each law has a colour and a symbol. If there are more laws than colours, the colours and symbols repeat. The repeated
// ones have open symbols, and dashed lines in the key.
export const SYMBOLS = data.symbols;
const COLOURS = SYMBOLS.length;
export const colourOf = (law) => 'law-' + ((law.index % COLOURS) + 1);
export const isAgain = (law) => law.index >= COLOURS;

const DASHES = ['solid', 'dash', 'dashdot', 'dot', 'longdash', 'longdashdot', '6px,3px', '10px,3px,2px,3px'];
export const NARROW = 620; // pixels; a narrower window is that of a telephone

export function theme() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue('--' + name).trim();
  return {
    colour,
    law: (law) => colour(colourOf(law)),
    font: style.getPropertyValue('--sans').trim(),
  };
}

export const symbolOf = (law) => SYMBOLS[law.index % SYMBOLS.length] + (isAgain(law) ? '-open' : '');
export const dashOf = (place) => DASHES[place % DASHES.length]; // `place`: index among the chosen laws; 0 is solid
export const LEGEND = { orientation: 'h', x: 0, y: 1.02, xanchor: 'left', yanchor: 'bottom', font: { size: 12 } };

export function styled(layout, look) {
  const axis = {
    gridcolor: look.colour('grid'), zerolinecolor: look.colour('rule'), linecolor: look.colour('rule'), showline: true, exponentformat: 'power', minexponent: 6,
    tickfont: { size: 11.5 }, title: { standoff: 6 }, automargin: true, ticks: '',
  };
  const result = {
    autosize: false, // the page sets the size of every plot
    paper_bgcolor: 'rgba(0,0,0,0)',
    plot_bgcolor: 'rgba(0,0,0,0)',
    font: { family: look.font, size: 12.5, color: look.colour('ink') },
    margin: { l: 54, r: 12, t: 10, b: 44 },
    hoverlabel: {
      bgcolor: look.colour('paper'), bordercolor: look.colour('rule'),
      font: { family: look.font, size: 12.5, color: look.colour('ink') }, align: 'left',
    },
    legend: LEGEND,
    modebar: { bgcolor: 'rgba(0,0,0,0)', color: look.colour('muted'), activecolor: look.colour('ink') },
    showlegend: false,
    hovermode: 'closest',
    dragmode: 'zoom',
    ...layout,
  };
  for (const name of Object.keys(result)) {
    if (!/^[xy]axis\d*$/.test(name)) continue;
    const own = result[name];
    const title =
      typeof own.title === 'string'
        ? { text: inFigure(own.title), standoff: 6, font: { size: 12.5, color: look.colour('muted') } }
        : own.title;
    result[name] = { ...axis, ...own, title };
  }
  if (result.annotations)
    result.annotations = result.annotations.map((one) => ({ ...one, text: inFigure(one.text ?? '') }));
  return result;
}

// All buttons are listed, because Plotly's usual set includes one that uploads the figure to a server.
export const PLOT_CONFIG = {
  displaylogo: false,
  displayModeBar: 'hover',
  plotlyServerURL: '',
  modeBarButtons: [['toImage', 'zoom2d', 'pan2d', 'resetScale2d']],
  toImageButtonOptions: { format: 'svg', filename: 'isolaw-figure' },
};

export function paddedRange(values, share) {
  const low = Math.min(...values),
    high = Math.max(...values),
    margin = share * (high - low || Math.abs(low) || 1);
  return [low - margin, high + margin];
}

const pen = document.createElement('canvas').getContext('2d');
export function textWidth(look, text, size) {
  pen.font = size + 'px ' + look.font;
  return pen.measureText(text).width;
}

// Returns an axis with an interval of equal width for each name. At most `most` of the names stand below it.
export function namedAxis(names, most) {
  const every = Math.ceil(names.length / most);
  const tickvals = names.map((_, i) => i).filter((i) => i % every === 0);
  return {
    tickmode: 'array', tickvals, ticktext: tickvals.map((i) => plain(names[i])), range: [-0.6, names.length - 0.4],
    showgrid: false, zeroline: false,
  };
}

export const panelHeading = (look, x, y, text, size = 12) => ({
  xref: 'paper', yref: 'paper', x, y, xanchor: 'left', yanchor: 'bottom', showarrow: false, text,
  font: { size, color: look.colour('ink') },
});

// Returns the ticks of a logarithmic axis. They are at 1, 2 and 5 times powers of ten, or only at the powers of ten if
// the axis spans many of them.
export function decadeTicks(values) {
  const some = values.filter((value) => isNumber(value) && value > 0);
  if (some.length === 0) return {};
  const [low, high] = [Math.min(...some), Math.max(...some)].map(Math.log10);
  const steps = high - low > 2.5 ? [1] : [1, 2, 5];
  const tickvals = [];
  for (let power = Math.floor(low); power <= Math.ceil(high); ++power) tickvals.push(...steps.map((step) => step * 10 ** power));
  return { tickmode: 'array', tickvals, ticktext: tickvals.map((value) => significant(value, 1)) };
}

export function emptyPlot(look, text) {
  return {
    traces: [],
    layout: {
      xaxis: { visible: false },
      yaxis: { visible: false },
      annotations: [
        {
          xref: 'paper', yref: 'paper', x: 0.5, y: 0.5, showarrow: false, text: plain(text),
          font: { size: 13, color: look.colour('muted') },
        },
      ],
    },
  };
}
