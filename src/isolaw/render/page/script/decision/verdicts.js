import { element, shortList } from '../dom.js';
import { marker, roleTone } from '../icons.js';
import { lawName, withBadges } from '../laws.js';
import { laws, report } from '../report.js';
import { sentence } from '../text.js';

export const convergedFigure = {
  id: 'converged',
  width: 'wide',
  title: 'Without the optimiser\u2019s noise, and for an untested device',
  wanted: () => report.findings.converged.length > 0,
  build: () =>
    element(
      'ul',
      { class: 'sentences' },
      ...report.findings.converged.map((text) =>
        element('li', {}, ...(/\bfront\b/.test(text) ? withBadges(sentence(text)) : [sentence(text)])),
      ),
    ),
};

export const verdictsFigure = { id: 'verdicts', width: 'narrow', title: '', build: verdictList };

function verdictList() {
  const items = report.findings.verdicts.map((verdict) => {
    const law = laws[verdict.law];
    const tone = roleTone(verdict.role);
    const inOneLine = tone === 'poor' || tone === 'muted';
    const role = inOneLine ? ' ' : element('span', { class: 'role ' + tone }, verdict.role);
    return element(
      'li',
      { class: inOneLine ? 'brief' : null },
      marker(verdict.role),
      element('div', {}, lawName(law), role, inOneLine ? null : element('br'), sentence(verdict.sentence)),
    );
  });
  const care =
    report.findings.warnings.length === 0
      ? element(
          'p',
          { class: 'calm' },
          'Nothing stands out: no device was refused, no run failed, no parameter lies at its bound.',
        )
      : takeCare();
  return element('div', {}, element('ul', { class: 'verdicts' }, ...items), care);
}

export function takeCare() {
  const warnings = report.findings.warnings.map((warning) => element('li', {}, warning.sentence));
  return element('div', { class: 'warnings' }, element('h3', {}, 'Take care'), ...shortList(warnings, 5, 4));
}
