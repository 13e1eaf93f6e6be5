import { chosen } from '../choice.js';
import { rawIndex, rawTime } from '../raw.js';
import { curve, devices, drawable } from '../report.js';
import { sentence } from '../text.js';
import { record } from './fits.js';

export const cleaningFigure = {
  id: 'cleaning',
  title: 'Displacement over time, as recorded and after cleaning',
  depends: ['device'],
  wanted: () => drawable.some((device) => device.raw?.samples > 0),
  caption: cleaningCaption,
  csv: cleaningData,
  height: () => 300,
  draw: drawCleaning,
};

function cleaningCaption() {
  const device = devices[chosen.device];
  return (
    device.name + ': ' + device.raw.samples + ' samples as recorded, ' + device.record.samples + ' after cleaning. ' +
    (device.cleaning.length > 0 ? 'Changes: ' + sentence(device.cleaning.join('; ')) + '.' : 'Nothing was changed.')
  );
}

function cleaningData() {
  const device = devices[chosen.device],
    axis = rawTime(device),
    measured = record(device),
    raw = curve(device.raw.disp_mm);
  return {
    columns: ['series', axis.timed ? 'time [s]' : 'sample', 'displacement [mm]'],
    rows: [
      ...raw.map((x, k) => ['as recorded', axis.of(rawIndex(device.raw, k)), x]),
      ...measured.x.map((x, k) => ['after cleaning', measured.t[k], x]),
    ],
  };
}

function drawCleaning(look) {
  const device = devices[chosen.device],
    axis = rawTime(device),
    measured = record(device),
    raw = curve(device.raw.disp_mm);
  const hover = axis.timed ? '%{x:.3f} s, %{y:.2f} mm' : 'sample %{x}, %{y:.2f} mm';
  return {
    traces: [
      {
        name: 'as recorded', mode: 'lines', x: raw.map((_, k) => axis.of(rawIndex(device.raw, k))), y: raw,
        line: { color: look.colour('measured'), width: 3 }, opacity: 0.7,
        hovertemplate: hover + '<extra>as recorded</extra>',
      },
      {
        name: 'after cleaning', mode: 'lines', x: measured.t, y: measured.x,
        line: { color: look.colour('accent'), width: 1.2 }, hovertemplate: hover + '<extra>after cleaning</extra>',
      },
    ],
    layout: { showlegend: true, xaxis: { title: axis.title, zeroline: false }, yaxis: { title: 'displacement [mm]' } },
  };
}
