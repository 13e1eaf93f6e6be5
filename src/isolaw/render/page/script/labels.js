// Where labels of a plot go.

// Where each label of a scatter goes: the first side where it meets no point, no label placed before, and not the
// stair that joins `stair`, the indices of points from left to right. Ranges as drawn, width and height in pixels.
export function labelPlaces(points, stair, xRange, yRange, width, height) {
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

// Places of least movement for labels that are `gap` apart at least, between `low` and `high`; `wanted` ascends.
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

// Numbers of the loops, joined to their positive peaks: those of the outermost peaks in the margin at the right, the
// others up and left of their peaks, where a hysteresis loop leaves room. `pixel` gives the place of a peak.
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
