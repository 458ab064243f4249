import { element } from '../ui/element';

interface TabPage<Key extends string> {
  key: Key;
  title: string;
  body: HTMLElement;
}

/** A row of tabs and their pages. Arrow keys change the tab. `follow` is given a listener for tabs chosen elsewhere. */
export function tabs<Key extends string>(
  pages: TabPage<Key>[],
  chosen: (key: Key) => void,
  follow: (listen: (key: Key) => void) => void,
): HTMLElement[] {
  const buttons = pages.map(({ key, title }) =>
    element(
      'button',
      { type: 'button', id: `tab-${key}`, role: 'tab', aria: { controls: `page-${key}` }, onclick: () => chosen(key) },
      title,
    ),
  );
  const bodies = pages.map(({ key, body }) =>
    element('div', { id: `page-${key}`, role: 'tabpanel', aria: { labelledby: `tab-${key}` } }, body),
  );
  const select = (key: Key) =>
    pages.forEach((page, i) => {
      const isChosen = page.key === key;
      buttons[i].setAttribute('aria-selected', String(isChosen));
      buttons[i].tabIndex = isChosen ? 0 : -1;
      bodies[i].hidden = !isChosen;
    });
  const list = element('div', { class: 'tabs', role: 'tablist' }, ...buttons);
  list.addEventListener('keydown', (e) => {
    const step = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const next = (buttons.findIndex((b) => b.tabIndex === 0) + step + pages.length) % pages.length;
    buttons[next].focus();
    chosen(pages[next].key);
  });
  follow(select);
  select(pages[0].key);
  return [list, ...bodies];
}
