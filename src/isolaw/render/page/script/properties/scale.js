// Returns a function that gives the colour of a cycle. Its argument runs from 0, the first cycle of a block, to 1, the
// last.
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
