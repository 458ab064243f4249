import { element } from './element';

/** A section of the page with a title. */
export function section(id: string, title: string, ...children: (Node | string)[]): HTMLElement {
  return element(
    'section',
    { id, aria: { labelledby: `${id}-title` } },
    element('h2', { id: `${id}-title` }, title),
    ...children,
  );
}

export function paragraph(text: string, className = ''): HTMLElement {
  return element('p', { class: className }, text);
}

/** Calls `draw` with the width of the element, now and after every change of the width. */
export function onWidth(target: HTMLElement, draw: (width: number) => void): void {
  let last = 0;
  new ResizeObserver(() => {
    const width = Math.round(target.clientWidth);
    if (width === last || width === 0) return;
    last = width;
    draw(width);
  }).observe(target);
}
