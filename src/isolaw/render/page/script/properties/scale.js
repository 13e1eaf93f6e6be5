// Plotly's colour scale for cycles, from the first cycle of a block, 0, to the last, 1.
export function cycleScale(look) {
  const stops = ['first', 'middle', 'last'].map((name) =>
    [1, 3, 5].map((i) => parseInt(look.colour('cycle-' + name).slice(i, i + 2), 16)),
  );
  return (share) => {
    const [from, to] = share < 0.5 ? [stops[0], stops[1]] : [stops[1], stops[2]];
    const way = share < 0.5 ? 2 * share : 2 * share - 1;
    return 'rgb(' + from.map((c, i) => Math.round(c + way * (to[i] - c))).join(',') + ')';
  };
}

export const shareOf = (cycle, largest) => (largest > 1 ? (cycle.number - 1) / (largest - 1) : 1);
