// Writes one report of a campaign and one page of an inspection, both for the built-in example lot. The program in the
// page computes them.
//   node sample_reports.mjs --engine-html FILE --out DIR
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { engineOf } from './in_node.mjs';

const options = {};
for (let i = 2; i < process.argv.length; i += 2) options[process.argv[i].slice(2)] = process.argv[i + 1];
const engine = await engineOf(options['engine-html'], { workers: 1 });
const keep = ['out/*.html'];
const write = async (argv, files, name) => {
  const said = await engine.run({ argv, files, keep });
  if (said.code !== 0) throw new Error(said.stderr);
  writeFileSync(join(options.out, name), said.files[0].bytes);
};
mkdirSync(options.out, { recursive: true });
const { files } = await engine.run({ argv: ['example', 'lot'] });
await write(['calibrate', 'lot/lot.toml', '--laws', 'bilinear', '--runs', '1', '--analysis', 'none', '--figures', 'none', '--out', 'out'], files, 'report.html');
await write(['inspect', 'lot/lot.toml', '--out', 'out'], files, 'inspection.html');
engine.close();
process.exit(0);
