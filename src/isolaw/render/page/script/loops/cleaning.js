import { chosen } from '../choice.js';
import { rawIndex, rawTime } from '../raw.js';
import { curve, devices, drawable } from '../report.js';
import { sentence } from '../text.js';
import { record } from './fits.js';
import { MM, hovered } from '../units.js';

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

function series() {
  const device = devices[chosen.device],
    axis = rawTime(device),
    { t, x } = record(device),
    raw = curve(device.raw.disp_mm);
  return { axis, recorded: { x: raw.map((_, k) => axis.of(rawIndex(device.raw, k))), y: raw }, cleaned: { x: t, y: x } };
}

function cleaningData() {
  const { axis, recorded, cleaned } = series();
  const rows = (name, { x, y }) => y.map((value, k) => [name, x[k], value]);
  return {
    columns: ['series', axis.timed ? 'time [s]' : 'sample', 'displacement [' + MM + ']'],
    rows: [...rows('as recorded', recorded), ...rows('after cleaning', cleaned)],
  };
}

function drawCleaning(look) {
  const { axis, recorded, cleaned } = series();
  const hover = (axis.timed ? '%{x:.3f} s, ' : 'sample %{x}, ') + hovered('y', 'mm', 2);
  return {
    traces: [
      {
        name: 'as recorded', mode: 'lines', ...recorded,
        line: { color: look.colour('measured'), width: 3 }, opacity: 0.7,
        hovertemplate: hover + '<extra>as recorded</extra>',
      },
      {
        name: 'after cleaning', mode: 'lines', ...cleaned,
        line: { color: look.colour('accent'), width: 1.2 }, hovertemplate: hover + '<extra>after cleaning</extra>',
      },
    ],
    layout: { showlegend: true, xaxis: { title: axis.title, zeroline: false }, yaxis: { title: 'displacement [' + MM + ']' } },
  };
}
