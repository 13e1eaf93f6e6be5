import { noCycles } from '../cycles.js';
import { element, onScreen, strong } from '../dom.js';
import { devices } from '../report.js';
import { table } from '../tables.js';
import { DASH, deviation, isNumber, limitText, withUnit } from '../text.js';
import { assessmentData, verdictBadge } from '../verdicts.js';

export const verdictTableFigure = {
  id: 'verdict-table',
  title: 'Verdicts, device by device',
  long: true,
  wanted: () => devices.some((device) => device.assessments.length > 0),
  caption: () =>
    'Devices outside a limit come first. Below each verdict: the deviation from the design value, or the value.' +
    onScreen(' Choose a device above for clauses, formulas and reasons.'),
  csv: () => assessmentData(devices),
  build: verdictTable,
};

function verdictTable() {
  const key = (a) => a.quantity + '\n' + (a.limit || '');
  const quantities = [...new Map(devices.flatMap((d) => d.assessments).map((a) => [key(a), a])).entries()];
  const columns = [
    { title: 'Device', pinned: true },
    ...quantities.map(([, a]) => ({
      title: a.quantity,
      unit: a.limit ? limitText(a.limit) : 'no limit',
      full: a.clause || null,
    })),
  ];
  const failing = (device) => device.assessments.some((a) => a.verdict === 'fail');
  const rows = [...devices.filter(failing), ...devices.filter((device) => !failing(device))].map((device) => {
    const own = new Map(device.assessments.map((a) => [key(a), a]));
    const name = strong(device.name);
    if (own.size === 0) {
      const why = device.status !== 'ok' ? 'refused: ' + device.message : noCycles(device);
      return { cells: [name, element('td', { class: 'note text', colspan: quantities.length }, why)] };
    }
    return {
      cells: [
        name,
        ...quantities.map(([id]) => {
          const a = own.get(id);
          if (!a) return element('td', { class: 'note' }, DASH);
          const number = isNumber(a.deviation_percent)
            ? deviation(a.deviation_percent)
            : isNumber(a.value)
              ? withUnit(a.value, a.unit, 3)
              : null;
          return element(
            'td',
            { class: 'judged', title: a.reason || null },
            verdictBadge(a.verdict),
            number === null ? null : element('small', {}, number),
          );
        }),
      ],
    };
  });
  return table(columns, rows, 'Verdicts, device by device');
}
