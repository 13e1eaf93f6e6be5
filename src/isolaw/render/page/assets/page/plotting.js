// Plotting

const SYMBOLS = ['circle', 'square', 'diamond', 'triangle-up', 'triangle-down', 'cross', 'x', 'star'];
const DASHES = ['solid', 'dash', 'dashdot', 'dot', 'longdash', 'longdashdot', '6px,3px', '10px,3px,2px,3px'];

function theme() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue('--' + name).trim();
  return {
    colour,
    law: (law) => colour('law-' + ((law.index % 8) + 1)),
    font: style.getPropertyValue('--sans').trim(),
  };
}
const symbolOf = (law) => SYMBOLS[law.index % SYMBOLS.length];
const dashOf = (place) => DASHES[place % DASHES.length]; // by the order of the chosen laws: the first one is solid

const LEGEND = { orientation: 'h', x: 0, y: 1.02, xanchor: 'left', yanchor: 'bottom', font: { size: 12 } };

// A layout in the page's typography; axes are merged over the common axis style.
function styled(layout, look) {
  const axis = {
    gridcolor: look.colour('grid'),
    zerolinecolor: look.colour('rule'),
    linecolor: look.colour('rule'),
    showline: true,
    tickfont: { size: 11.5 },
    title: { standoff: 6 },
    automargin: true,
    ticks: '',
  };
  const result = {
    autosize: false, // the page gives every plot its size
    paper_bgcolor: 'rgba(0,0,0,0)',
    plot_bgcolor: 'rgba(0,0,0,0)',
    font: { family: look.font, size: 12.5, color: look.colour('ink') },
    margin: { l: 54, r: 12, t: 10, b: 44 },
    hoverlabel: {
      bgcolor: look.colour('paper'),
      bordercolor: look.colour('rule'),
      font: { family: look.font, size: 12.5, color: look.colour('ink') },
      align: 'left',
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
        ? { text: own.title, standoff: 6, font: { size: 12.5, color: look.colour('muted') } }
        : own.title;
    result[name] = { ...axis, ...own, title };
  }
  return result;
}

// The buttons are named one by one, and no server: Plotly's own default offers to upload the figure.
const PLOT_CONFIG = {
  displaylogo: false,
  displayModeBar: 'hover',
  plotlyServerURL: '',
  modeBarButtons: [['toImage', 'zoom2d', 'pan2d', 'resetScale2d']],
  toImageButtonOptions: { format: 'svg', filename: 'isolaw-figure' },
};

// The range of some values with a share of it free on both sides.
function paddedRange(values, share) {
  const low = Math.min(...values),
    high = Math.max(...values),
    margin = share * (high - low || Math.abs(low) || 1);
  return [low - margin, high + margin];
}

// Ticks of a logarithmic axis at 1, 2 and 5 times powers of ten; at the powers alone where these are many.
function decadeTicks(values) {
  const some = values.filter((value) => isNumber(value) && value > 0);
  if (some.length === 0) return {};
  const [low, high] = [Math.min(...some), Math.max(...some)].map(Math.log10);
  const steps = high - low > 2.5 ? [1] : [1, 2, 5];
  const tickvals = [];
  for (let power = Math.floor(low); power <= Math.ceil(high); ++power) tickvals.push(...steps.map((step) => step * 10 ** power));
  return { tickmode: 'array', tickvals, ticktext: tickvals.map((value) => significant(value, 1)) };
}

// Where each label of a scatter goes: the first side where it meets no point, no label placed before, and not the
// stair that joins `stair`, the indices of points from left to right. Ranges as drawn, width and height in pixels.
function labelPlaces(points, stair, xRange, yRange, width, height) {
  const at = points.map((p) => [
    ((p.x - xRange[0]) / (xRange[1] - xRange[0])) * width,
    (1 - (p.y - yRange[0]) / (yRange[1] - yRange[0])) * height,
  ]);
  const taken = at.map(([x, y]) => [x - 7, y - 7, x + 7, y + 7]);
  for (let k = 1; k < stair.length; ++k) {
    const [x0, y0] = at[stair[k - 1]],
      [x1, y1] = at[stair[k]];
    taken.push([x0, y0 - 1, x1, y0 + 1], [x1 - 1, y0, x1 + 1, y1]);
  }
  return points.map((point, i) => {
    const [x, y] = at[i],
      w = 7 * point.label.length,
      h = 16;
    const sides = {
      'top center': [x - w / 2, y - 8 - h, x + w / 2, y - 8],
      'middle right': [x + 9, y - h / 2, x + 9 + w, y + h / 2],
      'bottom center': [x - w / 2, y + 8, x + w / 2, y + 8 + h],
      'middle left': [x - 9 - w, y - h / 2, x - 9, y + h / 2],
      'top right': [x + 5, y - 5 - h, x + 5 + w, y - 5],
      'bottom right': [x + 5, y + 5, x + 5 + w, y + 5 + h],
    };
    const free =
      Object.keys(sides).find((side) => {
        const b = sides[side];
        if (b[0] < -40 || b[2] > width + 10) return false;
        return taken.every((t, k) => k === i || b[2] < t[0] || t[2] < b[0] || b[3] < t[1] || t[3] < b[1]);
      }) ?? 'top center';
    taken.push(sides[free]);
    return free;
  });
}
