const MARKER = 8, // half the width of a point's marker in pixels
  LETTERS = 16; // height of a label in pixels

const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

function enters([x0, y0], [x1, y1], box) {
  const steps = Math.max(2, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / 4));
  for (let k = 1; k < steps; ++k) {
    const x = x0 + ((x1 - x0) * k) / steps,
      y = y0 + ((y1 - y0) * k) / steps;
    if (x > box[0] && x < box[2] && y > box[1] && y < box[3]) return true;
  }
  return false;
}

// Returns the centre of each point's label. A label is beside its point or, farther away, joined to it by a line. If
// there is room, labels lie inside the plot and cover no point and no other label, and they avoid the stepped line
// through the points whose indices are in `stair`, from left to right. points: [{x, y, width}] in pixels, with the
// width of the label; `others` are points without a label.
export function labelPlaces(points, stair, width, height, others = []) {
  const markers = [...points, ...others].map(({ x, y }) => [x - MARKER, y - MARKER, x + MARKER, y + MARKER]);
  const steps = stair.slice(1).flatMap((to, k) => {
    const [{ x: x0, y: y0 }, { x: x1, y: y1 }] = [points[stair[k]], points[to]];
    return [
      [Math.min(x0, x1), y0 - 1, Math.max(x0, x1), y0 + 1],
      [x1 - 1, Math.min(y0, y1), x1 + 1, Math.max(y0, y1)],
    ];
  });
  const placed = [],
    lines = [];
  for (const [i, point] of points.entries()) {
    const w = point.width / 2 + 1,
      h = LETTERS / 2;
    const sides = [[0, -1], [1, 0], [0, 1], [-1, 0], [1, -1], [1, 1], [-1, 1], [-1, -1]].map(([dx, dy]) => ({
      x: point.x + dx * (w + (dy === 0 ? MARKER + 2 : 4)),
      y: point.y + dy * (h + (dx === 0 ? MARKER + 1 : 4)),
      adjacent: true,
    }));
    const anywhere = [];
    for (let y = h + 2; y <= height - h - 2; y += 3)
      for (let x = w + 2; x <= width - w - 2; x += 6) anywhere.push({ x, y, adjacent: false });
    const cost = ({ x, y, adjacent }, place) => {
      const box = [x - w, y - h, x + w, y + h];
      if (box[0] < 1 || box[1] < 1 || box[2] > width - 1 || box[3] > height - 1) return Infinity;
      if ([...markers, ...placed].some((other) => meet(box, other))) return Infinity;
      const covered = steps.filter((step) => meet(box, step)).length + lines.filter(([from, to]) => enters(from, to, box)).length;
      if (adjacent) return place + 30 * covered;
      const from = [point.x, point.y];
      const crossed = [...markers.filter((_, k) => k !== i), ...placed].filter((other) => enters(from, [x, y], other)).length;
      return 40 + Math.hypot(Math.max(0, Math.abs(x - point.x) - w), Math.max(0, Math.abs(y - point.y) - h)) + 200 * crossed + 30 * covered;
    };
    const cheapest = (some) =>
      some.map((candidate, place) => ({ candidate, cost: cost(candidate, place) })).reduce((a, b) => (b.cost < a.cost ? b : a));
    const near = cheapest(sides);
    const best = (near.cost < 30 ? near : cheapest([...sides, ...anywhere])).candidate;
    placed.push([best.x - w, best.y - h, best.x + w, best.y + h]);
    if (!best.adjacent) lines.push([[point.x, point.y], [best.x, best.y]]);
    point.label = best;
  }
  return points.map(({ label }) => label);
}

// Returns positions for labels. They are as near as possible to the `wanted` positions (ascending), lie between `low`
// and `high`, and are at least `gap` apart.
export function spread(wanted, gap, low, high) {
  const most = high - (wanted.length - 1) * gap;
  const groups = [];
  wanted.forEach((value, i) => {
    groups.push({ sum: Math.max(low, Math.min(most, value - i * gap)), size: 1 });
    while (groups.length > 1) {
      const [before, last] = groups.slice(-2);
      if (before.sum / before.size <= last.sum / last.size) break;
      groups.splice(-2, 2, { sum: before.sum + last.sum, size: before.size + last.size });
    }
  });
  return groups.flatMap((group) => Array(group.size).fill(group.sum / group.size)).map((value, i) => value + i * gap);
}

// Places the numbers of cycles near the cycles' peaks. The rightmost peaks have their numbers in the right margin. All
// others have them above and to the left, where a hysteresis loop leaves room. Numbers for which there is no room are
// left out.
export function peakLabels(labels, pixel, room, height) {
  const gap = 15,
    columns = [];
  for (const label of labels.map((l) => ({ ...l, at: pixel(l.x, l.y) })).sort((a, b) => a.at[0] - b.at[0])) {
    const column = columns[columns.length - 1];
    if (column && label.at[0] - column[column.length - 1].at[0] < 40) column.push(label);
    else columns.push([label]);
  }
  return columns.flatMap((column, place) => {
    const outermost = place === columns.length - 1;
    column.sort((a, b) => a.at[1] - b.at[1]);
    const needed = 8 + (column.length - 1) * gap;
    const bottom = outermost
      ? height - 8
      : Math.max(column[0].at[1] - 12, Math.min(needed, column[column.length - 1].at[1] + 12));
    const most = Math.max(2, Math.floor((bottom - 8) / gap) + 1);
    const every = Math.ceil(column.length / most);
    const named = column.filter((label) => every === 1 || label.number % every === 1 % every);
    const wanted = outermost ? named.map((l) => l.at[1]) : named.map((_, i) => bottom - (named.length - 1 - i) * gap);
    const places = spread(wanted, gap, 8, bottom);
    const edge = outermost
      ? Math.max(...column.map((l) => l.at[0])) + room
      : Math.min(...column.map((l) => l.at[0])) - 26;
    return named.map((label, i) => ({
      x: label.x, y: label.y, ax: edge - label.at[0], ay: places[i] - label.at[1], text: label.text,
      xanchor: outermost ? 'left' : 'right', color: label.color,
    }));
  });
}
