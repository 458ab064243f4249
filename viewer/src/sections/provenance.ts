import type { ReportData } from '../model/report_data';
import { element } from '../ui/element';
import { paragraph, section } from '../ui/section';
import { tableElement } from '../ui/table';

/** The origin of the model: program, command, options, inputs and papers. */
export function provenance(data: ReportData, dataBytes: number): HTMLElement {
  const papers = data.papers.rows.map(([citation, usedFor]) =>
    element('li', {}, citation, element('small', {}, usedFor)),
  );
  return section(
    'provenance',
    'How it was made',
    element('pre', { class: 'command' }, data.made_by),
    element('h3', {}, 'Papers it rests on'),
    element('ul', { class: 'papers' }, ...papers),
    element(
      'details',
      {},
      element('summary', {}, `${data.inputs.rows.length} input files, with their checksums`),
      tableElement(data.inputs),
    ),
    element('details', {}, element('summary', {}, 'All options'), tableElement(data.options)),
    paragraph(
      `The interactive page of foramen ${data.foramen}. It holds ${(dataBytes / 1e6).toFixed(1)} MB of data (format ${data.format_version}) ` +
        'and loads nothing from elsewhere.',
      'note',
    ),
  );
}
