import * as Plot from '@observablehq/plot';
import type { Report, Shape } from '../model/report';
import { element, labelledControl } from '../ui/element';
import { placeLabels } from '../ui/labels';
import { onWidth, paragraph } from '../ui/section';

const mostNamed = 60;
const margin = 46;
const letterPixels = 6.6;
const rings = [1, 2, 3];
const widest = 560;

/** A plot of the training shapes by their scores on two modes, with names. A click shows the shape. */
export function scoresPlot(report: Report, showShape: (shape: number) => void): HTMLElement {
  const { model, shapes } = report;
  const select = (chosen: number) =>
    element(
      'select',
      {},
      ...model.varianceShares.map((share, m) =>
        element(
          'option',
          { value: String(m), selected: m === chosen },
          `Mode ${m + 1} (${(100 * share).toFixed(0)} %)`,
        ),
      ),
    );
  const across = select(0),
    upward = select(Math.min(1, model.modes - 1));
  const place = element('div', { class: 'plot scatter' });
  let width = 0;
  const draw = () => {
    if (width === 0) return;
    const plot = scatter(shapes, Number(across.value), Number(upward.value), Math.min(width, widest));
    plot.addEventListener('click', () => {
      const shape = (plot as unknown as { value: Shape | null }).value;
      if (shape) showShape(shapes.indexOf(shape));
    });
    place.replaceChildren(plot);
  };
  onWidth(place, (now) => {
    width = now;
    draw();
  });
  for (const control of [across, upward]) control.addEventListener('change', draw);
  const legend =
    'Scores on two modes. The rings are 1, 2 and 3 standard deviations; a click on a point shows its shape.';
  return element(
    'figure',
    { class: 'chart' },
    element('figcaption', {}, 'Where they lie'),
    paragraph(legend, 'note'),
    element('div', { class: 'axes' }, ...labelledControl('Across', across), ...labelledControl('Upward', upward)),
    place,
  );
}

function scatter(shapes: Shape[], across: number, upward: number, width: number) {
  const x = (s: Shape) => s.scores[across],
    y = (s: Shape) => s.scores[upward];
  const reach = Math.max(3.2, ...shapes.flatMap((s) => [Math.abs(x(s)), Math.abs(y(s))])) * 1.05;
  const circle = (radius: number) =>
    Array.from({ length: 121 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 120;
      return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
    });
  const subjects = [...new Set(shapes.map((s) => s.subject ?? ''))];
  const colour = (s: Shape) =>
    subjects.length > 1 && subjects.length <= 8
      ? `var(--subject-${subjects.indexOf(s.subject ?? '')})`
      : 'var(--series-0)';
  const pixels = (width - 2 * margin) / (2 * reach);
  const places = placeLabels(
    shapes.map((s) => ({ x: x(s) * pixels, y: -y(s) * pixels, width: s.name.length * letterPixels })),
  );
  const named = shapes.length > mostNamed ? [] : shapes.map((shape, i) => ({ shape, place: places[i] }));
  return Plot.plot({
    width,
    height: width,
    margin,
    style: { fontSize: '12px' },
    ariaLabel: `Scores of the training shapes on modes ${across + 1} and ${upward + 1}`,
    x: {
      domain: [-reach, reach],
      label: `mode ${across + 1}, sd`,
      labelAnchor: 'center',
      labelArrow: 'none',
      ticks: 7,
    },
    y: {
      domain: [-reach, reach],
      label: `mode ${upward + 1}, sd`,
      labelAnchor: 'center',
      labelArrow: 'none',
      ticks: 7,
    },
    marks: [
      Plot.ruleX([0], { stroke: 'var(--line)' }),
      Plot.ruleY([0], { stroke: 'var(--line)' }),
      ...rings.map((radius) => Plot.line(circle(radius), { x: 'x', y: 'y', stroke: 'var(--line)', strokeWidth: 1 })),
      Plot.dot(shapes, { x, y, fill: colour, r: 4.5 }),
      ...named.map(({ shape, place }) =>
        Plot.text([shape], {
          x,
          y,
          text: 'name',
          ...place,
          fill: 'currentColor',
          stroke: 'var(--page)',
          strokeWidth: 3,
        }),
      ),
      Plot.tip(
        shapes,
        Plot.pointer({ x, y, title: (s: Shape) => `${s.name}\n${x(s).toFixed(2)}, ${y(s).toFixed(2)} sd` }),
      ),
    ],
  });
}
