import { chosen } from '../choice.js';
import { curve, devices } from '../report.js';
import { rawIndex } from '../raw.js';
import { MM, hovered } from '../units.js';

export const orbitFigure = {
  id: 'orbit',
  width: 'narrow',
  title: 'Orbit in the plane',
  depends: ['tested'],
  wanted: () => devices.some((device) => device.raw?.second_disp_mm),
  caption: () =>
    devices[chosen.tested].raw.second_disp_mm
      ? 'The displacement across against the displacement that was read. The properties are of the one direction alone.'
      : 'This record holds one direction.',
  csv: orbitData,
  height: (width) => Math.min(width, 470),
  draw: drawOrbit,
};

function orbitData() {
  const { raw } = devices[chosen.tested];
  const across = curve(raw.second_disp_mm) ?? [];
  return {
    columns: ['sample', 'displacement [' + MM + ']', 'second displacement [' + MM + ']'],
    rows: curve(raw.disp_mm).map((value, k) => [rawIndex(raw, k), value, across[k]]),
  };
}

function drawOrbit(look) {
  const { raw } = devices[chosen.tested];
  return {
    traces: [
      {
        mode: 'lines', x: curve(raw.disp_mm), y: curve(raw.second_disp_mm) ?? [],
        line: { color: look.colour('measured'), width: 1.3 },
        hovertemplate: hovered('x', 'mm', 1) + ', ' + hovered('y', 'mm', 1) + '<extra></extra>',
      },
    ],
    layout: {
      xaxis: { title: 'displacement [' + MM + ']' },
      yaxis: { title: 'second direction [' + MM + ']', scaleanchor: 'x' },
    },
  };
}
