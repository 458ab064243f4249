type Properties<K extends keyof HTMLElementTagNameMap> = Partial<
  Omit<HTMLElementTagNameMap[K], 'style' | 'dataset' | 'role'>
> & {
  class?: string;
  role?: string;
  aria?: Record<string, string>;
  data?: Record<string, string>;
};

/** Makes an HTML element with properties and children. Text is never interpreted as markup. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties<K> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const { class: className, role, aria, data, ...rest } = properties;
  const made = document.createElement(tag);
  Object.assign(made, rest);
  if (className) made.className = className;
  if (role) made.setAttribute('role', role);
  for (const [name, value] of Object.entries(aria ?? {})) made.setAttribute(`aria-${name}`, value);
  Object.assign(made.dataset, data);
  made.append(...children);
  return made;
}

let labelled = 0;

/** A control with its associated label. */
export function labelledControl(text: string, control: HTMLElement): [HTMLLabelElement, HTMLElement] {
  control.id ||= `control-${++labelled}`;
  return [element('label', { htmlFor: control.id }, text), control];
}
