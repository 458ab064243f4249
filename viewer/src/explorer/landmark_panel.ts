import type { Report } from '../model/report';
import { element, labelledControl } from '../ui/element';
import { isScalar, type Shown } from './shown';
import type { State, Store } from './state';

/** The number and the values of the landmark that is chosen or under the pointer. */
export class LandmarkPanel {
  readonly root: HTMLElement;
  private readonly number: HTMLInputElement;
  private readonly text = element('p', { class: 'note' });

  constructor(report: Report, store: Store) {
    this.number = element('input', {
      type: 'number',
      min: '1',
      max: String(report.model.landmarks),
      step: '1',
      placeholder: 'none',
    });
    this.number.addEventListener('input', () => {
      const valid = this.number.value !== '' && this.number.checkValidity();
      store.update({ pinned: valid ? Number(this.number.value) - 1 : null });
    });
    const [label] = labelledControl('Landmark', this.number);
    this.root = element(
      'div',
      { class: 'landmark-panel' },
      element('div', { class: 'field' }, label, this.number),
      this.text,
    );
  }

  show(shown: Shown, state: State): void {
    const landmark = state.hovered ?? state.pinned;
    if (document.activeElement !== this.number) this.number.value = landmark === null ? '' : String(landmark + 1);
    if (landmark === null) {
      this.text.textContent =
        'Point at the surface or the torus to find the same place on the other; click to keep it.';
      return;
    }
    const { points, values } = shown.surfaces[0];
    const at = [0, 1, 2].map((c) => points[3 * landmark + c].toFixed(1)).join(', ');
    const value =
      values && isScalar(shown.colouring)
        ? ` ${values[landmark].toFixed(2)} mm: ${shown.scale!.label.replace(', mm', '')}.`
        : '';
    this.text.textContent = `At ${at} mm.${value}`;
  }
}
