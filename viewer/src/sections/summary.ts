import type { ReportData } from '../model/report_data';
import { element } from '../ui/element';
import { paragraph, section } from '../ui/section';
import { tableElement } from '../ui/table';

/** The summary in plain words, the main results, and the inputs that were left out, with the reasons. */
export function summary(data: ReportData): HTMLElement {
  const statements = data.plain_words.map(({ heading, text }) =>
    element('div', { class: 'statement' }, element('h3', {}, heading), paragraph(text)),
  );
  const leftOut =
    data.left_out.rows.length === 0
      ? [element('h3', {}, 'Left out'), paragraph('Nothing was left out: every input is in the model.')]
      : [tableElement(data.left_out)];
  const repaired = data.repaired.rows.length === 0 ? [] : [tableElement(data.repaired)];
  const failures = data.refit_failures.rows.length === 0 ? [] : [tableElement(data.refit_failures)];
  return section(
    'summary',
    'In plain words',
    element('div', { class: 'statements' }, ...statements),
    ...leftOut,
    ...repaired,
    ...failures,
    element(
      'details',
      {},
      element('summary', {}, 'The figures of the run'),
      element('ul', { class: 'findings' }, ...data.findings.map((text) => element('li', {}, text))),
    ),
  );
}
