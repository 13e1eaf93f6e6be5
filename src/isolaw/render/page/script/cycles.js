import { chosen } from './choice.js';
import { headingOf, headingText, report, resultColumns } from './report.js';
import { THIN, isNumber, printed, significant } from './text.js';
import { MM } from './units.js';

// The properties that the page follows from cycle to cycle. `key` is the name of a property in the object of a cycle,
// and `name` its name in a rule set.
export const FOLLOWED = report.followed.map(({ name, key }) => {
  const heading = headingOf('cycles', key);
  const text = (value) => printed(value, heading) + THIN + heading.unit;
  return { name, key, title: headingText(heading), text };
});

export const counted = (block) => block.cycles.filter((cycle) => cycle.counts);
export const countedCycles = (device) => device.blocks.flatMap(counted);
export const largestNumber = (device) => Math.max(1, ...countedCycles(device).map((cycle) => cycle.number));

export const chosenBlocks = (device) =>
  device.blocks.filter((block) => chosen.block === 'all' || block.number === chosen.block);

export const amplitudeText = (block) =>
  counted(block).length > 0 ? '±' + significant(block.amplitude_mm, 3) + THIN + MM : 'no complete cycle';

// Describes a block, with its number first: "2, ±60 mm, 0.5 Hz, sine".
export function blockFacts(block) {
  return (
    block.number + ', ' + amplitudeText(block) +
    (isNumber(block.frequency_Hz) ? ', ' + significant(block.frequency_Hz, 2) + THIN + 'Hz' : '') +
    (block.waveform ? ', ' + block.waveform : '')
  );
}

export const blockText = (block) => 'block ' + blockFacts(block);

export const cycleText = (block, cycle) =>
  'block ' + block.number + ', ' + (cycle.counts ? (cycle.half ? 'half cycle ' : 'cycle ') + cycle.number : 'not counted: ' + cycle.reason);

export const isReported = (device, block, cycle) =>
  device.reported !== null &&
  block.number === device.reported.block &&
  cycle.counts &&
  cycle.number === device.reported.number;

export const reportedCycle = (device) =>
  device.blocks.flatMap((block) => block.cycles.filter((cycle) => isReported(device, block, cycle)))[0] ?? null;

// Returns the cycle whose values represent a block: its third counted cycle, or its last counted cycle if it has fewer.
export function countingCycle(block) {
  const some = counted(block);
  return some[Math.min(some.length, 3) - 1] ?? null;
}

// The block whose values represent a device: the one with the amplitude nearest to the design displacement or, without
// a design displacement, with the largest amplitude.
export const assessedBlock = (device) => device.blocks.find((block) => block.number === device.counting_block);
export function assessedCycle(device) {
  const block = assessedBlock(device);
  return block ? countingCycle(block) : null;
}
export const noCycles = (device) => device.properties_refusal || device.message || 'none was found';

export function cycleData(among) {
  const ofBlock = resultColumns('blocks', ['number', 'waveform', 'frequency_Hz']);
  const ofCycle = resultColumns('cycles');
  const ratios = (block, cycle) =>
    FOLLOWED.map(({ name }) =>
      cycle.counts ? block.stability?.[name]?.ratio_to_third?.[counted(block).indexOf(cycle)] : null,
    );
  return {
    columns: [
      'device', ...ofBlock.columns, ...ofCycle.columns, 'reported', ...FOLLOWED.map(({ name }) => name + ' / cycle 3'),
    ],
    rows: among.flatMap((device) =>
      device.blocks.flatMap((block) =>
        block.cycles.map((cycle) => [
          device.name, ...ofBlock.cells(block), ...ofCycle.cells({ ...cycle, number: cycle.counts ? cycle.number : null }),
          isReported(device, block, cycle) ? 'yes' : 'no', ...ratios(block, cycle),
        ]),
      ),
    ),
  };
}
