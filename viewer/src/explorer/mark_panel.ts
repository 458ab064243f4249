import type { Report } from '../model/report';
import { element } from '../ui/element';
import type { Store } from './state';

/** The colours of the marks and their scatter. A mark that is chosen here is drawn alone. */
export class MarkPanel {
  readonly root: HTMLElement;

  constructor(report: Report, store: Store) {
    const buttons = report.marks.map((mark, i) => {
      const swatch = element('i', { class: 'swatch' });
      swatch.style.background = mark.colour;
      return element(
        'button',
        {
          type: 'button',
          class: 'mark-choice',
          aria: { pressed: 'false' },
          onclick: () => store.update({ onlyMark: store.state.onlyMark === i ? null : i }),
        },
        swatch,
        element('span', {}, mark.name),
        element('span', { class: 'mark-scatter' }, mark.scatter.toFixed(2)),
      );
    });
    this.root = element(
      'div',
      { class: 'mark-panel' },
      element('p', { class: 'note' }, 'Scatter of each mark on the mean, mm; choose a mark to see it alone.'),
      element('div', { class: 'mark-choices', role: 'group', aria: { label: 'Marks and their scatter' } }, ...buttons),
    );
    const follow = () => {
      this.root.hidden = report.marks.length === 0 || !store.state.marks;
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(store.state.onlyMark === i)));
    };
    store.subscribe((_, changed) => {
      if (changed.has('marks') || changed.has('onlyMark')) follow();
    });
    follow();
  }
}
