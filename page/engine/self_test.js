// Fits two laws to a record of the example lot and compares the objectives with those of the native program.

const expected = { bilinear: 0.05060711114368681, vaiana: 0.021805097912677526 };
// Searches on processors with different instruction sets end at objectives that differ by at most this share of the
// objective.
const tolerance = 1e-6;

export const runSelfTest = async (run) => {
  const example = await run({ argv: ['example', 'lot'] });
  const laws = Object.keys(expected);
  const said = await run({
    argv: ['calibrate', 'lot/device-01.csv', '--laws', laws.join(','), '--runs', '1', '--analysis', 'none', '--figures', 'none', '--json', '--out', 'out'],
    files: example.files,
    keep: [],
  });
  const what = `least objectives of ${laws.join(' and ')} on a built-in record, within ${tolerance} of themselves`;
  if (said.code !== 0) return { ok: false, found: said.stderr.trim(), expected: Object.values(expected).join(', '), what };
  const summary = JSON.parse(said.stdout);
  const found = laws.map((law) => summary.laws.find(({ id }) => id === law).devices[0].objective.best);
  return {
    ok: laws.every((law, i) => Math.abs(found[i] - expected[law]) <= tolerance * expected[law]),
    found: found.join(', '),
    expected: Object.values(expected).join(', '),
    what,
  };
};
