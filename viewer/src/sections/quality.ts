import * as Plot from '@observablehq/plot';
import type { Chart, ReportData } from '../model/report_data';
import { element } from '../ui/element';
import { onWidth, paragraph, section } from '../ui/section';
import { tableElement } from '../ui/table';

const height = 230;
// Shifts the error bars of two curves so that they do not overlap.
const barShift = 4;

/** The curves of all measures over the number of modes, with those of the baseline if there is one. */
export function quality(data: ReportData): HTMLElement {
  const names = data.charts[0]?.series.map((s) => s.name) ?? [];
  const legend =
    names.length < 2
      ? []
      : [
          element(
            'ul',
            { class: 'series', aria: { label: 'Curves' } },
            ...names.map((name, i) => element('li', { class: `series-${i}` }, name)),
          ),
        ];
  const differences =
    data.differences.length === 0
      ? []
      : [
          ...data.remarks.map((text) => paragraph(text)),
          element(
            'details',
            {},
            element('summary', {}, 'This model minus the baseline'),
            element('div', { class: 'tables wide' }, ...data.differences.map((t) => tableElement(t))),
          ),
        ];
  return section(
    'quality',
    'How good it is',
    paragraph(
      'Distances are measured to the original surfaces. Bars are standard errors of the mean. Specificity alone ' +
        'rewards a model that lost variation: read it beside the total variance and the representation error.',
      'lead',
    ),
    ...legend,
    element('div', { class: 'charts' }, ...data.charts.map(chartElement)),
    ...differences,
    element(
      'details',
      {},
      element('summary', {}, 'The figures of these curves'),
      element('div', { class: 'tables' }, ...data.figures.map((t) => tableElement(t))),
    ),
  );
}

interface Point {
  name: string;
  x: number;
  y: number;
  error: number;
}

function pointsOf(series: Chart['series'][number]): Point[] {
  return series.x.map((x, i) => ({ name: series.name, x, y: series.y[i], error: series.error[i] ?? 0 }));
}

function chartElement(chart: Chart): HTMLElement {
  const place = element('div', { class: 'plot' });
  onWidth(place, (width) => place.replaceChildren(plotOf(chart, width)));
  return element('figure', { class: 'chart' }, element('figcaption', {}, chart.title), place);
}

const mostTicks = 13;

function wholeTicks(most: number): number[] {
  const step = Math.ceil(most / mostTicks);
  return Array.from({ length: Math.floor(most / step) }, (_, i) => (i + 1) * step);
}

function plotOf(chart: Chart, width: number) {
  const series = chart.series.map(pointsOf);
  const all = series.flat();
  const low = Math.min(...all.map((p) => p.y - p.error)),
    high = Math.max(...all.map((p) => p.y + p.error));
  const most = Math.max(...all.map((p) => p.x));
  return Plot.plot({
    width,
    height,
    marginLeft: 50,
    marginBottom: 42,
    marginTop: 26,
    marginRight: 14,
    style: { fontSize: '12px' },
    insetLeft: 8,
    insetRight: 8,
    ariaLabel: `${chart.title}: ${chart.y_label} against ${chart.x_label}`,
    x: {
      label: chart.x_label,
      labelAnchor: 'center',
      labelArrow: 'none',
      ticks: wholeTicks(most),
      tickFormat: 'd',
      line: true,
    },
    y: {
      label: chart.y_label,
      labelAnchor: 'top',
      labelArrow: 'none',
      grid: true,
      ticks: 5,
      zero: low < high / 3,
      nice: true,
    },
    marks: [
      ...series.flatMap((points, i) => {
        const stroke = `var(--series-${i % 2})`,
          dx = (i - (series.length - 1) / 2) * barShift;
        return [
          Plot.ruleX(
            points.filter((p) => p.error > 0),
            { x: 'x', y1: (p: Point) => p.y - p.error, y2: (p: Point) => p.y + p.error, stroke, strokeWidth: 1.25, dx },
          ),
          Plot.lineY(points, { x: 'x', y: 'y', stroke, strokeWidth: 1.75, dx }),
          Plot.dot(points, { x: 'x', y: 'y', fill: stroke, r: 3, dx }),
        ];
      }),
      Plot.tip(
        all,
        Plot.pointer({
          x: 'x',
          y: 'y',
          title: (p: Point) =>
            `${p.name}\n${p.x} ${p.x === 1 ? 'mode' : 'modes'}: ${p.y.toFixed(3)}${p.error > 0 ? ` ± ${p.error.toFixed(3)}` : ''}`,
        }),
      ),
    ],
  });
}
