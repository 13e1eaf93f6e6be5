import { predictionNote } from '../laws.js';
import { lawsByObjective, report, resultColumns } from '../report.js';
import { plain } from '../text.js';
import { hasFront } from '../views.js';

export const objectiveBarsFigure = {
  id: 'objective-bars',
  width: 'wide',
  title: 'Mean objective per law',
  wanted: () => !hasFront && lawsByObjective.length > 0,
  caption: () =>
    'Shorter is more accurate. Accuracy alone decides here, because the robustness index is undefined: ' +
    report.findings.beta_note + '.' + predictionNote(lawsByObjective),
  csv: () => {
    const { columns, cells } = resultColumns('laws', ['id', 'objective']);
    return { columns, rows: lawsByObjective.map(cells) };
  },
  height: () => 90 + 38 * lawsByObjective.length,
  draw: (look) => {
    const shown = [...lawsByObjective].reverse();
    return {
      traces: [
        {
          type: 'bar',
          orientation: 'h',
          y: shown.map((law) => plain(law.id)),
          x: shown.map((law) => law.objective.mean),
          marker: { color: shown.map((law) => look.law(law)) },
          width: 0.6,
          error_x: {
            type: 'data', array: shown.map((law) => law.objective.std ?? 0), color: look.colour('ink'), thickness: 1.2,
            width: 4,
          },
          hovertemplate: '<b>%{y}</b><br>mean OF %{x:.4f}<extra></extra>',
        },
      ],
      layout: {
        xaxis: { title: 'mean objective OF [-]', rangemode: 'tozero' },
        yaxis: { showgrid: false, type: 'category' },
      },
    };
  },
};
