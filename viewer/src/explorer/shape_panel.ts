import type { Report, Shape } from '../model/report';
import { element, labelledControl } from '../ui/element';
import type { State, Store } from './state';

/** The controls for the training shape that is shown, and for the number of modes of its fit. */
export class ShapePanel {
  readonly root: HTMLElement;
  private readonly select: HTMLSelectElement;
  private readonly modes: HTMLInputElement;
  private readonly modesText = element('output');
  private readonly facts = element('dl', { class: 'facts' });

  constructor(
    private readonly report: Report,
    private readonly store: Store,
  ) {
    const { shapes, model } = report;
    this.select = element('select', {}, ...shapes.map((s, i) => element('option', { value: String(i) }, s.name)));
    this.select.addEventListener('change', () => store.update({ shape: Number(this.select.value) }));
    const step = (by: number, name: string, sign: string) =>
      element(
        'button',
        {
          type: 'button',
          class: 'step',
          aria: { label: name },
          onclick: () => store.update({ shape: (store.state.shape + by + shapes.length) % shapes.length }),
        },
        sign,
      );
    this.modes = element('input', { type: 'range', min: '0', max: String(model.modes), step: '1' });
    this.modes.addEventListener('input', () => store.update({ fitModes: Number(this.modes.value) }));
    const take = element(
      'button',
      { type: 'button', onclick: () => this.takeScores() },
      'Set the sliders to this shape',
    );
    const [shapeLabel] = labelledControl('Training shape', this.select);
    const [modesLabel] = labelledControl('Modes of the fit beside it', this.modes);
    this.root = element(
      'div',
      { class: 'shape-panel' },
      shapeLabel,
      element('div', { class: 'stepper' }, step(-1, 'Previous shape', '‹'), this.select, step(1, 'Next shape', '›')),
      modesLabel,
      element('div', { class: 'slider-row' }, this.modes, this.modesText),
      this.facts,
      element('div', { class: 'buttons' }, take),
    );
    store.subscribe((state, changed) => {
      if (changed.has('shape') || changed.has('fitModes')) this.follow(state);
    });
    this.follow(store.state);
  }

  private takeScores(): void {
    const { state } = this.store;
    const clamped = this.report.shapes[state.shape].scores.map((s) => Math.max(-3, Math.min(3, s)));
    this.store.update({ scores: clamped, tab: 'modes' });
  }

  private follow(state: State): void {
    const shape = this.report.shapes[state.shape];
    this.select.value = String(state.shape);
    this.modes.value = String(state.fitModes);
    this.modesText.textContent = `${state.fitModes} of ${this.report.model.modes}`;
    this.facts.replaceChildren(
      ...factsOf(shape).flatMap(([term, fact]) => [element('dt', {}, term), element('dd', {}, fact)]),
    );
  }
}

function factsOf(shape: Shape): [string, string][] {
  const facts: [string, string][] = [];
  if (shape.subject) facts.push(['Subject', shape.subject]);
  if (shape.is_reference) facts.push(['Role', 'the reference']);
  facts.push(
    [
      'Distance to the input',
      `${shape.mean_mm.toFixed(3)} mm mean, ${shape.p95_mm.toFixed(3)} mm p95, ${shape.hausdorff_mm.toFixed(2)} mm Hausdorff`,
    ],
    [
      'Flipped triangles',
      shape.plainFlips.length === 0
        ? 'none'
        : `${shape.plainFlips.length}, of these ${shape.confirmedFlips.length} confirmed`,
    ],
  );
  return facts;
}
