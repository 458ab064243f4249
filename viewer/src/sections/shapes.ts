import type { Report } from '../model/report';
import { element } from '../ui/element';
import { section } from '../ui/section';
import { tableElement } from '../ui/table';
import { scoresPlot } from './scores_plot';

/** The scores and the representation errors of the training shapes. A click on a name or point shows the shape. */
export function shapes(report: Report, showShape: (shape: number) => void): HTMLElement {
  const link = (name: string) => {
    const shape = report.shapes.findIndex((s) => s.name === name);
    return element(
      'button',
      { type: 'button', class: 'link', title: 'Show this shape', onclick: () => showShape(shape) },
      name,
    );
  };
  const scores = tableElement({
    title: 'Scores, in standard deviations',
    note: '',
    header: ['shape', ...report.model.varianceShares.map((_, m) => `mode ${m + 1}`)],
    rows: report.shapes.map((s) => [s.name, ...s.scores.map((score) => score.toFixed(2).replace('-', '−'))]),
  });
  return section(
    'shapes',
    'The training shapes',
    element('div', { class: 'side-by-side' }, scoresPlot(report, showShape), scores),
    tableElement(report.data.shapes_table, link),
  );
}
