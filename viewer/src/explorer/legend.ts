import { element } from '../ui/element';
import { flipColour, ramp } from './ramp';
import type { Shown } from './shown';
import type { State } from './state';

/** The legend, which explains the colours on the surface. */
export class Legend {
  readonly root = element('div', { class: 'legend' });

  show(shown: Shown, state: State): void {
    const told = JSON.stringify([shown.colouring, shown.scale, state.flips, shown.surfaces[0].flipped.length]);
    if (this.root.dataset.told === told) return;
    this.root.dataset.told = told;
    const flipped = state.flips ? shown.surfaces[0].flipped.length : 0;
    const parts = shown.scale ? scaleParts(shown.scale.label, shown.scale.end) : torusParts(shown);
    if (flipped > 0) {
      const swatch = element('i', { class: 'swatch' });
      swatch.style.background = flipColour;
      parts.push(
        element('p', { class: 'legend-note' }, swatch, `${flipped} flipped triangle${flipped === 1 ? '' : 's'}`),
      );
    }
    this.root.replaceChildren(...parts);
  }
}

function scaleParts(label: string, end: number): HTMLElement[] {
  const bar = element('div', { class: 'legend-bar' });
  bar.style.background = `linear-gradient(to right, ${ramp.join(', ')})`;
  const steps = evenSteps(end);
  const digits = Math.max(0, 1 - Math.floor(Math.log10(end / steps)));
  const ticks = Array.from({ length: steps + 1 }, (_, i) =>
    element('span', {}, String(Number(((i * end) / steps).toFixed(digits)))),
  );
  return [element('p', { class: 'legend-label' }, label), bar, element('div', { class: 'legend-ticks' }, ...ticks)];
}

// The number of parts into which a round number is divided so that the ticks are round as well.
function evenSteps(end: number): number {
  const first = Math.round(10 * (end / 10 ** Math.floor(Math.log10(end)))) / 10;
  return [1, 2, 4, 8].includes(first) ? 4 : [1.5, 3, 6].includes(first) ? 3 : 5;
}

function torusParts(shown: Shown): HTMLElement[] {
  if (shown.colouring === 'plain') return [];
  return [element('p', { class: 'legend-label' }, 'The same colour is the same place on the torus, on every shape')];
}
