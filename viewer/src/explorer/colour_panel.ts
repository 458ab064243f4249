import type { Report } from '../model/report';
import { element, labelledControl } from '../ui/element';
import type { Colouring, State, Store, Tab } from './state';

const choices: Record<Tab, [Colouring, string][]> = {
  modes: [
    ['strength', 'Strength of one mode'],
    ['displacement', 'Displacement from the mean'],
    ['torus', 'Place on the torus'],
    ['checkerboard', 'Checkerboard of the torus'],
    ['plain', 'Plain bone'],
  ],
  shapes: [
    ['error', 'Distance to the input surface'],
    ['fit', 'Distance to the fit'],
    ['displacement', 'Displacement from the mean'],
    ['torus', 'Place on the torus'],
    ['checkerboard', 'Checkerboard of the torus'],
    ['plain', 'Plain bone'],
  ],
};

/** The controls for the meaning of the colours, and for what else is drawn. */
export class ColourPanel {
  readonly root: HTMLElement;
  private readonly select = element('select');
  private readonly mode: HTMLSelectElement;
  private readonly modeRow: HTMLElement;

  constructor(report: Report, store: Store) {
    this.mode = element(
      'select',
      {},
      ...report.model.varianceShares.map((_, m) => element('option', { value: String(m) }, `Mode ${m + 1}`)),
    );
    const [colourLabel] = labelledControl('Colours', this.select);
    const [modeLabel] = labelledControl('Mode', this.mode);
    this.modeRow = element('div', { class: 'field' }, modeLabel, this.mode);
    this.select.addEventListener('change', () => {
      const { tab, colouring } = store.state;
      store.update({ colouring: { ...colouring, [tab]: this.select.value as Colouring } });
    });
    this.mode.addEventListener('change', () => store.update({ strengthMode: Number(this.mode.value) }));
    const box = (key: 'loops' | 'edges' | 'flips' | 'marks', text: string) => {
      const input = element('input', { type: 'checkbox', checked: store.state[key] });
      input.addEventListener('change', () => store.update({ [key]: input.checked }));
      return element('label', { class: 'check' }, input, text);
    };
    this.root = element(
      'div',
      { class: 'colour-panel' },
      element('div', { class: 'field' }, colourLabel, this.select),
      this.modeRow,
      element(
        'div',
        { class: 'checks', role: 'group', aria: { label: 'Drawn with the surface' } },
        box('loops', 'Loops'),
        box('edges', 'Triangles'),
        box('flips', 'Flipped triangles'),
        ...(report.marks.length > 0 ? [box('marks', 'Marks')] : []),
      ),
    );
    store.subscribe((state, changed) => {
      if (changed.has('tab') || changed.has('colouring') || changed.has('strengthMode')) this.follow(state);
    });
    this.follow(store.state);
  }

  private follow({ tab, colouring, strengthMode }: State): void {
    if (this.select.dataset.tab !== tab) {
      this.select.dataset.tab = tab;
      this.select.replaceChildren(...choices[tab].map(([value, text]) => element('option', { value }, text)));
    }
    this.select.value = colouring[tab];
    this.modeRow.hidden = colouring[tab] !== 'strength';
    this.mode.value = String(strengthMode);
  }
}
