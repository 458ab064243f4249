import './style/page.css';
import './style/explorer.css';
import './style/sections.css';
import './style/print.css';
import { Explorer } from './explorer/explorer';
import { Report } from './model/report';
import { parseReportData } from './model/report_data';
import { provenance } from './sections/provenance';
import { quality } from './sections/quality';
import { shapes } from './sections/shapes';
import { summary } from './sections/summary';
import { element } from './ui/element';
import { openDetailsInPrint } from './ui/print';

function explorerOf(report: Report): Explorer | null {
  try {
    return new Explorer(report, (sharp) => (document.documentElement.dataset.drawn = sharp ? 'sharp' : 'in-motion'));
  } catch (error) {
    console.warn(error);
    return null;
  }
}

function header(report: Report): HTMLElement {
  const links = [
    ['model', 'Model'],
    ['summary', 'In plain words'],
    ['quality', 'Quality'],
    ['shapes', 'Training shapes'],
    ['provenance', 'How it was made'],
  ];
  return element(
    'header',
    { class: 'page-header' },
    element('div', {}, element('h1', {}, report.data.title), element('p', { class: 'subtitle' }, report.data.subtitle)),
    element(
      'nav',
      { aria: { label: 'Parts of the page' } },
      ...links.map(([id, text]) => element('a', { href: `#${id}` }, text)),
    ),
  );
}

function build(text: string): void {
  const report = new Report(parseReportData(text));
  document.title = `${report.data.title}: ${report.data.subtitle}`;
  const explorer = explorerOf(report);
  const showShape = (shape: number) => explorer?.showShape(shape);
  const noView = element(
    'p',
    { class: 'warning', id: 'model' },
    'The model cannot be shown in motion: this browser has no WebGL, or it is switched off. All else is below.',
  );
  document.body.append(
    header(report),
    element(
      'main',
      {},
      explorer?.root ?? noView,
      summary(report.data),
      quality(report.data),
      shapes(report, showShape),
      provenance(report.data, text.length),
    ),
  );
  openDetailsInPrint();
}

const data = document.getElementById('report-data')!.textContent!;
try {
  build(data);
} catch (error) {
  document.body.append(
    element(
      'p',
      { class: 'warning', role: 'alert' },
      `This report cannot be shown: ${error instanceof Error ? error.message : String(error)}`,
    ),
  );
  throw error;
}
